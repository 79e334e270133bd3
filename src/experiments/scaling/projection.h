#pragma once

#include <cdr/measure/statistics/statistics.h>

#include <output/columns.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace cdr::experiments {

/// What one frame costs a rank, measured. Milliseconds.
struct FrameCosts {
    std::vector<double> makeMs; ///< to draw and encode it
    std::vector<double> takeMs; ///< for the first rank to take a result and write it
    double bytes = 0.0;         ///< of a result
    double claimMs = 0.0;       ///< to be given a frame; 0 in one process
    double msPerByte = 0.0;     ///< of a result's way to the first rank; 0 in one process
};

/// What bounds a run.
enum class ProjectionBound : std::uint8_t {
    making, ///< all that is made and taken is divided by the nodes
    taking, ///< the first rank takes results as fast as it can
    frames  ///< a node makes so many frames: one, or one more than others
};

/// A run of so many nodes, a rank each.
struct Projection {
    std::size_t nodes = 1;
    double seconds = 0.0; ///< from the medians of the costs
    /// From both ends of their 95 % intervals; empty where one has none.
    std::optional<measure::Interval> secondsInterval{};
    double efficiency = 1.0; ///< time of one node over that of all nodes together
    ProjectionBound bound = ProjectionBound::making;
};

/// Nodes make frames alike and take them in turn; the first one takes results beside.
/// @param nodes 1 or more. @param frames of the run, 1 or more.
Projection project(const FrameCosts& costs, std::size_t nodes, std::size_t frames, std::uint64_t seed);

/// The least number of nodes from which on more nodes do not help. The first rank takes results as fast as it can then, or
/// no other node has a second frame to make.
std::size_t lastUsefulNodes(const FrameCosts& costs, std::size_t frames);

output::Columns<Projection> projectionColumns();

} // namespace cdr::experiments
