#pragma once

#include <cdr/depth/technique.h>
#include <cdr/gpu/device.h>
#include <cdr/image/image.h>
#include <cdr/measure/statistics/statistics.h>
#include <cdr/render/render_options.h>
#include <experiments/progress.h>
#include <scenes/open_scene.h>

#include <runs/timed_ranks.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cdr::experiments {

/// What depth of field by per-cascade resolution saves, and how it compares with a lens of many cameras. The
/// thesis proposes it in chapter 3 and does not test it.
struct FocusOptions {
    std::string scene = "alley"; ///< as scenes::openScene() takes it
    std::uint64_t seed = scenes::kDefaultSeed;
    render::RenderOptions drawing{}; ///< but for technique, targets and focus
    std::uint32_t frames = 20;       ///< timed, of every mode, all of the scene's first camera
    std::uint32_t cameras = 64;      ///< on the lens of the reference
    depth::Mapping mapping = depth::Mapping::reversed;
    std::optional<depth::Split> split; ///< without: cut where circles of confusion are 2, 4, 8 and 16 pixels
    render::Focus lens{.distance = 12.0, .aperture = 0.15};
};

/// One mode over all frames. Times are medians, milliseconds.
struct FocusResult {
    /// "single" and "layers": in full, all of it sharp; "focus" and "focus-blend"; "cameras": the reference,
    /// one after the other.
    std::string mode;
    double frameMs = 0.0;
    double executeMs = 0.0;
    double speedup = 1.0; ///< of execute over "layers": the median of the ratios frame by frame
    std::optional<measure::Interval> speedup95{}; ///< bootstrapped; not of "cameras", which are drawn once
    std::uint64_t pixels = 0;                     ///< of all layers; of "cameras" all pictures
    double flip = 0.0;                            ///< mean LDR-FLIP to the reference
    double rmse = 0.0;                            ///< of linear light to the reference, over all channels
    image::ImageRgba8 picture;
};

/// The modes that are compared, as results name them.
std::vector<std::string> focusModeNames();

/// One cascade of the modes with a focus.
struct FocusCascade {
    double nearView = 0.0;
    double farView = 0.0;
    std::uint32_t scale = 1;
};

struct FocusReport {
    std::vector<FocusCascade> cascades;
    std::vector<FocusResult> results;
};

/// Every mode draws a frame, in a newly shuffled order, before the next. Then each is compared once with the
/// mean, in linear light, of cameras spread over the lens. Each of them is turned to the point in focus.
/// base::InputError for no frames or cameras, or an unusable or no focus.
/// @param setup what options.scene names.
/// @param ranks that share the timed frames; the first one does the rest, and alone has results.
FocusReport runFocus(const gpu::Device& device, const scene::SceneSetup& setup, const FocusOptions& options,
                     const Progress& progress, runs::TimedRanks& ranks);

} // namespace cdr::experiments
