#pragma once

#include <cdr/depth/mapping.h>
#include <cdr/gpu/device.h>
#include <cdr/image/image.h>
#include <cdr/measure/truth/layered_truth.h>
#include <cdr/render/translucency/translucency.h>
#include <cdr/scene/scene_setup.h>
#include <experiments/progress.h>

#include <ranks/ranks.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cdr::experiments {

/// Both methods of translucency over 1 to 8 cascades against the float64 truth.
struct TranslucencyExperiment {
    std::string scene = "sheets"; ///< of few triangles: the truth tries them all
    std::uint64_t seed = 2013;
    std::uint32_t width = 640;
    std::uint32_t height = 360;
    depth::Mapping mapping = depth::Mapping::anchored;
    std::vector<unsigned> cascades{1, 2, 3, 4, 5, 6, 7, 8};
    std::size_t threads = 1;
    std::size_t repeats = 7; ///< timed frames per method and count, interleaved; 0 times nothing
    std::uint64_t maxBytes = render::TranslucencyOptions{}.maxBytes;
    bool keepsPictures = true; ///< else those of the results stay empty: 4 bytes a pixel each
};

struct TranslucencyResult {
    std::string technique;
    unsigned cascades = 1;
    render::TranslucencyStats stats;
    std::string note; ///< of `stats.refusal`, for people: why it was not sorted, though it was to be
    measure::LayerDifference difference;
    std::optional<double> executeMs; ///< median; none where nothing was timed
    image::ImageRgba8 picture;
};

struct TranslucencyResults {
    image::ImageRgba8 truth;
    std::vector<TranslucencyResult> results; ///< by cascades, then method
};

/// base::InputError for a scene without translucent surfaces, or an unusable number of cascades. base::RunError
/// where the device lacks the memory for all renderers at once, which timing takes.
/// @param setup what given.scene names.
/// @param ranks that share the comparisons. The first one times, while the others wait; it alone has results.
TranslucencyResults runTranslucency(const gpu::Device& device, const scene::SceneSetup& setup,
                                    const TranslucencyExperiment& given, const Progress& progress,
                                    ranks::Ranks& ranks);

/// How far a picture is from the truth, eight times as bright.
image::ImageRgba8 errorPicture(const image::ImageRgba8& picture, const image::ImageRgba8& truth);

} // namespace cdr::experiments
