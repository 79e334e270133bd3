#include <cdr/base/number_text.h>
#include <cdr/base/quantity_text.h>
#include <cdr/depth/advice.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace cdr::depth {

namespace {

/// Fitted steps per separation. One is for the buffer. Each of the two surfaces takes two more, because a gap
/// between float32 values is up to two steps.
constexpr double kStepsPerSeparation = 5.0;

/// A target that rounds to 0 would be none.
constexpr double kLeastTarget = std::numeric_limits<double>::denorm_min();

/// As fine as eight cascades allow, for detail at one distance. No visible content reaches its target.
constexpr const char* kFinest = "anchored-reversed/fitted:1e-9";

Technique anchoredFor(double separationView, DepthFormat format) {
    return Technique{Mapping::anchored,
                     SplitFitted{.target = std::max(separationView / kStepsPerSeparation, kLeastTarget),
                                 .unit = SplitFitted::Unit::scene},
                     format};
}

bool resolves(const Technique& technique, const ForecastScene& scene, double separationView) {
    const auto made = tryForecast(technique, scene);
    return made && made->resolvedView() <= separationView;
}

bool fitsSpan(const Technique& technique, const AdviceQuestion& question, double spanView) {
    ForecastScene scene = question.scene;
    scene.spanView = spanView;
    return resolves(technique, scene, question.separationView);
}

/// How deep the content may be so that a technique resolves the separation; 0 where neither the depth that was asked for nor a
/// thin one is resolved.
double widestSpan(const Technique& technique, const AdviceQuestion& question) {
    const auto fits = [&](double span) { return fitsSpan(technique, question, span); };
    double low = 1e-9 * question.scene.atView;
    double high = 2.0 * question.scene.farView;
    const double asked = question.scene.spanView;
    if (fits(asked)) { // where thinner content may not, by fewer cascades
        low = asked;
    } else if (fits(low)) {
        high = std::min(high, asked);
    } else {
        return 0.0;
    }
    if (fits(high)) {
        return std::max(low, high);
    }
    constexpr int kMaxBisections = 64; // more than float64's whole range takes
    for (int i = 0; i < kMaxBisections && high > 1.01 * low; ++i) {
        const double middle = std::sqrt(low * high);
        (fits(middle) ? low : high) = middle;
    }
    return low;
}

bool isSameInAnyFormat(const Technique& a, const Technique& b) {
    return a.mapping == b.mapping && a.split == b.split;
}

/// The first technique that suffices, in the format in which it takes the fewest cascades.
std::optional<std::size_t> simplestOf(const std::vector<AdviceRow>& rows) {
    std::optional<std::size_t> simplest;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const bool better = !simplest || (isSameInAnyFormat(rows[i].technique, rows[*simplest].technique) &&
                                          rows[i].forecast.cascades < rows[*simplest].forecast.cascades);
        if (rows[i].suffices && better) {
            simplest = i;
        }
    }
    return simplest;
}

/// Of the anchored row that resolves most. A row whose measurement contradicts its forecast is left out: that is of one depth
/// alone.
void findWidest(const AdviceQuestion& question, Advice& advice) {
    advice.widest.reset();
    advice.widestSpanView = 0.0;
    for (std::size_t i = 0; i < advice.rows.size(); ++i) {
        const AdviceRow& row = advice.rows[i];
        const bool isForecast = row.suffices == (row.forecast.resolvedView() <= question.separationView);
        if (isAnchored(row.technique.mapping) && isForecast &&
            (!advice.widest ||
             row.forecast.resolvedView() < advice.rows[*advice.widest].forecast.resolvedView())) {
            advice.widest = i;
        }
    }
    if (advice.widest) {
        advice.widestSpanView = widestSpan(advice.rows[*advice.widest].technique, question);
    }
    if (!(advice.widestSpanView > 0.0)) {
        advice.widest.reset();
    }
}

/// What a row resolves: as measured, unless snapping moves more, which no measurement shows. Else as predicted.
std::string resolvesText(const AdviceRow& row, const LengthText& lengthText) {
    const bool isMeasured = row.measured && row.measured->resolvedView >= row.forecast.rounding.snapGapView &&
                            row.measured->resolvedView <= row.resolvedView();
    return isMeasured ? base::concat("was measured to resolve ", lengthText(*row.measured->resolvedView))
                      : base::concat("resolves ", lengthText(row.resolvedView()));
}

/// Whether steps are most of what a row resolves. Roundings add the rest of what was measured.
bool isLimitedBySteps(const AdviceRow& row) {
    const double step = row.forecast.bufferStepView;
    const double gap = row.forecast.rounding.distanceGapView;
    if (row.measured && row.measured->resolvedView) {
        const double resolved = row.resolvedView();
        if (step == resolved || (step > gap && 2.0 * step >= resolved)) {
            return true;
        }
    }
    return step >= 4.0 * gap;
}

std::string limitOf(const AdviceRow& row) {
    const bool isBeyondMeasured = row.measured && row.forecast.rounding.snapGapView == row.resolvedView();
    if (isBeyondMeasured ||
        row.forecast.rounding.snapGapView >
            std::max(row.forecast.bufferStepView, row.forecast.rounding.distanceGapView)) {
        return "the snapping of vertices to sub-pixels";
    }
    if (isLimitedBySteps(row)) {
        return "the steps of the depth buffer";
    }
    return isAnchored(row.technique.mapping) ? "float32 distances to the anchor plane"
                                             : "float32 view distances";
}

/// What snapping does to the question's surfaces; empty where it is far below the separation.
std::string snappingLine(const AdviceQuestion& question, const LengthText& lengthText) {
    const ForecastScene& scene = question.scene;
    const unsigned bits = scene.subPixelBits.value_or(question.subPixelBits);
    DepthRounding snapped;
    snapped.snapGapView = snapGapView(bits, scene.footprintSlope * scene.atView, scene.slope);
    const double reach = 2.0 * snapped.worstView();
    if (reach < 0.1 * question.separationView) {
        return "";
    }
    return base::concat(scene.subPixelBits ? "Vertices snap to " : "If vertices snap to ", bits,
                        scene.subPixelBits ? " sub-pixel bits: faces of slope "
                                           : " sub-pixel bits, faces of slope ",
                        base::general(scene.slope, 3), " with different outlines may swap below a gap of ",
                        lengthText(reach), ". With --snapping in-plane, flat facets do not.");
}

std::string describe(const AdviceRow& row) {
    const std::string cascades =
        row.forecast.cascades == 1 ? "one cascade" : base::concat(row.forecast.cascades, " cascades");
    return base::concat(nameOf(row.technique), " with ", nameOf(row.technique.format), " in ", cascades);
}

/// What the row costs over standard.
std::string costLine(const AdviceRow& row) {
    if (!row.measured) {
        return base::concat("Cost over standard: ", costOf(row), ".");
    }
    const Measurement& measured = *row.measured;
    const auto percent = [](double ratio) {
        const double more = 100.0 * (ratio - 1.0);
        return base::concat(more > 0.0 ? "+" : "", base::quantityText(more, base::NumberStyle::plain));
    };
    const auto& interval = measured.timeRatio95;
    return base::concat(
        "Cost over standard: ", costOf(row), "; measured, ", percent(measured.timeRatio), " % of a frame",
        interval ? base::concat(" (", percent(interval->low), " to ", percent(interval->high), ")") : "",
        ".");
}

/// Those of a question that names none.
std::vector<Technique> defaultTechniques(double separationView) {
    std::vector<Technique> techniques;
    for (const char* name : kSimplestFirst) {
        techniques.push_back(parseTechnique(name));
    }
    techniques.push_back(anchoredFor(separationView, DepthFormat::d32f));
    techniques.push_back(parseTechnique(kFinest));
    return techniques;
}

/// What advise() makes a row of each.
std::vector<Technique> techniquesFor(const AdviceQuestion& question) {
    std::vector<Technique> techniques;
    for (Technique technique :
         question.techniques.empty() ? defaultTechniques(question.separationView) : question.techniques) {
        for (const DepthFormat format : question.formats) {
            technique.format = format;
            techniques.push_back(technique);
        }
    }
    return techniques;
}

} // namespace

double AdviceRow::resolvedView() const {
    if (!measured) {
        return forecast.resolvedView();
    }
    // Beyond the separations tried there is only the prediction: it is at least the largest where that came out wrong, and at
    // most the smallest where all came out right. What was measured has outlines alike, which snap alike: that says nothing of
    // surfaces whose outlines differ. And one picture may have gaps below a step of the buffer in order by luck.
    const double predicted = forecast.resolvedView();
    double resolved = measured->resolvedView.value_or(std::max(predicted, measured->largestView));
    if (measured->resolvesAll) {
        resolved = std::min(resolved, predicted);
    }
    return std::max({resolved, forecast.bufferStepView, forecast.rounding.snapGapView});
}

Advice advise(const AdviceQuestion& question) {
    return tryAdvise(question).orThrow();
}

base::Result<Advice> tryAdvise(const AdviceQuestion& question) {
    if (!(question.separationView > 0.0) || !std::isfinite(question.separationView)) {
        return base::Refusal{
            base::concat("separation must be finite and above 0, not ", question.separationView)};
    }
    if (question.formats.empty()) {
        return base::Refusal{"there is no depth format to advise on"};
    }
    Advice advice;
    for (const Technique& technique : techniquesFor(question)) {
        const auto made = tryForecast(technique, question.scene);
        if (!made) {
            return made.refusal();
        }
        advice.rows.push_back({.technique = technique,
                               .forecast = *made,
                               .measured = std::nullopt,
                               .suffices = made->resolvedView() <= question.separationView});
    }
    advice.simplest = simplestOf(advice.rows);
    findWidest(question, advice);
    return advice;
}

Advice advise(const AdviceQuestion& question, const std::vector<std::optional<Measurement>>& measurements) {
    return tryAdvise(question, measurements).orThrow();
}

base::Result<Advice> tryAdvise(const AdviceQuestion& question,
                               const std::vector<std::optional<Measurement>>& measurements) {
    base::Result<Advice> forecast = tryAdvise(question);
    if (!forecast) {
        return forecast;
    }
    Advice advice = std::move(forecast).orThrow();
    if (measurements.size() != advice.rows.size()) {
        return base::Refusal{
            base::concat(measurements.size(), " measurements for ", advice.rows.size(), " techniques")};
    }
    for (std::size_t i = 0; i < advice.rows.size(); ++i) {
        AdviceRow& row = advice.rows[i];
        row.measured = measurements[i];
        const bool failed = row.measured && !row.measured->resolvedView &&
                            row.measured->largestView >= question.separationView;
        row.suffices = !failed && row.resolvedView() <= question.separationView;
    }
    advice.simplest = simplestOf(advice.rows);
    findWidest(question, advice);
    return advice;
}

std::string costOf(const AdviceRow& row) {
    std::string cost = isLog(row.technique.mapping)        ? "logarithm per vertex"
                       : isAnchored(row.technique.mapping) ? "float64 offset per object"
                       : isReversed(row.technique.mapping) ? "flipped compare"
                                                           : "";
    if (isAnchored(row.technique.mapping) && isReversed(row.technique.mapping)) {
        cost += ", flipped compare";
    }
    if (row.forecast.cascades > 1) {
        const std::size_t clears = row.forecast.cascades - 1;
        cost += base::concat(cost.empty() ? "" : ", ", clears, " more depth clear", clears == 1 ? "" : "s");
    }
    return cost.empty() ? "nothing" : cost;
}

std::string plainLength(double view) {
    return base::quantityText(view, base::NumberStyle::plain);
}

std::vector<std::string> explain(const AdviceQuestion& question, const Advice& advice,
                                 const LengthText& lengthText) {
    std::vector<std::string> lines;
    const double at = question.scene.atView;
    if (advice.simplest) {
        const AdviceRow& row = advice.rows[*advice.simplest];
        lines.push_back(base::concat(describe(row), " is enough: it ", resolvesText(row, lengthText), " at ",
                                     lengthText(at), ", and ", lengthText(question.separationView),
                                     " is asked for."));
        lines.push_back(costLine(row));
        if (row.forecast.cascades > 1) {
            lines.emplace_back("Objects that cross a boundary between cascades are drawn once more.");
        }
        if (row.technique.mapping == Mapping::anchoredReversed) {
            lines.emplace_back(
                "It suits detail at one distance: its steps grow with the range that is visible.");
        }
        if (isLog(row.technique.mapping)) {
            lines.emplace_back(
                "Set depth per fragment on triangles that span more than 2 % of their distance.");
        }
    } else {
        const AdviceRow& best = *std::ranges::min_element(advice.rows, {}, &AdviceRow::resolvedView);
        lines.push_back(base::concat("Nothing here resolves ", lengthText(question.separationView), " at ",
                                     lengthText(at), ": ", describe(best), " resolves only ",
                                     lengthText(best.resolvedView()), ", limited by ", limitOf(best), "."));
    }
    const bool needsAnchored =
        !advice.simplest || isAnchored(advice.rows[*advice.simplest].technique.mapping);
    if (needsAnchored && advice.widest) {
        const Technique& widest = advice.rows[*advice.widest].technique;
        lines.push_back(base::concat(nameOf(widest), " with ", nameOf(widest.format),
                                     " resolves it if what is visible there has a depth of at most ",
                                     lengthText(advice.widestSpanView), "."));
    }
    if (const std::string line = snappingLine(question, lengthText); !line.empty()) {
        lines.push_back(line);
    }
    if (at * 0x1p-52 > 0.1 * question.separationView) {
        lines.push_back(base::concat("float64 positions themselves are ", lengthText(at * 0x1p-52),
                                     " apart at ", lengthText(at), "."));
    }
    return lines;
}

} // namespace cdr::depth
