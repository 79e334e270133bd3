#pragma once

#include <cdr/depth/forecast.h>

#include <optional>
#include <string>
#include <vector>

namespace cdr::depth {

/// "Which technique do I need?"
struct AdviceQuestion {
    ForecastScene scene;
    double separationView = 0.01; ///< smallest gap to tell apart at scene.atView; > 0
    std::vector<DepthFormat> formats{kDepthFormats.begin(), kDepthFormats.end()};
};

struct AdviceRow {
    Technique technique;
    Forecast forecast;
    bool suffices = false;
};

struct Advice {
    std::vector<AdviceRow> rows;         ///< simplest first
    std::optional<std::size_t> simplest; ///< the first technique that suffices, with the fewest cascades
    /// How deep the content around the distance may be for anchored to resolve the separation in its at most
    /// eight cascades; 0 when it cannot be resolved at all.
    double widestSpanView = 0.0;
};

/// Forecasts every preset in every format, from the one projection matrix that standard takes to cascades
/// anchored in float64, and where the preset anchored is too coarse, anchored with its target set to the
/// separation. base::InputError for an unusable range, distance, content or separation.
Advice advise(const AdviceQuestion& question);

/// The advice in plain words, one sentence per line.
std::vector<std::string> explain(const AdviceQuestion& question, const Advice& advice);

} // namespace cdr::depth
