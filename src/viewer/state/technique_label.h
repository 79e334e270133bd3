#pragma once

#include <cdr/depth/technique.h>
#include <cdr/render/frame.h>

#include <string>

namespace cdr::viewer {

/// "anchored, d32f": a technique's name, and its format.
std::string techniqueName(const depth::Technique& technique);

/// The smallest separation that a frame's own cascades are predicted to resolve at a view distance
/// (depth::Forecast::resolvedView(): a step of the buffer and two deviations of float32's roundings).
/// Infinity where no cascade holds the distance.
double techniqueStepView(const depth::Technique& technique, const depth::Cascades& cascades,
                         double distanceView);

/// One side's label on a split screen: "anchored, d32f: tells 2.4 µm apart at 420.0013 km"; without the
/// second half where the distance is not finite.
std::string sideLabel(const depth::Technique& technique, const depth::Cascades& cascades,
                      double distanceView);

} // namespace cdr::viewer
