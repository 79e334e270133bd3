#pragma once

#include <cdr/gpu/device.h>
#include <cdr/image/image.h>
#include <cdr/measure/statistics/statistics.h>
#include <cdr/render/render_options.h>
#include <experiments/progress.h>
#include <scenes/open_scene.h>

#include <ranks/ranks.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cdr::experiments {

/// What levels of detail save and what they change (thesis chapter 3): the same frames in full, by object, by
/// cascade and by cluster.
struct DetailOptions {
    std::string scene = "boulders"; ///< as scenes::openScene() takes it
    std::uint64_t seed = scenes::kDefaultSeed;
    render::RenderOptions drawing{}; ///< but for the mode of detail
    std::uint32_t frames = 24;       ///< spread over the scene's camera path
};

/// One mode over all frames. Times are medians, milliseconds.
struct DetailResult {
    std::string mode; ///< "none", "none-again" (the noise floor), "object", "cascade" or "cluster"
    double frameMs = 0.0;
    double recordMs = 0.0;
    double executeMs = 0.0;
    double speedup = 1.0; ///< of execute over none: the median of the ratios frame by frame
    std::optional<measure::Interval> speedup95{}; ///< bootstrapped
    double triangles = 0.0;                       ///< a frame draws, mean; straddlers count once per cascade
    double flip = 0.0;                            ///< mean LDR-FLIP to none
    double largestFlip = 0.0;                     ///< of any frame's mean
    std::uint64_t pixels = 0;                     ///< of all frames
    std::uint64_t otherIds = 0;                   ///< that show another object than none does
    std::uint64_t cracks = 0;                     ///< measure::findCracks() to none
    image::ImageRgba8 picture;                    ///< the first frame
    image::ImageRgba8 cracked;                    ///< the same with a red square about every crack
};

/// The modes that are compared, as results name them.
std::vector<std::string> detailModeNames();

struct DetailReport {
    std::uint64_t sceneTriangles = 0; ///< instances times their meshes'
    std::size_t meshLevels = 0;       ///< that were made or came with the scene, of all meshes
    std::size_t clusters = 0;         ///< likewise
    double makeMs = 0.0;              ///< making them took, on all threads
    std::vector<DetailResult> results;
};

/// Every mode draws a camera, in a newly shuffled order, before the next camera. Then each renders it once
/// more to be compared. base::InputError for no frames or an unusable detail.
/// @param setup what options.scene names.
/// @param ranks that share the comparisons. The first one times, while the others wait; it alone has results.
DetailReport runDetail(const gpu::Device& device, scene::SceneSetup setup, const DetailOptions& options,
                       const Progress& progress, ranks::Ranks& ranks);

} // namespace cdr::experiments
