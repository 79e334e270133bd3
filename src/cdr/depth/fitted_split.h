#pragma once

#include <cdr/depth/cascade.h>
#include <cdr/depth/mapping.h>
#include <cdr/depth/occupancy.h>
#include <cdr/depth/split.h>
#include <cdr/depth/step_bound.h>

#include <vector>

namespace cdr::depth {

/// Who looks, and how what is seen becomes depth.
struct FitView {
    StepModel model;
    double nearView = 0.0; ///< the camera's; > 0
    double farView = 0.0;  ///< the camera's; > nearView
    /// What a pixel covers per unit of view distance: 2 tan(fovY / 2) / height.
    double footprintSlope = 0.0;
};

/// The fewest cascades over what is visible whose predicted steps meet the split's target at every occupied
/// distance; intervals are cut only where fewer cascades could not do. There is at least one, and there may
/// be gaps between them. A target that asks for more than `split.most` is relaxed until that many do.
///
/// Stays put from frame to frame: bounds come with a margin of 1/128 of the cascade where the target allows,
/// previous bounds are kept while what they enclose stays within twice that, previous cuts and the previous
/// count while the target, taken an eighth wider, is met. Depends on its arguments alone.
/// base::InputError unless 0 < near < far, both finite.
/// @param intervals view distances of the visible objects, [w - r, w + r]; scratch, reordered. Those outside
///        the camera's range or not a number are left out.
/// @param previous the last frame's cascades, empty at first.
Cascades fitCascades(const SplitFitted& split, const FitView& view, std::vector<Interval>& intervals,
                     const Cascades& previous);

/// How far beyond its target a kept split may lie.
inline constexpr double kFitSlack = 0.125;

/// `count` cascades over [nearView, farView], the worst step bound the smallest there is, to a thousandth.
/// base::InputError unless 0 < near < far, both finite.
Cascades minimaxCascades(const SplitMinimax& split, const StepModel& model, double nearView, double farView);

} // namespace cdr::depth
