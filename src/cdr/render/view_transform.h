#pragma once

#include <cdr/render/draw_source.h>
#include <cdr/scene/frustum.h>
#include <cdr/scene/scene.h>
#include <cdr/shaders/shared.h>

#include <array>
#include <limits>

namespace cdr::render {

/// Turns instances into what one cascade's vertex shader wants. The camera's position, and the cascade's
/// anchor, are subtracted in float64; only the small remainder is rounded to float32.
class DrawRecordMaker {
  public:
    /// @param anchorView view distance of the cascade's anchor plane, 0 for mappings that are not anchored.
    DrawRecordMaker(const scene::Camera& camera, double anchorView);

    shaders::DrawRecord make(const DrawSource& source, const MaterialWords& material);

  private:
    void turn(const glm::mat3& basis);

    glm::dvec3 m_position, m_right, m_up, m_ahead;
    double m_anchorView;
    // Rows of (view * basis) for the last basis: crowds share one, and turning it costs more than all the
    // rest.
    glm::mat3 m_basis{std::numeric_limits<float>::quiet_NaN()};
    std::array<glm::vec3, 3> m_rows;
};

/// A light whose distance float32 can square: one that is too far away is moved towards the camera. It lights all that is much
/// nearer as before.
scene::PointLight broughtNear(const scene::PointLight& light, const scene::Camera& camera);

/// A light in view space, broughtNear(), each coordinate as a float and its rest.
shaders::LightRecord makeLightRecord(const scene::PointLight& anywhere, const scene::Camera& camera);

/// A direction of the world along the camera's axes: right, up, back.
glm::dvec3 directionInView(const scene::Camera& camera, const glm::dvec3& world);

/// A float64 as a float and the rest that the float left out.
glm::vec2 splitDouble(double value);

} // namespace cdr::render
