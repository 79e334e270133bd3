#pragma once

#include <cdr/depth/mapping.h>

namespace cdr::depth {

/// What float32 arithmetic does to a surface's depth before the buffer stores it, whatever the buffer's
/// format.
///
/// Every operation rounds by up to half the gap between the float32 values around its result. Some operations
/// round view distances; others round depths, which the mapping turns into view distances. This follows
/// Akeley and Su 2006 ("Minimum Triangle Separation for Correct z-Buffer Occlusion"). Their other term, the
/// rounding of window x and y, is left out: it tilts triangles, so it is common to parallel surfaces, and
/// lavapipe interpolates depth from positions that are not snapped.
struct DepthRounding {
    double distanceGapView = 0.0;   ///< between float32 view distances, or distances to the anchor plane
    unsigned distanceRoundings = 0; ///< results of that size on the way
    double depthGapView = 0.0;      ///< between float32 depths, as a view distance
    unsigned depthRoundings = 0;

    /// Standard deviation of the error of one surface, if all roundings are independent and uniform.
    double deviationView() const;
    /// Largest error of one surface: every rounding at its worst and in the same direction.
    double worstView() const;
};

/// The roundings of a surface at view distance w, which lies within the range.
/// - Distance: the object's, and the sum with the vertex's. logFragment: two more for the interpolation.
/// - Depth, linear mappings: clip z (exact where it is a constant, as in reversed without a far plane), the
///   division by w, and the interpolation.
/// - Depth, log: scale, logarithm, offset, division and interpolation. logFragment: scale, logarithm, offset.
DepthRounding depthRounding(const DepthRange& range, double distanceView);

/// The gap between neighbouring float32 values around a positive number.
double floatGap(double value);

} // namespace cdr::depth
