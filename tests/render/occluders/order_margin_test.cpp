#include <cdr/depth/forecast.h>
#include <cdr/render/occluders/order_margin.h>

#include <gtest/gtest.h>

#include <cmath>

namespace cdr::render_test {

namespace {

constexpr double kNearest = 1e-6;
constexpr double kFarthest = 1e24;
constexpr std::size_t kNode = 300; ///< with thin cascades about it and the next one
constexpr double kThin = 1e-4;     ///< of the distance

double distanceOf(double node, const render::OrderMargin& margin) {
    return kNearest * std::exp(node / margin.nodesPerRatio());
}

render::FrameView viewOfCascades(depth::Mapping mapping, const depth::Cascades& cascades) {
    render::FrameView view;
    view.camera.nearView = kNearest;
    view.camera.farView = kFarthest;
    view.cascades = render::cascadeViews(mapping, cascades, cascades, depth::FarEnd::closed, {64, 64});
    return view;
}

/// A wide cascade between two nodes, the second of which lies in a thin one. So does the first, or it begins the wide one.
TEST(OrderMargin, HoldsInACascadeBetweenItsNodes) {
    using depth::Mapping;
    for (const Mapping mapping : {Mapping::standard, Mapping::anchored, Mapping::anchoredReversed}) {
        for (const depth::DepthFormat format : depth::kDepthFormats) {
            const depth::Technique technique{
                .mapping = mapping, .split = depth::SplitNone{}, .format = format};
            const render::OrderMargin nodes(technique, viewOfCascades(mapping, {{kNearest, kFarthest}}));
            const double first = distanceOf(kNode, nodes);
            const double second = distanceOf(kNode + 1, nodes);
            for (const bool isFirstThin : {true, false}) {
                depth::Cascades cascades{{kNearest, first * (1.0 - kThin)}};
                if (isFirstThin) {
                    cascades.push_back({first * (1.0 - kThin), first * (1.0 + kThin)});
                }
                cascades.push_back({cascades.back().farView, second * (1.0 - kThin)});
                cascades.push_back({second * (1.0 - kThin), second * (1.0 + kThin)});
                cascades.push_back({second * (1.0 + kThin), kFarthest});
                const render::OrderMargin margin(technique, viewOfCascades(mapping, cascades));
                for (double place = kNode - 1.5; place < kNode + 2.5; place += 1.0 / 512.0) {
                    const double distance = distanceOf(place, margin);
                    const auto forecast = depth::forecastIn(technique, cascades, distance);
                    ASSERT_TRUE(forecast.has_value());
                    ASSERT_GE(margin.at(distance), forecast->guaranteedView())
                        << nameOf(technique) << " " << isFirstThin << " " << place;
                }
            }
        }
    }
}

} // namespace

} // namespace cdr::render_test
