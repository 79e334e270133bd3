#pragma once

#include <cdr/depth/cascade.h>
#include <cdr/depth/occupancy.h>
#include <cdr/depth/step_bound.h>

#include <cstddef>
#include <optional>
#include <span>

namespace cdr::depth {

/// The fewest cascades that meet a target over what is occupied, and among those plans one that cuts the
/// fewest occupied intervals. Each cascade begins and ends on something occupied; two of them touch where an
/// interval is cut. Empty when more than `most` would be needed.
///
/// Steps never fall as a cascade grows (stepBoundView()), so of all ways to cover a beginning with k
/// cascades, c of them ending in a gap, the one that comes farthest leaves no more to do than any other.
/// Keeping that one for every (k, c) is exact.
/// @param occupied as mergeIntervals() gives them, not empty.
std::optional<Cascades> planCascades(const StepModel& model, const StepTarget& target,
                                     std::span<const Interval> occupied, std::size_t most);

/// Whether planCascades() would find a plan; several times faster.
bool canMeet(const StepModel& model, const StepTarget& target, std::span<const Interval> occupied,
             std::size_t most);

/// The finest multiple of `target`, at least 1, that `most` cascades meet, to a thousandth.
StepTarget relaxToMeet(const StepModel& model, const StepTarget& target, std::span<const Interval> occupied,
                       std::size_t most);

} // namespace cdr::depth
