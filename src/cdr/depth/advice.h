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

/// What a device showed of a technique at the distance asked for.
struct Measurement {
    /// The smallest separation that, with all larger ones, came out right; empty when the largest tried did
    /// not.
    std::optional<double> resolvedView;
    double largestView = 0.0; ///< tried
    /// Frame time over that of standard: median of the ratios and their 95 % interval.
    double timeRatio = 1.0;
    double timeRatioLow = 1.0;
    double timeRatioHigh = 1.0;
};

struct AdviceRow {
    Technique technique;
    Forecast forecast;
    std::optional<Measurement> measured;
    bool suffices = false; ///< by what was measured, else by what is predicted

    /// The smallest separation it resolves: measured where a measurement tells, else predicted.
    double resolvedView() const;
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

/// The advice where a device has the last word.
/// @param measurements one per row of advise(question), empty where there is none; base::InputError for
/// another number.
Advice advise(const AdviceQuestion& question, const std::vector<std::optional<Measurement>>& measurements);

/// What a technique asks of an engine and a device, in plain words.
std::string costOf(const AdviceRow& row);

/// The advice in plain words, one sentence per line.
std::vector<std::string> explain(const AdviceQuestion& question, const Advice& advice);

} // namespace cdr::depth
