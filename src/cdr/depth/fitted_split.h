#pragma once

/// @file
/// @errors None: makeCascades() checks the arguments, and is the one to call.

#include <cdr/depth/make_cascades.h>

namespace cdr::depth {

/// The cascades of a fitted split, at least one. Bounds stay put from frame to frame:
/// - they have a margin of 1/128 of the cascade where the target allows it;
/// - previous bounds are kept while what they enclose stays within twice that margin;
/// - previous cuts and the previous count are kept while a target 1/8 wider is met.
Cascades fitCascades(const SplitFitted& split, const SplitContext& context);

/// How far beyond its target a kept split may lie.
inline constexpr double kFitSlack = 0.125;

/// `split.count` cascades over the camera's range with the smallest worst step bound, to a thousandth.
Cascades minimaxCascades(const SplitMinimax& split, const SplitContext& context);

} // namespace cdr::depth
