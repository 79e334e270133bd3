#include <cdr/base/error.h>
#include <cdr/depth/forecast.h>
#include <cdr/depth/make_cascades.h>
#include <cdr/depth/separation.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cdr::depth {

namespace {

void requireUsable(const ForecastScene& scene) {
    requireRange(scene.nearView, scene.farView);
    if (!(scene.atView >= scene.nearView && scene.atView <= scene.farView)) {
        throw base::InputError(
            fmt::format("the distance asked for must lie from near ({}) to far ({}), not {}", scene.nearView,
                        scene.farView, scene.atView));
    }
    if (!(scene.spanView > 0.0) || !std::isfinite(scene.spanView)) {
        throw base::InputError(
            fmt::format("the depth of what is visible must be above 0, not {}", scene.spanView));
    }
}

} // namespace

Cascades forecastCascades(const Technique& technique, const ForecastScene& scene) {
    requireUsable(scene);
    const double half = 0.5 * scene.spanView;
    std::vector<Interval> content{{scene.atView - half, scene.atView + half}};
    if (scene.somethingNear) {
        content.push_back({scene.nearView, scene.nearView * 1.1});
    }
    return makeCascades(technique.split, {.nearView = scene.nearView,
                                          .farView = scene.farView,
                                          .model = {technique.mapping, technique.format},
                                          .footprintSlope = scene.footprintSlope,
                                          .visible = content});
}

double Forecast::resolvedView() const {
    // Two surfaces: the square root of 2. Two deviations lie closest to what `cdr probe` measures on lavapipe
    // over all techniques, formats and decades.
    return bufferStepView + 2.0 * std::sqrt(2.0) * rounding.deviationView();
}

Forecast forecast(const Technique& technique, const ForecastScene& scene) {
    const Cascades cascades = forecastCascades(technique, scene);
    const double w = scene.atView;
    const auto holder = std::find_if(cascades.begin(), cascades.end(),
                                     [&](const Cascade& cascade) { return w <= cascade.farView; });
    const Cascade& cascade = holder == cascades.end() ? cascades.back() : *holder;
    const bool open = technique.mapping == Mapping::reversed && cascades.end() - holder == 1 &&
                      !std::holds_alternative<SplitFitted>(technique.split);
    const DepthRange range{.mapping = technique.mapping,
                           .nearView = cascade.nearView,
                           .farView = open ? std::nullopt : std::optional(cascade.farView)};
    return {.cascades = cascades.size(),
            .bufferStepView = separationView(range, technique.format, w),
            .rounding = depthRounding(range, w)};
}

} // namespace cdr::depth
