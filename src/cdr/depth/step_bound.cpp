#include <cdr/depth/step_bound.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace cdr::depth {

namespace {

constexpr double kFloatRounding = 0x1p-24;
constexpr double kDoubleRounding = 0x1p-52;

/// An upper bound of the gap between stored depths around z that is smooth where float32's exponent changes.
double depthStepBound(DepthFormat format, double zNdc) {
    return format == DepthFormat::d32f ? std::min(zNdc * 0x1p-23, 0x1p-24) : depthStep(format, zNdc);
}

double logStepBound(DepthFormat format, const Cascade& c, double w) {
    const double logRatio = std::log(c.farView / c.nearView);
    const double z = std::log(w / c.nearView) / logRatio;
    return w * std::expm1(depthStepBound(format, z) * logRatio);
}

double linearStepBound(const StepModel& model, const Cascade& c, double w) {
    const double depth = c.farView - c.nearView;
    // Depth falls off as scale / w.
    const double scale = c.farView * c.nearView / depth;
    const double z = isReversed(model.mapping) ? c.nearView * (c.farView - w) / (depth * w)
                                               : c.farView * (w - c.nearView) / (depth * w);
    return w * w * depthStepBound(model.format, z) / scale;
}

double anchorDistance(Mapping mapping, const Cascade& c, double w) {
    return isReversed(mapping) ? c.farView - w : w - c.nearView;
}

} // namespace

StepTarget StepTarget::scaled(double factor) const {
    return {.unitsView = factor * unitsView,
            .shareView = factor * shareView,
            .leastUnitsView = leastUnitsView,
            .leastShareView = leastShareView};
}

double distanceRounding(Mapping mapping) {
    return isAnchored(mapping) ? kDoubleRounding : kFloatRounding;
}

double stepBoundView(const StepModel& model, const Cascade& cascade, double distanceView) {
    if (!(cascade.farView > cascade.nearView)) {
        return 0.0;
    }
    if (isLog(model.mapping)) {
        return logStepBound(model.format, cascade, distanceView);
    }
    const double step = linearStepBound(model, cascade, distanceView);
    return isAnchored(model.mapping)
               ? std::max(step, kFloatRounding * anchorDistance(model.mapping, cascade, distanceView))
               : step;
}

double worstStepShare(const StepModel& model, const StepTarget& target, const Cascade& cascade) {
    const double n = cascade.nearView;
    const double f = cascade.farView;
    const auto share = [&](double w) { return stepBoundView(model, cascade, w) / target.at(w); };
    if (!isReversed(model.mapping)) {
        return share(f); // steps grow at least as fast as targets do
    }
    // Reversed steps rise, then fall. Their share of the target peaks at an end, where depth falls below 1/2, or at half
    // the far plane's distance. Or it peaks where the target turns from units to a share of the distance.
    const double turn = target.share() > 0.0 ? target.units() / target.share() : f;
    double worst = 0.0;
    for (const double w : std::array{n, 2.0 * f * n / (f + n), 0.5 * f, turn, f}) {
        worst = std::max(worst, share(std::clamp(w, n, f)));
    }
    return worst;
}

} // namespace cdr::depth
