#pragma once

/// @file
/// @errors None: what is wanted of arguments is not checked.

#include <cdr/depth/cascade.h>
#include <cdr/depth/occupancy.h>
#include <cdr/depth/step_bound.h>

#include <cstddef>
#include <optional>
#include <span>

namespace cdr::depth {

/// The fewest cascades that meet a target over what is occupied, and among those plans one that cuts the
/// fewest intervals. Each cascade begins and ends on something occupied; two of them touch where an interval
/// is cut. Empty when more than `most` would be needed.
///
/// This is exact. Steps never fall as a cascade grows (stepBoundView()). So take all ways to cover the nearest
/// part of the range with k cascades, c of which end in a gap. The one that reaches farthest leaves the least
/// to cover. It is kept for every (k, c).
/// @param occupied as mergeIntervals() returns them, not empty.
std::optional<Cascades> planCascades(const StepModel& model, const StepTarget& target,
                                     std::span<const Interval> occupied, std::size_t most);

/// Whether planCascades() finds a plan; several times faster.
/// @param occupied as for planCascades().
bool canMeet(const StepModel& model, const StepTarget& target, std::span<const Interval> occupied,
             std::size_t most);

/// The finest multiple of `target`, at least 1, that `most` cascades meet, to a thousandth.
/// @param occupied as for planCascades().
StepTarget relaxToMeet(const StepModel& model, const StepTarget& target, std::span<const Interval> occupied,
                       std::size_t most);

} // namespace cdr::depth
