#pragma once

#include <CLI/CLI.hpp>
#include <cli/command.h>
#include <experiments/scaling/frame_costs.h>
#include <experiments/scaling/rank_sweep.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace cdr::cli {

/// What `scaling --ranks` takes beside what `scaling` does.
struct RankSweepArguments {
    bool isAsked = false;
    std::vector<std::uint32_t> heights{360, 720}; ///< of pictures, pixels
    std::size_t nodes = 0;                        ///< to project to; 0: not
    std::size_t frames = 1000;                    ///< of the run that is projected
};

void addRankSweepOptions(CLI::App& command, RankSweepArguments& arguments);

/// Runs on all ranks, sweeps them, and prints and writes what it found. base::InputError for a bad
/// height. base::RunError where the ranks draw another image than one.
void runRankSweep(Command& command, experiments::RankSweepOptions options,
                  const RankSweepArguments& arguments);

/// Runs on all ranks, measures a frame, and projects a run of many frames to many nodes.
void runProjection(Command& command, const experiments::RankSweepOptions& options,
                   const RankSweepArguments& arguments);

} // namespace cdr::cli
