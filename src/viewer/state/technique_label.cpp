#include "technique_label.h"

#include "length_text.h"

#include <cdr/depth/forecast.h>
#include <cdr/depth/separation.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cdr::viewer {

std::string techniqueName(const depth::Technique& technique) {
    return fmt::format("{}, {}", depth::nameOf(technique), depth::nameOf(technique.format));
}

double techniqueStepView(const depth::Technique& technique, const depth::Cascades& cascades,
                         double distanceView) {
    const auto holds = [&](double overlap) {
        return std::find_if(cascades.begin(), cascades.end(), [&](const depth::Cascade& cascade) {
            return distanceView >= cascade.nearView * (1.0 - overlap) &&
                   distanceView <= cascade.farView * (1.0 + overlap);
        });
    };
    // What is drawn may lie beyond its cascade by an overlap.
    constexpr double kOverlap = 1e-4;
    const auto exact = holds(0.0);
    const auto holder = exact != cascades.end() ? exact : holds(kOverlap);
    if (holder == cascades.end()) {
        return std::numeric_limits<double>::infinity();
    }
    const bool isClosed = std::holds_alternative<depth::SplitFitted>(technique.split);
    const depth::DepthRange range =
        depth::depthRange(technique.mapping, cascades, static_cast<std::size_t>(holder - cascades.begin()),
                          isClosed ? depth::FarEnd::closed : depth::FarEnd::open);
    const double w = std::clamp(distanceView, holder->nearView, holder->farView);
    const depth::Forecast forecast{.cascades = cascades.size(),
                                   .bufferStepView = depth::separationView(range, technique.format, w),
                                   .rounding = depth::depthRounding(range, w)};
    return forecast.resolvedView();
}

std::string resolvesText(double stepView, double distanceView) {
    if (!std::isfinite(stepView)) {
        return fmt::format("tells nothing apart at {}", lengthText(distanceView));
    }
    if (stepView >= 0.1 * distanceView) {
        return fmt::format("a step is over a tenth of {}", lengthText(distanceView));
    }
    return fmt::format("tells {} apart at {}", stepText(stepView), lengthText(distanceView));
}

} // namespace cdr::viewer
