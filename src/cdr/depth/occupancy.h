#pragma once

/// @file
/// @errors None.
/// @units Distances are view distances in scene units; roundings are shares of them.

#include <cdr/base/export.h>
#include <cdr/depth/mapping.h>

#include <limits>
#include <span>
#include <vector>

namespace cdr::depth {

/// View distances that something occupies, both ends included.
struct Interval {
    double nearView = 0.0; ///< view distance where it begins
    double farView = 0.0;  ///< view distance where it ends, included
};

/// The thickness of the thinnest interval that is not a point and meets [nearView, farView]; 0 when there is none.
CDR_EXPORT double thinnest(std::span<const Interval> intervals,
                           double nearView = -std::numeric_limits<double>::infinity(),
                           double farView = std::numeric_limits<double>::infinity());

/// Sorts intervals, cuts them to [nearView, farView], and merges those that overlap or lie closer together
/// than their ends round. The result ascends, with a gap between any two. Intervals outside the range, or
/// with an end that is not a number, are left out.
/// @param intervals overwritten.
/// @param rounding by which share of a view distance ends may be wrong.
CDR_EXPORT std::vector<Interval> mergeIntervals(std::span<Interval> intervals, double nearView,
                                                double farView, double rounding);

/// By which share of the view distance a rendered surface may lie beyond the end of its interval, before any
/// cascade is known. float32 for mappings that form view distances in the vertex shader, float64 for
/// anchored.
CDR_EXPORT double endRounding(Mapping mapping);

} // namespace cdr::depth
