#pragma once

/// @file
/// @errors None but those that a function names.

#include <cdr/base/export.h>
#include <cdr/depth/cascade.h>
#include <cdr/depth/occupancy.h>
#include <cdr/depth/split.h>
#include <cdr/depth/step_bound.h>

#include <span>

namespace cdr::depth {

/// What a split may depend on. Each split reads what it needs.
struct SplitContext {
    double nearView = 0.0; ///< of the camera
    double farView = 0.0;  ///< of the camera
    /// minimax and fitted: how a view distance becomes a stored depth.
    StepModel model{};
    /// fitted, with a target in pixels: what a pixel covers per unit of view distance, 2 tan(fovY / 2) /
    /// height.
    double footprintSlope = 0.0;
    /// fitted: view distances of the visible objects, [w - r, w + r]. Reordered. Intervals outside the
    /// camera's range, or with a bound that is not a number, are left out.
    std::span<Interval> visible{};
    /// fitted: the cascades of the last frame, empty at first.
    std::span<const Cascade> previous{};
};

/// Cuts view distances into cascades, nearest first. Depends on its arguments alone.
///
/// - none, ratio, count, at, minimax: the whole range, without gap or overlap.
/// - fitted: what is visible, as SplitFitted says; there may be gaps.
///
/// @throws base::InputError for a range that requireRange() refuses, for a splitProblem() and for more than kMaxCascades.
/// @throws base::InputError for a split that is fitted to pixels if the footprint slope is not above 0.
CDR_EXPORT Cascades makeCascades(const Split& split, const SplitContext& context);
/// makeCascades(), refused instead of thrown.
CDR_EXPORT base::Result<Cascades> tryMakeCascades(const Split& split, const SplitContext& context);

} // namespace cdr::depth
