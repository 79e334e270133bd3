#pragma once

/// @file
/// @errors None.

#include <cdr/base/export.h>
#include <cdr/depth/cascade.h>
#include <cdr/depth/format.h>
#include <cdr/depth/mapping.h>

#include <algorithm>

namespace cdr::depth {

/// What the step between two stored depths depends on, beside the cascade.
struct StepModel {
    Mapping mapping = Mapping::standard;    ///< of view distance to depth
    DepthFormat format = DepthFormat::d32f; ///< of the depth buffer
};

/// The largest step to allow: the wider of scene units and a share of the view distance. The least ones bound
/// it from below, since a finer step gains nothing, and stay when the target is scaled.
struct CDR_EXPORT StepTarget {
    double unitsView = 0.0;      ///< scene units
    double shareView = 0.0;      ///< as a pixel's footprint is
    double leastUnitsView = 0.0; ///< what float32 makes of the vertices of the smallest object
    double leastShareView = 0.0; ///< distanceRounding()

    /// The largest step to allow at a view distance, scene units.
    double at(double distanceView) const { return std::max(units(), share() * distanceView); }
    /// The part in scene units, with its bound.
    double units() const { return std::max(unitsView, leastUnitsView); }
    /// The part that is a share of the view distance, with its bound.
    double share() const { return std::max(shareView, leastShareView); }
    /// The target times a factor, which is a ratio, with the same bounds.
    StepTarget scaled(double factor) const;
};

/// What arithmetic before the depth buffer rounds away, as a share of the view distance. A finer step gains
/// nothing. float32 for mappings that form w in the vertex shader, float64 for anchored ones.
CDR_EXPORT double distanceRounding(Mapping mapping);

/// An upper bound, to first order, of the step at view distance w in a cascade (separationView()). For
/// anchored mappings also of what float32 rounds away of the distance to the anchor plane, 2^-24 of it. The
/// bound never falls as the cascade grows, so greedy fitting is optimal. separationView() itself jumps by a
/// factor of two where float32's exponent changes. Reversed counts as closed at far.
CDR_EXPORT double stepBoundView(const StepModel& model, const Cascade& cascade, double distanceView);

/// The largest share that stepBoundView() takes of the target in a cascade. It is at most 1 where the target
/// is met everywhere. 0 for a point.
CDR_EXPORT double worstStepShare(const StepModel& model, const StepTarget& target, const Cascade& cascade);

} // namespace cdr::depth
