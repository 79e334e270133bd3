#pragma once

#include <cdr/render/geometry/facet_solid.h>
#include <cdr/scene/camera.h>
#include <cdr/scene/scene.h>
#include <cdr/shaders/shared.h>

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace cdr::render {

/// What a surface makes of light.
enum class Reflection : std::uint8_t {
    matt,
    unlit ///< it shows its base colour in any light
};

/// What facets that are lit while they are drawn are told of their light, in float64: all that does not change across a
/// facet. The model is that of matt surfaces in shaders/shading/lighting.glsl.
class FacetLight {
  public:
    /// @param scene has at most shaders::kPushedLights lights, none with a cone or a range.
    FacetLight(const scene::Scene& scene, const scene::Camera& camera);

    /// Colours per vertex. First the ambient light that the facet reflects. Then for each of litBy() the product of its
    /// colour, the albedo and the light's height over the facet's plane, in scene units.
    static std::size_t strideOf(const scene::Scene& scene) { return 1 + litBy(scene); }
    std::size_t stride() const { return 1 + std::max<std::size_t>(m_lights.size(), 1); }
    /// How many lights shaders are told of: 1 or more, since without any there is a black one.
    static std::size_t litBy(const scene::Scene& scene) {
        return std::max<std::size_t>(scene.lights.size(), 1);
    }

    /// What a facet of the next draws is made of.
    void turn(std::size_t facet, const glm::vec3& baseColor, Reflection reflection);
    /// Lights a facet of one draw.
    /// @param normal world space, unit. @param height of the facet's plane over `origin`.
    /// @param origin of the draw, world space. @param into stride() colours.
    void write(std::size_t facet, const glm::dvec3& normal, double height, const glm::dvec3& origin,
               glm::vec3* into) const;

  private:
    std::vector<scene::PointLight> m_lights; ///< broughtNear()
    glm::vec3 m_ambientLight;
    std::array<glm::vec3, kMaxSolidParts> m_ambient{};
    std::array<glm::vec3, kMaxSolidParts> m_albedo{}; ///< 0 of unlit facets
};

/// The lights of a scene as the draws of a cascade are pushed them (shaders::kPushedLightsOffset).
std::array<glm::vec4, shaders::kPushedLights> pushedLights(const scene::Scene& scene,
                                                           const scene::Camera& camera, double anchorView);

} // namespace cdr::render
