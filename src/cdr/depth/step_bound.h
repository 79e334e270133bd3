#pragma once

#include <cdr/depth/cascade.h>
#include <cdr/depth/format.h>
#include <cdr/depth/mapping.h>

#include <algorithm>

namespace cdr::depth {

/// What turns a cascade into steps.
struct StepModel {
    Mapping mapping = Mapping::standard;
    DepthFormat format = DepthFormat::d32f;
};

/// The largest step to allow, in scene units and as a share of the view distance, whichever is wider.
/// The least ones stay when a target is scaled: no step need be finer.
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

/// What the arithmetic before the depth buffer rounds away, as a share of the view distance: steps below gain
/// nothing. float32 for mappings that form w in the vertex shader, float64 for anchored ones.
double distanceRounding(Mapping mapping);

/// An upper bound of the step at view distance w in a cascade: what separationView() saws below, to first
/// order, and for anchored mappings what float32 rounds away of the distance to the anchor plane
/// (2^-24 of it). It never falls as the cascade grows, which is what makes greedy fitting optimal;
/// separationView() itself saws by a factor of two with float32's binades. Reversed counts as closed at far.
double stepBoundView(const StepModel& model, const Cascade& cascade, double distanceView);

/// The largest share that stepBoundView() takes of the target in a cascade; at most 1 where the target is met
/// everywhere. 0 for a point.
double worstStepShare(const StepModel& model, const StepTarget& target, const Cascade& cascade);

} // namespace cdr::depth
