#pragma once

#include <cdr/gpu/device.h>
#include <cdr/measure/statistics/scaling_law.h>
#include <cdr/platform/thread_placement.h>
#include <cdr/render/submit/draw_path.h>
#include <cdr/render/targets/targets.h>
#include <experiments/progress.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cdr::experiments {

/// 1, 2, 3, 4, 6, 8, 12, ... up to twice the CPUs, and both those.
std::vector<std::size_t> threadSteps(std::size_t cpus);

/// How recording scales with threads: a draw-bound scene of unit cubes all in view, one draw each.
struct ScalingOptions {
    std::uint32_t width = 640;
    std::uint32_t height = 360;
    std::vector<std::uint32_t> draws{1'000, 10'000, 100'000, 1'000'000};
    std::vector<std::size_t> threads; ///< threadSteps() of this machine when empty; 1 is always added
    std::vector<render::TargetsChoice> targets{render::kTargetsKinds.begin(), render::kTargetsKinds.end()};
    std::vector<unsigned> cascades{1, 2, 4, 8};
    /// Secondaries, and the control: one primary per cascade, no secondaries.
    std::vector<render::Submission> submissions{render::Submission::secondaries,
                                                render::Submission::primaries};
    /// Pinned, the caller too, measures how recording scales. Free also measures how the kernel places threads.
    platform::Placement placement = platform::Placement::pinned;
    std::uint32_t repeats = 7; ///< timed frames of each point, after one that warms up
    std::uint64_t seed = 2013;
};

/// A time's median over the repeats, and their spread: the distance between the quartiles as a share of the
/// median.
struct Spread {
    double medianMs = 0.0;
    double spread = 0.0;
};

/// What varies besides draws and threads.
struct ScalingVariant {
    render::TargetsChoice targets = render::TargetsKind::single;
    render::Submission submission = render::Submission::secondaries;
    unsigned cascades = 1;

    bool operator==(const ScalingVariant&) const = default;
};

/// One (targets, submission, cascades, draws, threads). Factors are over one thread, medians of the ratios
/// repeat by repeat.
struct ScalingPoint {
    ScalingVariant variant{};
    std::uint32_t cubes = 0;
    std::size_t threads = 1;
    std::size_t draws = 0; ///< a cube astride a boundary counts once per cascade
    Spread cull;
    Spread bin;
    Spread record;
    Spread execute;
    Spread frame;
    double recordSpeedUp = 1.0;
    double cullAndBinSpeedUp = 1.0;
    double frameSpeedUp = 1.0;
    std::string hash;      ///< SHA-256 over the whole G-buffer and the picture
    bool sameImage = true; ///< as with one thread

    double recordNsPerDraw() const;
    double efficiency() const { return recordSpeedUp / static_cast<double>(threads); }
};

/// What the points of one (targets, submission, cascades, draws) say of recording.
struct ScalingFit {
    ScalingVariant variant{};
    std::uint32_t cubes = 0;
    std::optional<double> serialFraction; ///< Amdahl's, over the points with no more threads than CPUs
    std::optional<measure::UniversalScalability> universal; ///< over all points
};

struct ScalingResult {
    std::vector<ScalingPoint> points;
    std::vector<ScalingFit> fits;
};

/// base::InputError for an empty list or a value out of range, before anything is made.
ScalingResult runScaling(const gpu::Device& device, const ScalingOptions& options,
                         const NamedProgress& progress);
void requireUsable(const ScalingOptions& options);

/// Record time per draw, and its speed-up, over threads, as a gnuplot script; of the first targets, submission and
/// number of cascades.
/// @param measuredOn goes under the title.
std::string scalingPlot(const ScalingResult& result, const std::string& measuredOn);

} // namespace cdr::experiments
