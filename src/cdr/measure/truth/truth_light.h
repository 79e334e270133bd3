#pragma once

#include <cdr/image/image.h>
#include <cdr/measure/truth/surface_hit.h>
#include <cdr/scene/camera.h>
#include <cdr/scene/scene.h>

#include <glm/glm.hpp>

#include <optional>

namespace cdr::measure {

/// What is lit.
struct LitSurface {
    glm::dvec3 baseColor;                                      ///< linear
    std::optional<scene::MetallicRoughness> metallicRoughness; ///< empty for matt
    glm::dvec3 fromCamera;                ///< the point less the camera's position, world axes
    glm::dvec3 normal;                    ///< unit, world axes
    double openness = 1.0;                ///< share of ambient light that arrives
    std::optional<glm::dvec3> emission{}; ///< SurfaceHit::emission
    glm::dvec4 reached{1.0};              ///< the shares of scene::shadowLights() that no shadow takes
};

/// Light that a surface sends to the camera, linear, in float64. Ambient and point light are by the formulas of the shading
/// pass. Light of a sky is not: it is summed over directions, where the pass has fits to such sums.
glm::dvec3 lightFrom(const scene::Scene& scene, const scene::Camera& camera, const LitSurface& surface);

/// The same for a surface that a ray meets. An unlit one sends its base colour and its emission.
/// @param fromCamera the point less the camera's position, world axes. @param reached as LitSurface.
glm::dvec3 lightFrom(const scene::Scene& scene, const scene::Camera& camera, const SurfaceHit& hit,
                     const glm::dvec3& fromCamera, const glm::dvec4& reached = glm::dvec4(1.0));

/// Linear light as sRGB, opaque.
image::Rgba8 encode(const glm::dvec3& linear);

} // namespace cdr::measure
