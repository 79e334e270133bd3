#include <cdr/base/number_text.h>
#include <cdr/depth/fitted_split.h>
#include <cdr/depth/make_cascades.h>

#include <cmath>
#include <variant>
#include <vector>

namespace cdr::depth {

namespace {

base::Refusal tooMany(const Split& split, double cascades) {
    return {base::concat("split ", nameOf(split), " gives ", base::fixed(cascades, 0), " cascades, at most ",
                         kMaxCascades, " are allowed")};
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

    base::Result<Cascades> operator()(const SplitNone&) const {
        return Cascades{{context.nearView, context.farView}};
    }

    base::Result<Cascades> operator()(const SplitRatio& split) const {
        // Roundings must not make one more, as thin as they are, where far is a whole number of ratios away.
        constexpr double kRounding = 1e-9;
        const double cascades =
            std::ceil(std::log(context.farView / context.nearView) / std::log(split.ratio) - kRounding);
        if (cascades > static_cast<double>(kMaxCascades)) {
            return tooMany(split, cascades);
        }
        std::vector<double> boundaries;
        double boundary = context.nearView;
        for (double i = 1.0; i < cascades; ++i) {
            boundary *= split.ratio;
            boundaries.push_back(boundary);
        }
        return cutAt(boundaries, context);
    }

    base::Result<Cascades> operator()(const SplitCount& split) const {
        std::vector<double> boundaries;
        for (unsigned i = 1; i < split.count; ++i) {
            boundaries.push_back(context.nearView * std::pow(context.farView / context.nearView,
                                                             static_cast<double>(i) / split.count));
        }
        return cutAt(boundaries, context);
    }

    base::Result<Cascades> operator()(const SplitAt& split) const {
        return cutAt(split.boundariesView, context);
    }

    base::Result<Cascades> operator()(const SplitMinimax& split) const {
        return minimaxCascades(split, context);
    }

    base::Result<Cascades> operator()(const SplitFitted& split) const {
        if (split.unit == SplitFitted::Unit::pixels && !(context.footprintSlope > 0.0)) {
            return base::Refusal{"a split fitted to pixels needs to know what a pixel covers"};
        }
        return fitCascades(split, context);
    }
};

} // namespace

std::optional<base::Refusal> rangeProblem(double nearView, double farView) {
    if (!std::isfinite(nearView) || !std::isfinite(farView) || nearView <= 0.0 || farView <= nearView) {
        return base::Refusal{
            base::concat("a split needs 0 < near < far, both finite, not near ", nearView, " far ", farView)};
    }
    if (nearView < kMinView || farView > kMaxView) {
        return base::Refusal{base::concat(
            "near and far must lie from ", base::general(kMinView), " to ", base::general(kMaxView),
            ", where float32 holds what shaders compute of them, not near ", nearView, " far ", farView)};
    }
    if (farView > kMaxFarOverNear * nearView) {
        return base::Refusal{base::concat("far must be at most ", base::general(kMaxFarOverNear),
                                          " times near, since shaders divide one by the other in float32, "
                                          "not near ",
                                          nearView, " far ", farView)};
    }
    return std::nullopt;
}

void requireRange(double nearView, double farView) {
    if (const auto problem = rangeProblem(nearView, farView)) {
        base::raise<base::InputError>(problem->message);
    }
}

Cascades makeCascades(const Split& split, const SplitContext& context) {
    return tryMakeCascades(split, context).orThrow();
}

base::Result<Cascades> tryMakeCascades(const Split& split, const SplitContext& context) {
    if (const auto problem = rangeProblem(context.nearView, context.farView)) {
        return *problem;
    }
    if (const auto problem = splitProblem(split)) {
        return *problem;
    }
    base::Result<Cascades> cascades = std::visit(Cut{context}, split);
    if (cascades && cascades->size() > kMaxCascades) {
        return tooMany(split, static_cast<double>(cascades->size()));
    }
    return cascades;
}

} // namespace cdr::depth
