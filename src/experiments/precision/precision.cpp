#include "precision.h"

#include <cdr/depth/make_cascades.h>
#include <cdr/depth/separation.h>
#include <cdr/depth/step_bound.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace cdr::experiments {

namespace {

constexpr int kThesisBits = 24;
constexpr std::array<double, 4> kThesisSeparations{0.001, 0.01, 0.1, 1.0};

/// Table 4.1, near 0.001, far 10^8.
struct ThesisRow {
    const char* technique;
    std::array<double, 4> distancesView;
};
constexpr std::array<ThesisRow, 4> kThesisTable{{
    {"standard", {4.096, 12.958, 41.010, 130.028}},
    {"cdr", {129.592, 409.810, 40980.545, 129592.205}},
    {"log", {662.386, 6623.860, 66238.604, 662386.037}},
    {"logcdr", {2428.750, 24287.501, 242875.013, 3643125.454}},
}};

std::optional<double> thesisValue(const std::string& technique, double separation,
                                  const PrecisionOptions& options) {
    if (options.nearView != 0.001 || options.farView != 1e8) {
        return std::nullopt;
    }
    for (const ThesisRow& row : kThesisTable) {
        for (std::size_t i = 0; i < kThesisSeparations.size(); ++i) {
            if (technique == row.technique && separation == kThesisSeparations[i]) {
                return row.distancesView[i];
            }
        }
    }
    return std::nullopt;
}

using Curve = std::function<double(double distanceView)>;

/// One of each separation.
std::vector<PrecisionCell> makeCells(const std::string& technique, const std::string& format,
                                     const Curve& curve, const PrecisionOptions& options) {
    const auto crossings =
        depth::findCrossings(curve, options.separations, options.nearView, options.farView);
    std::vector<PrecisionCell> cells;
    for (std::size_t i = 0; i < crossings.size(); ++i) {
        const auto& crossing = crossings[i];
        cells.push_back({.technique = technique,
                         .format = format,
                         .separation = options.separations[i],
                         .reachedFirstView =
                             crossing ? crossing->reachedFirstView : std::numeric_limits<double>::infinity(),
                         .heldLastView = crossing ? crossing->heldLastView : options.farView,
                         .thesisView = std::nullopt});
    }
    return cells;
}

/// The curve of a technique as the thesis computes it; none for techniques it does not have.
std::optional<Curve> thesisCurve(const depth::Technique& technique, const PrecisionOptions& options) {
    const depth::Mapping mapping = technique.mapping;
    if (mapping != depth::Mapping::standard && mapping != depth::Mapping::log) {
        return std::nullopt;
    }
    const depth::Cascades cascades =
        depth::makeCascades(technique.split, {.nearView = options.nearView, .farView = options.farView});
    return [=](double w) { return depth::thesisSeparationView(mapping, cascades, kThesisBits, w); };
}

/// The exact step of the buffer over distance. A fitted split is given objects of options.spanView around
/// each distance; its steps are those of that one cascade at its far end.
Curve exactCurve(const depth::Technique& technique, depth::DepthFormat format,
                 const PrecisionOptions& options) {
    const depth::Mapping mapping = technique.mapping;
    if (!std::holds_alternative<depth::SplitFitted>(technique.split)) {
        const depth::Cascades cascades =
            depth::makeCascades(technique.split, {.nearView = options.nearView, .farView = options.farView});
        return [=](double w) { return depth::separationView(mapping, cascades, format, w); };
    }
    return [=](double w) {
        const depth::Cascade cascade{std::max(w - options.spanView, 0.5 * w), w};
        return depth::stepBoundView({mapping, format}, cascade, w);
    };
}

void addTable(const std::string& technique, const Curve& curve, const PrecisionOptions& options,
              PrecisionResult& result) {
    for (PrecisionCell& cell : makeCells(technique, "d24", curve, options)) {
        cell.thesisView = thesisValue(technique, cell.separation, options);
        result.table.push_back(std::move(cell));
    }
}

/// Figure 4.1's own grid: a tenth more at every point (Listing A.2).
std::vector<double> figureGrid(const PrecisionOptions& options) {
    std::vector<double> grid;
    for (double w = options.nearView * 2.1; w < options.farView; w *= 1.1) {
        grid.push_back(w);
    }
    grid.push_back(options.farView);
    return grid;
}

} // namespace

PrecisionResult runPrecision(const PrecisionOptions& options) {
    PrecisionResult result;
    std::vector<Curve> curves;
    for (const auto& [name, technique] : depth::presets()) {
        for (const depth::DepthFormat format : depth::kDepthFormats) {
            const auto cells =
                makeCells(name, std::string(nameOf(format)), exactCurve(technique, format, options), options);
            result.byFormat.insert(result.byFormat.end(), cells.begin(), cells.end());
        }
        const std::optional<Curve> thesis = thesisCurve(technique, options);
        if (thesis) {
            addTable(name, *thesis, options, result);
        }
        result.curveNames.push_back(name);
        curves.push_back(thesis ? *thesis : exactCurve(technique, depth::DepthFormat::d32f, options));
    }
    for (const double w : figureGrid(options)) {
        PrecisionPoint point{.distanceView = w, .separations = {}};
        for (const Curve& curve : curves) {
            point.separations.push_back(curve(w));
        }
        result.curve.push_back(point);
    }
    return result;
}

} // namespace cdr::experiments
