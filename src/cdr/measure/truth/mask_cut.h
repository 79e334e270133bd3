#pragma once

#include <cdr/measure/truth/object_ray.h>
#include <cdr/measure/truth/shape.h>
#include <cdr/measure/truth/surface_point.h>
#include <cdr/measure/truth/truth_texture.h>
#include <cdr/measure/truth/visible_instances.h>
#include <cdr/scene/scene.h>

#include <cstdint>

namespace cdr::measure {

/// Whether a mask cuts away a point with this alpha.
/// @param material whose alpha mode is `mask`.
inline bool isCutAt(const scene::Material& material, double alpha) {
    return alpha < static_cast<double>(material.alphaCutoff);
}

/// What a mask does at a pixel.
struct MaskCut {
    bool isCut = false;      ///< at the pixel's centre, as the truth filters textures
    bool isDoubtful = false; ///< a device that filters them a little differently may do the other
};

/// Alpha is compared at the pixel's centre and half a pixel to each side. At the centre also with levels of the texture that
/// are half a level larger and smaller, which drivers may read. Each may be four steps of 8 bits off. An alpha that is not finite
/// is doubtful.
/// @param point of a material whose alpha mode is `mask`.
MaskCut maskCutAt(const SurfacePoint& point);

/// What a ray meets of a masked instance.
struct MaskedHit {
    double distanceView = kNoHit; ///< of the nearest point that the mask keeps; kNoHit where there is none
    double doubtView =
        kNoHit; ///< of the nearest doubtful point that is no farther; kNoHit where there is none
};

/// A ray that textures are filtered along: with what lies half its width to each side.
struct WideRay {
    ObjectRay ray;
    glm::dvec3 right; ///< to there, object space; 0 for a ray without width, which reads the finest level
    glm::dvec3 up;
};

/// An instance with a material whose alpha mode is `mask`.
struct MaskedInstance {
    std::uint32_t instance = 0; ///< index in the scene
    const Shape& shape;         ///< of its mesh
    Sidedness sides = Sidedness::fronts;
};

/// The nearest that a mask keeps within `range` of the ray's parameters.
/// @param masked of `scene`. @param textures of `scene`.
MaskedHit nearestKept(const scene::Scene& scene, const TruthTextures& textures, const MaskedInstance& masked,
                      const WideRay& wide, const ViewRange& range);
/// The same along a pixel's ray.
/// @param visible of `scene`, with a material whose alpha mode is `mask`. @param textures of `scene`.
MaskedHit nearestKept(const scene::Scene& scene, const TruthTextures& textures,
                      const VisibleInstance& visible, const PixelRay& pixel, const ViewRange& range);

/// A masked instance, as the rays of a picture's pixels meet it.
struct MaskedPixels {
    const scene::Scene& scene;
    const TruthTextures& textures; ///< of the scene
    const PixelSlopes& slopes;
    const VisibleInstance& visible; ///< of the scene, with a material whose alpha mode is `mask`

    /// Whether the mask cuts away the point where a pixel's ray meets what a triangle lies in. It is the same to the last
    /// bit as in nearestKept().
    /// @param first of the triangle's three indices.
    bool cutsAt(std::uint32_t first, std::uint32_t x, std::uint32_t y) const;
};

} // namespace cdr::measure
