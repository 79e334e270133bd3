#pragma once

#include <cdr/image/image.h>
#include <cdr/measure/compare/share.h>
#include <cdr/measure/truth/shape.h>
#include <cdr/measure/truth/truth_finish.h>
#include <cdr/platform/worker_pool.h>
#include <cdr/scene/camera.h>
#include <cdr/scene/scene.h>

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace cdr::measure {

/// What a perfect renderer shows at one pixel of a scene with translucent surfaces.
struct LayeredPixel {
    glm::dvec3 color{0.0};       ///< linear: translucent surfaces, nearest first, over the opaque one
    std::uint32_t fragments = 0; ///< translucent surfaces at or in front of the opaque one
    /// Whether the eight neighbours see the same faces in the same order, so that neither silhouettes nor
    /// lines where surfaces cross come near. Never at the picture's border.
    bool isInner = false;
};

using LayeredTruth = image::Raster<LayeredPixel>;

/// What lights reach: all surfaces, or those that no opaque one hides from them (scene::shadowLights()). A float64 ray goes to each
/// of these lights from each surface, translucent ones too. A pixel on a shadow's edge is no inner one.
enum class Lights : std::uint8_t { reachAll, castShadows };

/// Casts one float64 ray through every pixel's centre and sorts all that it meets up to the first opaque
/// surface. Lights every surface in float64 as the shading pass does, and lays the translucent ones over each
/// other. Shares no code with the renderer. Tries each triangle of an instance at every pixel that it may
/// cover, so meant for meshes of few triangles. base::InputError and base::RunError as TruthCaster.
LayeredTruth castLayers(const scene::Scene& scene, const scene::Camera& camera, std::uint32_t width,
                        std::uint32_t height, platform::WorkerPool& workers,
                        Lights lights = Lights::reachAll);

/// What some pixels of such a picture show, as castLayers() has it, but for `isInner`.
/// @param shapes of the scene's meshes. @param pixels within the size.
std::vector<LayeredPixel> castLayersAt(const scene::Scene& scene, std::span<const Shape> shapes,
                                       const scene::Camera& camera, const glm::uvec2& size,
                                       std::span<const glm::uvec2> pixels, bool hasShadows,
                                       platform::WorkerPool& workers);

/// The truth as 8-bit sRGB.
image::ImageRgba8 pictureOf(const LayeredTruth& truth, const TruthFinish& finish = {});

/// How a rendered picture differs from the truth, over the inner pixels.
struct LayerDifference {
    std::uint64_t pixels = 0;       ///< inner ones
    std::uint64_t translucent = 0;  ///< inner ones with any such fragment: what follows is over these
    std::uint64_t within = 0;       ///< whose channels are all within one 8-bit step
    std::uint64_t miscounted = 0;   ///< over all inner pixels: whose count differs
    double meanError = 0.0;         ///< mean over pixels of the largest channel's difference, 8-bit steps
    std::uint32_t largestError = 0; ///< 8-bit steps

    /// None where no inner pixel is translucent.
    std::optional<double> withinFraction() const { return shareOf(within, translucent); }
};

/// @param picture neither exposed nor tone mapped: under a sky or in air one with render::ToneMap::none.
/// @param fragmentCounts as rendered. base::InputError when sizes differ.
LayerDifference compareLayers(const image::ImageRgba8& picture, const image::ImageU32& fragmentCounts,
                              const LayeredTruth& truth);

} // namespace cdr::measure
