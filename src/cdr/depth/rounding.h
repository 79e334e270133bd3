#pragma once

/// @file
/// @errors None.

#include <cdr/base/export.h>
#include <cdr/depth/mapping.h>

namespace cdr::depth {

/// What float32 arithmetic does to a surface's depth before the buffer stores it, whatever the buffer's
/// format.
///
/// Every operation rounds by up to half the gap between the float32 values around its result. Some operations
/// round view distances; others round depths, which the mapping turns into view distances. This follows
/// Akeley and Su 2006 ("Minimum Triangle Separation for Correct z-Buffer Occlusion"). Their other term is the
/// snapping of window x and y to sub-pixels. It counts where it is asked for: surfaces that share their outline
/// move alike, and some devices interpolate from positions that are not snapped.
struct CDR_EXPORT DepthRounding {
    double distanceGapView = 0.0;   ///< between float32 view distances, or distances to the anchor plane
    unsigned distanceRoundings = 0; ///< results of that size on the way
    double depthGapView = 0.0;      ///< between float32 depths, as a view distance
    unsigned depthRoundings = 0;    ///< results of that size on the way
    double snapGapView = 0.0;       ///< snapGapView() of the surface; 0: vertices are not snapped, or alike

    /// Standard deviation of the error of one surface, if all roundings are independent and uniform.
    double deviationView() const;
    /// Largest error of one surface: every rounding at its worst and in the same direction.
    double worstView() const;
};

/// The roundings of a surface at view distance w, which lies within the range.
/// - Distance: the object's, and the sum with the vertex's. logFragment: two more for the interpolation.
/// - Depth, linear mappings: clip z, the division by w, and the interpolation. Clip z is exact where it is
///   a constant, as in reversed without a far plane.
/// - Depth, log: scale, logarithm, offset, division and interpolation. logFragment: scale, logarithm, offset.
CDR_EXPORT DepthRounding depthRounding(const DepthRange& range, double distanceView);

/// The view distance by which a slanted surface differs over one sub-pixel. Snapped vertices move a surface by
/// up to half a sub-pixel along x and along y.
/// @param subPixelBits of the device: VkPhysicalDeviceLimits::subPixelPrecisionBits.
/// @param footprintView scene units that a pixel covers at the surface's distance.
/// @param slope tangent of the angle between the surface and a plane that faces the camera; 0 faces it.
CDR_EXPORT double snapGapView(unsigned subPixelBits, double footprintView, double slope);

/// The gap between neighbouring float32 values around a positive number, in the unit of that number.
CDR_EXPORT double floatGap(double value);

} // namespace cdr::depth
