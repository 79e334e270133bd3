#include <cdr/depth/rounding.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace cdr::depth {

namespace {

/// Roundings to a depth, as the header counts them.
unsigned depthRoundings(const DepthRange& range) {
    switch (range.mapping) {
    case Mapping::log:
        return 5;
    case Mapping::logFragment:
        return 3;
    default:
        return range.farView ? 3 : 2;
    }
}

} // namespace

double floatGap(double value) {
    constexpr double kMin = std::numeric_limits<float>::min();
    return std::exp2(std::floor(std::log2(std::max(value, kMin))) - 23.0);
}

double snapGapView(unsigned subPixelBits, double footprintView, double slope) {
    return slope * footprintView * std::exp2(-static_cast<double>(subPixelBits));
}

double DepthRounding::deviationView() const {
    // A uniform error as wide as a gap has a variance of a twelfth of its square.
    // Across a slope only one direction of the snapping counts.
    return std::sqrt((distanceRoundings * distanceGapView * distanceGapView +
                      depthRoundings * depthGapView * depthGapView + snapGapView * snapGapView) /
                     12.0);
}

double DepthRounding::worstView() const {
    // Along the diagonal both directions of the snapping add up.
    return 0.5 * (distanceRoundings * distanceGapView + depthRoundings * depthGapView +
                  std::numbers::sqrt2 * snapGapView);
}

DepthRounding depthRounding(const DepthRange& range, double distanceView) {
    const double distance = isAnchored(range.mapping) ? *range.farView - range.nearView : distanceView;
    const double below1 = 1.0 - 0x1p-24; // depths are less than 1, whose own gap is twice as wide
    const double z = std::clamp(zNdcAt(range, distanceView), 0.0, below1);
    return {.distanceGapView = floatGap(distance),
            .distanceRoundings = range.mapping == Mapping::logFragment ? 4u : 2u,
            .depthGapView = floatGap(z) / depthSlope(range, distanceView),
            .depthRoundings = depthRoundings(range),
            .snapGapView = 0.0};
}

} // namespace cdr::depth
