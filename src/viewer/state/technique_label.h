#pragma once

#include <cdr/base/quantity_text.h>
#include <cdr/depth/technique.h>
#include <cdr/render/frame.h>

#include <string>

namespace cdr::viewer {

/// "anchored, d32f": a technique's name, and its format.
std::string techniqueName(const depth::Technique& technique);

/// The smallest separation that a frame's own cascades are predicted to resolve at a view distance. It is
/// depth::Forecast::resolvedView(): a step of the buffer and two deviations of float32's roundings.
/// Infinity where no cascade holds the distance.
double techniqueStepView(const depth::Technique& technique, const depth::Cascades& cascades,
                         double distanceView);

/// "resolves 2.439 µm at 420 km"; where a step takes a good part of the way, that alone.
std::string resolvesText(double stepView, double distanceView, base::LengthUnit unit);

} // namespace cdr::viewer
