#pragma once

#include <cdr/measure/truth/object_ray.h>
#include <cdr/measure/truth/surface_point.h>
#include <cdr/measure/truth/truth_texture.h>
#include <cdr/measure/truth/visible_instances.h>
#include <cdr/scene/scene.h>

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace cdr::measure {

/// One surface that a ray meets, with all that its colour follows from.
struct SurfaceHit {
    double distanceView = 0.0;
    double layer = 0.0;         ///< scene::Material::layer
    std::uint32_t id = 0;       ///< object index + 1
    std::uint32_t instance = 0; ///< index in the scene
    bool isBlended = false;     ///< else it ends the ray
    bool isUnlit = false;
    bool isOnEdge = false;     ///< of its triangle, to the last bit
    glm::dvec3 facet{0.0};     ///< the triangle's own normal, world axes, unit, towards the camera
    glm::dvec3 normal{0.0};    ///< the one that is lit, world axes, unit, of the side that is seen
    glm::dvec4 baseColor{1.0}; ///< linear, straight alpha, texture and vertex colour included
    std::optional<scene::MetallicRoughness> metallicRoughness; ///< textures included
    double openness = 1.0;                                     ///< share of ambient light that arrives
    /// Linear, what the surface sends by itself. With one, though it be black, all that the surface sends is cut off at
    /// kBrightest. Empty where the material has none: what a matt surface sends is then not cut off.
    std::optional<glm::dvec3> emission{};
};

/// Appends every visible hit of a pixel's ray on one instance within `range`, in no order. Backs of single-sided
/// materials and what a mask cuts away are not visible. An edge that triangles share is met once. Tries each
/// triangle, so meant for small meshes.
/// @param visible of `scene`. @param textures of `scene`.
void appendHits(const scene::Scene& scene, const TruthTextures& textures, const VisibleInstance& visible,
                const PixelRay& pixel, const ViewRange& range, std::vector<SurfaceHit>& hits);

} // namespace cdr::measure
