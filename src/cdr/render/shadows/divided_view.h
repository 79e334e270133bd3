#pragma once

#include <cdr/render/shadows/light_view.h>

#include <vector>

namespace cdr::render {

/// How many pixels wide a texel is, at the near end of the view's slice.
double pixelsPerTexel(const LightView& view, double footprintSlope);

/// Divides a view if its texels are wider than kWidestTexel pixels and half a texel is not. The result is four views, each
/// with as many texels and half as wide, without those that meet nothing of the slice. Else it is the view itself.
/// @param camera position that the slice is relative to.
std::vector<LightView> dividedView(const LightView& view, const ReceiverSlice& slice,
                                   const glm::dvec3& camera, double footprintSlope);

/// Pixels. The edge of a shadow is off by about a texel, so wider texels show as steps.
inline constexpr double kWidestTexel = 4.0;

} // namespace cdr::render
