#include <cdr/base/number_text.h>
#include <cdr/depth/forecast.h>
#include <cdr/depth/make_cascades.h>
#include <cdr/depth/separation.h>

#include <algorithm>
#include <cmath>

namespace cdr::depth {

namespace {

std::optional<base::Refusal> problemOf(const ForecastScene& scene) {
    if (auto problem = rangeProblem(scene.nearView, scene.farView)) {
        return problem;
    }
    if (!(scene.atView >= scene.nearView && scene.atView <= scene.farView)) {
        return base::Refusal{base::concat("the distance asked for must lie from near (", scene.nearView,
                                          ") to far (", scene.farView, "), not ", scene.atView)};
    }
    if (!(scene.spanView > 0.0) || !std::isfinite(scene.spanView)) {
        return base::Refusal{
            base::concat("the depth of what is visible must be above 0, not ", scene.spanView)};
    }
    if (scene.subPixelBits.value_or(0) > 32) {
        return base::Refusal{base::concat("sub-pixel bits must be 0 to 32, not ", *scene.subPixelBits)};
    }
    if (!(scene.slope >= 0.0) || !std::isfinite(scene.slope)) {
        return base::Refusal{base::concat("a slope must be finite and at least 0, not ", scene.slope)};
    }
    if (scene.subPixelBits && (!(scene.footprintSlope > 0.0) || !std::isfinite(scene.footprintSlope))) {
        return base::Refusal{base::concat("snapping needs to know what a pixel covers, not ",
                                          scene.footprintSlope, " of the distance")};
    }
    return std::nullopt;
}

} // namespace

Cascades forecastCascades(const Technique& technique, const ForecastScene& scene) {
    return tryForecastCascades(technique, scene).orThrow();
}

base::Result<Cascades> tryForecastCascades(const Technique& technique, const ForecastScene& scene) {
    if (const auto problem = problemOf(scene)) {
        return *problem;
    }
    const double half = 0.5 * scene.spanView;
    std::vector<Interval> content{{scene.atView - half, scene.atView + half}};
    if (scene.somethingNear) {
        content.push_back({scene.nearView, scene.nearView * 1.1});
    }
    return tryMakeCascades(technique.split, {.nearView = scene.nearView,
                                             .farView = scene.farView,
                                             .model = {technique.mapping, technique.format},
                                             .footprintSlope = scene.footprintSlope,
                                             .visible = content});
}

std::optional<Forecast> forecastIn(const Technique& technique, const Cascades& cascades,
                                   double distanceView) {
    const auto holds = [&](double overlap) {
        return std::find_if(cascades.begin(), cascades.end(), [&](const Cascade& cascade) {
            return distanceView >= cascade.nearView * (1.0 - overlap) &&
                   distanceView <= cascade.farView * (1.0 + overlap);
        });
    };
    constexpr double kOverlap = 1e-4;
    const auto exact = holds(0.0);
    const auto holder = exact != cascades.end() ? exact : holds(kOverlap);
    if (holder == cascades.end()) {
        return std::nullopt;
    }
    const DepthRange range =
        depthRange(technique.mapping, cascades, static_cast<std::size_t>(holder - cascades.begin()),
                   farEndOf(technique.split));
    const double w = std::clamp(distanceView, holder->nearView, holder->farView);
    return Forecast{.cascades = cascades.size(),
                    .bufferStepView = separationView(range, technique.format, w),
                    .rounding = depthRounding(range, w)};
}

double Forecast::resolvedView() const {
    // Two surfaces: the square root of 2. Two deviations lie closest to what `cdr probe` measures on lavapipe
    // over all techniques, formats and decades.
    return bufferStepView + 2.0 * std::sqrt(2.0) * rounding.deviationView();
}

Forecast forecast(const Technique& technique, const ForecastScene& scene) {
    return tryForecast(technique, scene).orThrow();
}

base::Result<Forecast> tryForecast(const Technique& technique, const ForecastScene& scene) {
    const auto made = tryForecastCascades(technique, scene);
    if (!made) {
        return made.refusal();
    }
    const Cascades& cascades = *made;
    const double w = scene.atView;
    const auto holder = std::find_if(cascades.begin(), cascades.end(),
                                     [&](const Cascade& cascade) { return w <= cascade.farView; });
    const Cascade& cascade = holder == cascades.end() ? cascades.back() : *holder;
    const FarEnd farEnd = cascades.end() - holder == 1 ? farEndOf(technique.split) : FarEnd::closed;
    const DepthRange range = depthRange(technique.mapping, cascade, farEnd);
    Forecast forecast{.cascades = cascades.size(),
                      .bufferStepView = separationView(range, technique.format, w),
                      .rounding = depthRounding(range, w)};
    if (scene.subPixelBits) {
        forecast.rounding.snapGapView =
            snapGapView(*scene.subPixelBits, scene.footprintSlope * w, scene.slope);
    }
    return forecast;
}

} // namespace cdr::depth
