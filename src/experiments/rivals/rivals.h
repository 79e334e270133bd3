#pragma once

#include <cdr/depth/technique.h>
#include <cdr/gpu/device.h>
#include <cdr/measure/compare/flips.h>
#include <cdr/measure/compare/wrong_pixels.h>
#include <cdr/measure/statistics/statistics.h>
#include <cdr/scene/scene_setup.h>
#include <experiments/progress.h>
#include <experiments/rivals/needs.h>

#include <rivals/contender.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cdr::experiments {

/// One that takes part: today's practice, or a rival.
struct NamedContender {
    std::string name; ///< as it was asked for
    rivals::Competing competing;

    bool isRival() const { return std::holds_alternative<rivals::Rival>(competing); }
};

/// A scene under the name it was asked for.
struct NamedScene {
    std::string name;
    scene::SceneSetup setup;
};

/// Rivals beside today's practice: 64-bit depths by atomics, pairs of floats, anchors of objects. All draw ids and distances
/// of the same lists on one device, so that they differ in the test of depth alone.
struct RivalsOptions {
    std::vector<double> distancesView{1.0, 1e3, 1e6, 1e8}; ///< of the ladder
    std::vector<NamedContender> contenders;                ///< defaultContenders() when empty
    std::string baseline = "anchored";                     ///< that times are divided by
    std::uint32_t width = 1280;
    std::uint32_t height = 720;
    std::uint32_t frames = 24; ///< spread over a scene's path, and times measured of each contender
    std::size_t threads = 1;
    std::uint64_t seed = 2013;
};

/// All presets, then every rival that the device can draw, then those again with a prepass.
std::vector<NamedContender> defaultContenders(const gpu::DeviceInfo& device);

/// One contender in one scene.
struct RivalScene {
    std::string scene;
    std::string contender;
    bool isRival = false;
    std::uint32_t frames = 0;
    std::size_t cascades = 0; ///< at most
    measure::WrongPixels wrong;
    measure::FlipCount flips; ///< between consecutive frames of those
    double frameMs = 0.0;     ///< median, from the camera until the device is done
    double executeMs = 0.0;   ///< of that on the device
    double ratio = 1.0;       ///< of frames over the baseline's: the median of the ratios frame by frame
    std::optional<measure::Interval> ratio95{}; ///< bootstrapped
};

/// One contender on the ladder at one distance.
struct RivalResolved {
    std::string contender;
    bool isRival = false;
    double distanceView = 0.0;
    /// Of pairs of equal cubes, which float32 rounds alike: the median over those ladders of five seeds of which pixels tell.
    std::optional<double> resolvedView;
    std::optional<double> unlikeView; ///< of pairs whose front is shallower
    /// In half of those ladders or more no pair is wrong, so that it may resolve less than `resolvedView`.
    bool resolvesAll = false;
    bool unlikeResolvesAll = false;  ///< the same of `unlikeView`
    std::size_t pairsSeen = 0;       ///< pairs of equal cubes of which a pixel tells, over all ladders
    std::size_t unlikePairsSeen = 0; ///< the same of the others
    std::optional<double>
        ratio; ///< of unlikeView over the baseline's, below 1 where it is finer; where both are known
    double smallestView = 0.0; ///< of the ladder: `resolved` can be no less
    double largestView = 0.0;  ///< of the ladder: null means more than this
};

/// The whole frame of the library's renderer under the baseline, lit and encoded, over the baseline's ids and distances.
struct RivalWholeFrame {
    std::string scene;
    double ratio = 1.0;
    std::optional<measure::Interval> ratio95{};
};

struct RivalsReport {
    std::vector<RivalScene> scenes;      ///< by scene, then contender
    std::vector<RivalResolved> resolved; ///< by distance, then contender
    std::vector<RivalNeeds> needs;
    std::vector<RivalWholeFrame> wholeFrames; ///< by scene
};

/// Each contender draws each frame once to be compared with the float64 truth. Then all are timed, in an order shuffled
/// again for each frame. base::InputError for a baseline that takes no part or is a rival, an unusable distance, and no
/// frames. Also for a rival that the device cannot draw.
RivalsReport runRivals(const gpu::Device& device, const std::vector<NamedScene>& scenes,
                       const RivalsOptions& options, const NamedProgress& progress);

} // namespace cdr::experiments
