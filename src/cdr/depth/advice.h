#pragma once

/// @file
/// @errors None but those that a function names.
/// @units Distances, separations and spans are view distances in scene units.

#include <cdr/base/export.h>
#include <cdr/depth/forecast.h>

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace cdr::depth {

/// Names of the presets(), by what they need from an engine: a matrix, a flipped compare, a line in a shader, cascades,
/// cascades in float64.
inline constexpr std::array kSimplestFirst{"standard", "reversed", "log", "cdr", "logcdr", "anchored"};

/// What to find a technique for.
struct AdviceQuestion {
    ForecastScene scene;          ///< the camera, and what it looks at
    double separationView = 0.01; ///< smallest gap to tell apart at scene.atView; > 0
    std::vector<DepthFormat> formats{kDepthFormats.begin(),
                                     kDepthFormats.end()}; ///< that may be used; forecasts come for each
    /// Of the device, which explain() names. Only scene.subPixelBits goes into the numbers.
    unsigned subPixelBits = 8;
    /// To choose from, the preferred ones first, each in every format. Empty: kSimplestFirst. Then come anchored
    /// with a fifth of the separation as target, and anchored-reversed/fitted:1e-9, which is as fine as eight cascades allow.
    std::vector<Technique> techniques{};
};

/// Between which values a ratio lies.
struct RatioInterval {
    double low = 1.0;  ///< at least
    double high = 1.0; ///< at most
};

/// What was measured of a technique on a device, at the distance of the question.
struct Measurement {
    /// The smallest separation that came out right together with all larger ones; empty when the largest
    /// tried did not.
    std::optional<double> resolvedView;
    double largestView = 0.0;                   ///< tried; 0: none was, so that the forecast decides
    double timeRatio = 1.0;                     ///< frame time relative to standard: median of the ratios
    std::optional<RatioInterval> timeRatio95{}; ///< its 95 % interval; empty: there were too few frames
    /// No separation that was tried came out wrong, so that less than resolvedView may be resolved, as predicted.
    bool resolvesAll = false;
};

/// One technique, and how it answers.
struct CDR_EXPORT AdviceRow {
    Technique technique;                 ///< with its depth format
    Forecast forecast;                   ///< of it, for the question's scene
    std::optional<Measurement> measured; ///< on a device; empty: it was not tried
    bool suffices = false;               ///< as measured, else as predicted

    /// The smallest separation it resolves: as measured where there is a measurement, else as predicted. Never below a
    /// step of the depth buffer, nor below what snapping moves, where the question asks for it: measurements do not show that.
    double resolvedView() const;
};

/// The answer to an AdviceQuestion.
struct Advice {
    std::vector<AdviceRow> rows;         ///< simplest first, or in the order of AdviceQuestion::techniques
    std::optional<std::size_t> simplest; ///< the first technique that suffices, with the fewest cascades
    /// How deep the content around the distance may be so that the row `widest` still suffices, as predicted; 0 where no
    /// anchored technique of the rows does at any depth. Cascades come and go with the depth, so now and then content that is a
    /// little less deep is resolved worse.
    double widestSpanView = 0.0;
    std::optional<std::size_t> widest; ///< of the anchored ones, the one that resolves most
};

/// Forecasts each of the question's techniques in each of its formats.
/// @throws base::InputError for an unusable range, distance, content or separation.
CDR_EXPORT Advice advise(const AdviceQuestion& question);
/// The same, refused instead of thrown.
CDR_EXPORT base::Result<Advice> tryAdvise(const AdviceQuestion& question);

/// The same, with measurements in place of predictions.
/// @param measurements one per row of advise(question), empty where there is none.
/// @throws base::InputError as advise(question), and for another number of measurements.
CDR_EXPORT Advice advise(const AdviceQuestion& question,
                         const std::vector<std::optional<Measurement>>& measurements);
/// The same, refused instead of thrown.
CDR_EXPORT base::Result<Advice> tryAdvise(const AdviceQuestion& question,
                                          const std::vector<std::optional<Measurement>>& measurements);

/// What a technique needs from an engine and a device, in words.
CDR_EXPORT std::string costOf(const AdviceRow& row);

/// Writes a length, in scene units. What it throws comes through explain().
using LengthText = std::function<std::string(double)>;
/// Four significant digits, as the programs write a length without a unit.
CDR_EXPORT std::string plainLength(double view);

/// The advice in words, one sentence per line.
/// @param advice of advise(question), with a row at least: the question had a format.
CDR_EXPORT std::vector<std::string> explain(const AdviceQuestion& question, const Advice& advice,
                                            const LengthText& lengthText = plainLength);

} // namespace cdr::depth
