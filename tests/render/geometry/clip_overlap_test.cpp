#include <cdr/render/frame_view.h>
#include <cdr/render/geometry/geometry_pipelines.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace cdr::render {

namespace {

/// An edge that is as long as draws which clip distances cut may be, and where two cascades meet on it.
struct ClippedEdge {
    double centreView = 0.0;
    float from = 0.0f; ///< beyond the centre
    float to = 0.0f;
    double meetView = 0.0;

    double viewAt(double share) const {
        return centreView + double{from} + share * (double{to} - double{from});
    }
};

ClippedEdge clippedEdge(double span, std::mt19937_64& random) {
    const auto uniform = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    const double nearView = std::pow(10.0, uniform(-1.0, 8.0));
    const double half = 0.5 * span * nearView;
    ClippedEdge edge{.centreView = nearView + half,
                     .from = static_cast<float>(-half),
                     .to = static_cast<float>(half),
                     .meetView = 0.0};
    edge.meetView = edge.viewAt(uniform(0.001, 0.999));
    return edge;
}

enum class CutEnd { nearEnd, farEnd };

/// The share of an edge at which a cascade's plane cuts it. Each clip distance of the device is too small by `steps` of its
/// float, so the cascade draws less than it should.
double cutShare(const ClippedEdge& edge, const CascadeView& cascade, CutEnd end, double steps) {
    const auto planeAhead = [&](double view) { return static_cast<float>(view - cascade.terms.anchorView); };
    // As the draw record and geometry.vert form them.
    const auto centreAhead = static_cast<float>(edge.centreView - cascade.terms.anchorView);
    const auto inside = [&](float beyond) {
        const float ahead = centreAhead + beyond;
        const float distance = end == CutEnd::nearEnd ? ahead - planeAhead(cascade.clipRange.nearView)
                                                      : planeAhead(cascade.clipRange.farView) - ahead;
        const float size = std::abs(distance);
        const float step = std::nextafter(size, std::numeric_limits<float>::infinity()) - size;
        return double{distance} - steps * double{step};
    };
    const double first = inside(edge.from);
    const double second = inside(edge.to);
    return first / (first - second); // beyond the edge too
}

/// Devices may round the clip distances that they interpolate, by no bound that Vulkan states. Two steps lose something at
/// each side of where cascades meet. It must be less than what they share, with half of that to spare for the interpolation
/// itself.
TEST(ClipOverlap, TwoStepsOfEachClipDistanceOpenNoGapBetweenCascades) {
    constexpr double kSteps = 2.0;
    constexpr double kShareToSpare = 0.5;
    constexpr double kSpanOfThickness = 16'000.0;
    std::mt19937_64 random(2013);
    for (const depth::Mapping mapping : {depth::Mapping::standard, depth::Mapping::reversed,
                                         depth::Mapping::anchored, depth::Mapping::anchoredReversed}) {
        for (const double ratio :
             {1e6, 1e4, 1000.0, 100.0, 10.0, 1.1, 1.02, 1.005, 1.002, 1.0002, 1.00001, 1.000001}) {
            // Cascades far thinner than a draw no longer share what it rounds: a weak spot (README of geometry).
            const double span = std::min(wideSpan(mapping, 2), kSpanOfThickness * (ratio - 1.0));
            double leastToSpare = std::numeric_limits<double>::infinity();
            for (int i = 0; i < 20'000; ++i) {
                const ClippedEdge edge = clippedEdge(span, random);
                const depth::Cascades ranges{{edge.meetView / ratio, edge.meetView},
                                             {edge.meetView, edge.meetView * ratio}};
                const auto views = cascadeViews(mapping, ranges, ranges, depth::FarEnd::closed, {});
                const double shared = views[0].clipRange.farView - edge.meetView;
                const double nearerEndsView = edge.viewAt(cutShare(edge, views[0], CutEnd::farEnd, kSteps));
                const double fartherBeginsView =
                    edge.viewAt(cutShare(edge, views[1], CutEnd::nearEnd, kSteps));
                leastToSpare = std::min(leastToSpare, (nearerEndsView - fartherBeginsView) / shared);
            }
            EXPECT_GE(leastToSpare, kShareToSpare) << nameOf(mapping) << " " << ratio;
        }
    }
}

} // namespace

} // namespace cdr::render
