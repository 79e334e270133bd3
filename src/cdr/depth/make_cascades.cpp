#include <cdr/base/error.h>
#include <cdr/depth/fitted_split.h>
#include <cdr/depth/make_cascades.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <variant>
#include <vector>

namespace cdr::depth {

namespace {

[[noreturn]] void throwTooMany(const Split& split, double cascades) {
    throw base::InputError(fmt::format("split {} gives {:.0f} cascades, at most {} are allowed",
                                       nameOf(split), cascades, kMaxCascades));
}

/// Cuts the camera's range at boundaries that ascend.
Cascades cutAt(const std::vector<double>& boundaries, const SplitContext& context) {
    Cascades cascades;
    double begin = context.nearView;
    for (const double boundary : boundaries) {
        // Rounding may make a boundary meet its neighbour; an empty cascade would divide by zero.
        if (boundary > begin && boundary < context.farView) {
            cascades.push_back({begin, boundary});
            begin = boundary;
        }
    }
    cascades.push_back({begin, context.farView});
    return cascades;
}

/// How each split cuts.
struct Cut {
    const SplitContext& context;

    Cascades operator()(const SplitNone&) const { return {{context.nearView, context.farView}}; }

    Cascades operator()(const SplitRatio& split) const {
        const double cascades =
            std::ceil(std::log(context.farView / context.nearView) / std::log(split.ratio));
        if (!(split.ratio > 1.0) || cascades > static_cast<double>(kMaxCascades)) {
            throwTooMany(split, cascades);
        }
        std::vector<double> boundaries;
        for (double b = context.nearView * split.ratio; b < context.farView; b *= split.ratio) {
            boundaries.push_back(b);
        }
        return cutAt(boundaries, context);
    }

    Cascades operator()(const SplitCount& split) const {
        std::vector<double> boundaries;
        for (unsigned i = 1; i < split.count; ++i) {
            boundaries.push_back(context.nearView * std::pow(context.farView / context.nearView,
                                                             static_cast<double>(i) / split.count));
        }
        return cutAt(boundaries, context);
    }

    Cascades operator()(const SplitAt& split) const { return cutAt(split.boundariesView, context); }

    Cascades operator()(const SplitMinimax& split) const { return minimaxCascades(split, context); }

    Cascades operator()(const SplitFitted& split) const {
        if (split.unit == SplitFitted::Unit::pixels && !(context.footprintSlope > 0.0)) {
            throw base::InputError("a split fitted to pixels needs to know what a pixel covers");
        }
        return fitCascades(split, context);
    }
};

} // namespace

void requireRange(double nearView, double farView) {
    if (!std::isfinite(nearView) || !std::isfinite(farView) || nearView <= 0.0 || farView <= nearView) {
        throw base::InputError(
            fmt::format("a split needs 0 < near < far, both finite, not near {} far {}", nearView, farView));
    }
    if (nearView < kLeastView || farView > kMostView) {
        throw base::InputError(fmt::format("near and far must lie from {:g} to {:g}, not near {} far {}",
                                           kLeastView, kMostView, nearView, farView));
    }
}

Cascades makeCascades(const Split& split, const SplitContext& context) {
    requireRange(context.nearView, context.farView);
    Cascades cascades = std::visit(Cut{context}, split);
    if (cascades.size() > kMaxCascades) {
        throwTooMany(split, static_cast<double>(cascades.size()));
    }
    return cascades;
}

} // namespace cdr::depth
