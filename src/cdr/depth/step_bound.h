#pragma once

#include <cdr/depth/cascade.h>
#include <cdr/depth/format.h>
#include <cdr/depth/mapping.h>

#include <algorithm>

namespace cdr::depth {

/// What the step between two stored depths depends on, beside the cascade.
struct StepModel {
    Mapping mapping = Mapping::standard;
    DepthFormat format = DepthFormat::d32f;
};

/// The largest step to allow: the wider of scene units and a share of the view distance. The least ones bound
/// it from below, since a finer step gains nothing, and stay when the target is scaled.
struct StepTarget {
    double unitsView = 0.0;
    double shareView = 0.0;      ///< as a pixel's footprint is
    double leastUnitsView = 0.0; ///< what float32 makes of the vertices of the smallest object
    double leastShareView = 0.0; ///< distanceRounding()

    double at(double distanceView) const { return std::max(units(), share() * distanceView); }
    double units() const { return std::max(unitsView, leastUnitsView); }
    double share() const { return std::max(shareView, leastShareView); }
    StepTarget scaled(double factor) const;
};

/// What arithmetic before the depth buffer rounds away, as a share of the view distance; a finer step gains
/// nothing. float32 for mappings that form w in the vertex shader, float64 for anchored ones.
double distanceRounding(Mapping mapping);

/// An upper bound, to first order, of the step at view distance w in a cascade (separationView()). For
/// anchored mappings also of what float32 rounds away of the distance to the anchor plane, 2^-24 of it. The
/// bound never falls as the cascade grows, so greedy fitting is optimal. separationView() itself jumps by a
/// factor of two where float32's exponent changes. Reversed counts as closed at far.
double stepBoundView(const StepModel& model, const Cascade& cascade, double distanceView);

/// The largest share that stepBoundView() takes of the target in a cascade; at most 1 where the target is met
/// everywhere. 0 for a point.
double worstStepShare(const StepModel& model, const StepTarget& target, const Cascade& cascade);

} // namespace cdr::depth
