#pragma once

#include "projection.h"
#include "rank_sweep.h"

#include <cdr/gpu/device.h>

#include <ranks/ranks.h>

#include <cstddef>

namespace cdr::experiments {

/// What a run of frames took, to compare a projection with.
struct MeasuredRun {
    std::size_t frames = 0;
    double seconds = 0.0;
};

struct MeasuredCosts {
    FrameCosts costs;
    MeasuredRun run; ///< of all ranks
};

/// All ranks call it and work at once, so what they take from each other is in their costs. Results are the first rank's.
/// @param options of which the first size counts. Frames are encoded as PNG, and each rank makes `repeats`.
MeasuredCosts measureFrameCosts(const gpu::Device& device, const RankSweepOptions& options,
                                ranks::Ranks& ranks);

} // namespace cdr::experiments
