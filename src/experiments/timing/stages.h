#pragma once

#include <cdr/gpu/device.h>
#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/measure/statistics/statistics.h>
#include <experiments/timing/timing.h>

#include <optional>
#include <string>
#include <vector>

namespace cdr::experiments {

/// What one stage of a frame costs.
struct StageCost {
    std::string name;
    std::string how; ///< "measured", or what was left out to find it
    double medianUs = 0.0;
    std::optional<measure::Interval> us95{}; ///< bootstrapped
    double framePercent = 0.0;               ///< of the whole frame's median
};

/// base::InputError for a mode that draws other meshes, since stages are those of the scene's own.
void requireStages(const TimingMode& mode);

/// A picture of few pixels in which a camera sees what it sees in `whole`: the shorter side has 9 pixels.
vk::Extent2D fewPixels(vk::Extent2D whole);

/// The stages of a frame of the timing scene, in their order, and last the whole frame. Stages of the CPU are measured.
/// Execute is divided by drawing the same frames again: without lights, with fewPixels(), without cubes, and with both of the
/// last two. Differences are taken frame by frame.
///
/// A driver may skip part of the set-up of triangles that cover no pixel, which are many where pixels are few. That part
/// counts as pixels here.
/// @param options mode 0 is drawn; one frame in flight. base::InputError for no frames.
/// @param ranks that share the frames; the first one alone has results.
std::vector<StageCost> runStages(const gpu::Device& device, const TimingOptions& options,
                                 const Progress& progress, runs::TimedRanks& ranks);

/// The stages of one mode.
struct ModeStages {
    std::string mode;              ///< TimingMode::name
    std::vector<StageCost> stages; ///< of runStages()
};

/// A bar for each mode, cut into stages by their medians, as a gnuplot script. A median below 0, which differences of noisy
/// times may have, is drawn as 0.
/// @param modes at least one
std::string stagesPlot(const std::vector<ModeStages>& modes, const std::string& measuredOn);

} // namespace cdr::experiments
