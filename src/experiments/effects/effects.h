#pragma once

#include <cdr/depth/technique.h>
#include <cdr/gpu/device.h>
#include <cdr/image/image.h>
#include <cdr/measure/statistics/statistics.h>
#include <cdr/render/render_options.h>
#include <experiments/progress.h>
#include <scenes/open_scene.h>

#include <runs/timed_ranks.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cdr::experiments {

/// What screen-space effects cost, whether they look the same under every technique, and what is lost by
/// layers (thesis chapter 3, method 2).
struct EffectsOptions {
    std::string scene = "alley"; ///< as scenes::openScene() takes it
    std::uint64_t seed = scenes::kDefaultSeed;
    render::RenderOptions drawing{};               ///< but for technique, targets and effects
    std::uint32_t frames = 20;                     ///< timed, of every mode, all of the scene's first camera
    double occlusionRadius = 1.0;                  ///< scene units
    double visibility = 100.0;                     ///< in fog, scene units
    std::vector<depth::NamedTechnique> techniques; ///< that are compared; none: all presets
};

/// Which effect a mode has.
enum class EffectMode : std::uint8_t {
    plain,           ///< none
    edges,           ///< smooth edges
    occlusion,       ///< ambient occlusion over the whole picture
    occlusionLayers, ///< ambient occlusion of each cascade by itself
    fog,
};
inline constexpr std::array kEffectModes{EffectMode::plain, EffectMode::edges, EffectMode::occlusion,
                                         EffectMode::occlusionLayers, EffectMode::fog};
/// "plain", "edges", "occlusion", "occlusion-layers" or "fog".
std::string_view nameOf(EffectMode mode);

/// One mode. Times are medians, milliseconds.
struct EffectsResult {
    EffectMode mode = EffectMode::plain;
    double executeMs = 0.0;
    double ratio = 1.0; ///< of execute to "plain": the median of the ratios frame by frame
    std::optional<measure::Interval> ratio95{}; ///< bootstrapped
    /// Of the techniques compared, the one whose picture differs most from anchored's with the same effect.
    std::string leastAlike;
    double differing = 0.0;    ///< share of its pixels that differ by more than kEffectTolerance
    image::ImageRgba8 picture; ///< under anchored, in twelve cascades of one ratio
};

/// Of 255, in any channel: what rounding of distances and normals may do to a lit pixel.
inline constexpr int kEffectTolerance = 3;

struct EffectsReport {
    std::vector<EffectsResult> results;
    double lostPerLayer =
        0.0; ///< share of pixels that occlusion per cascade leaves brighter by more than that
};

/// Every mode draws a frame, in a newly shuffled order, before the next; then each is drawn by every technique.
/// base::InputError for no frames.
/// @param setup what options.scene names.
/// @param ranks that share the timed frames; the first one does the rest, and alone has results.
EffectsReport runEffects(const gpu::Device& device, const scene::SceneSetup& setup,
                         const EffectsOptions& options, const Progress& progress, runs::TimedRanks& ranks);

} // namespace cdr::experiments
