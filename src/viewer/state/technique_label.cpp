#include "technique_label.h"

#include <cdr/depth/forecast.h>

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace cdr::viewer {

std::string techniqueName(const depth::Technique& technique) {
    return fmt::format("{}, {}", depth::nameOf(technique), depth::nameOf(technique.format));
}

double techniqueStepView(const depth::Technique& technique, const depth::Cascades& cascades,
                         double distanceView) {
    const auto forecast = depth::forecastIn(technique, cascades, distanceView);
    return forecast ? forecast->resolvedView() : std::numeric_limits<double>::infinity();
}

std::string resolvesText(double stepView, double distanceView, base::LengthUnit unit) {
    const std::string distance = base::quantityText(distanceView, unit);
    if (!std::isfinite(stepView)) {
        return "resolves nothing at " + distance;
    }
    if (stepView >= 0.1 * distanceView) {
        return "a step is over a tenth of " + distance;
    }
    return fmt::format("resolves {} at {}", base::quantityText(stepView, unit), distance);
}

} // namespace cdr::viewer
