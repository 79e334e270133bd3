#pragma once

#include <cdr/depth/mapping.h>

namespace cdr::depth {

/// What float32 arithmetic makes of a surface's depth on its way to the buffer, whatever the buffer's format.
///
/// Every operation rounds by up to half the gap between the float32 values around its result. Some round view
/// distances, and some round depths, which the mapping turns into view distances. That is how Akeley and Su
/// 2006 ("Minimum Triangle Separation for Correct z-Buffer Occlusion") bound the separation that comes out in
/// order. Their other term, the rounding of window x and y, is left out: it tilts triangles, so that it is
/// common to parallel surfaces, and lavapipe interpolates depth from positions that are not snapped.
struct DepthRounding {
    double distanceGapView = 0.0;   ///< between float32 view distances, or distances to the anchor plane
    unsigned distanceRoundings = 0; ///< results of that size on the way
    double depthGapView = 0.0;      ///< between float32 depths, as a view distance
    unsigned depthRoundings = 0;

    /// Standard deviation of the error of one surface, all roundings independent and uniform.
    double deviationView() const;
    /// Largest error of one surface: every rounding its worst, all one way.
    double worstView() const;
};

/// The roundings of a surface at view distance w, w within the range:
/// - its distance: rounding the object's, and adding a vertex's (logFragment: and interpolating, two more);
/// - its depth, linear mappings: clip z (exact where it is a constant, reversed without a far plane), its
///   division by w, and interpolation, one more; log, per vertex: scale, logarithm, offset and division, and
///   interpolation; logFragment: scale, logarithm and offset.
DepthRounding depthRounding(const DepthRange& range, double distanceView);

/// The gap between neighbouring float32 values around a positive number.
double floatGap(double value);

} // namespace cdr::depth
