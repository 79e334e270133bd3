#pragma once

#include <cdr/gpu/device.h>
#include <cdr/measure/statistics/statistics.h>
#include <experiments/timing/timing.h>

#include <string>
#include <vector>

namespace cdr::experiments {

/// What one stage of a frame costs.
struct StageCost {
    std::string name;
    std::string how; ///< "measured", or what was left out to find it
    double medianUs = 0.0;
    measure::Interval us95;    ///< bootstrapped
    double framePercent = 0.0; ///< of the whole frame's median
};

/// The stages of a frame of the timing scene, in their order, and last the whole frame. Stages of the CPU are
/// measured. Execute is attributed by drawing the same frames without lights, without pixels (16x9 of them), without
/// cubes, and without both, and taking differences frame by frame.
///
/// A driver that passes over triangles which cover no pixel spares part of their set-up where there are few pixels. That
/// part counts as pixels here.
/// @param options mode 0 is drawn; one frame in flight. base::InputError for no frames.
/// @param ranks that share the frames; the first one alone has results.
std::vector<StageCost> runStages(const gpu::Device& device, const TimingOptions& options,
                                 const TimingProgress& progress, TimedRanks& ranks);

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
