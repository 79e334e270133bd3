#pragma once

#include "projection.h"

#include <cdr/gpu/device.h>

#include <ranks/ranks.h>

#include <cstddef>
#include <cstdint>

namespace cdr::experiments {

/// Of which frames costs are measured: unit cubes all in view, encoded as PNG.
struct FrameCostOptions {
    std::uint32_t width = 1280;
    std::uint32_t height = 720;
    std::uint32_t cubes = 10'000;
    std::uint32_t repeats = 7; ///< frames that each rank makes
    std::uint64_t seed = 2013;
};

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
MeasuredCosts measureFrameCosts(const gpu::Device& device, const FrameCostOptions& options,
                                ranks::Ranks& ranks);

} // namespace cdr::experiments
