#include <cdr/depth/forecast.h>
#include <cdr/depth/make_cascades.h>
#include <cdr/depth/separation.h>
#include <cdr/depth/technique.h>

#include <gtest/gtest.h>

namespace {

using namespace cdr::depth;

std::size_t cascadesFor(Mapping mapping, double targetUnits, double nearView, double farView) {
    std::vector<Interval> occupied{{nearView, farView}};
    const SplitFitted split{.target = targetUnits, .unit = SplitFitted::Unit::scene, .most = 64};
    return makeCascades(split, {.nearView = nearView,
                                .farView = farView,
                                .model = {mapping, DepthFormat::d32f},
                                .visible = occupied})
        .size();
}

/// The step of anchored, mirrored: 2^-24 of the distance to the far plane, times w / f.
TEST(AnchoredReversed, StepsFallTowardsTheFarPlane) {
    const DepthRange range{.mapping = Mapping::anchoredReversed, .nearView = 1e6, .farView = 1e6 + 32.0};
    for (const double ahead : {-31.0, -8.0, -1.0, -0.01}) {
        const double step = separationView(range, DepthFormat::d32f, 1e6 + 32.0 + ahead);
        EXPECT_LE(step, 0x1p-22 * -ahead);
        EXPECT_GE(step, 0x1p-25 * -ahead);
    }
}

/// Where it is the better choice, and where it is not.
TEST(AnchoredReversed, IsFinerAtTheFarEndAndCoarserAtTheNearOne) {
    const auto step = [](Mapping mapping, double w) {
        return separationView({.mapping = mapping, .nearView = 1e6, .farView = 1e6 + 1000.0},
                              DepthFormat::d32f, w);
    };
    EXPECT_LT(10.0 * step(Mapping::anchoredReversed, 1e6 + 999.0), step(Mapping::anchored, 1e6 + 999.0));
    EXPECT_LT(10.0 * step(Mapping::anchored, 1e6 + 1.0), step(Mapping::anchoredReversed, 1e6 + 1.0));
}

TEST(AnchoredReversed, HoldsATargetInUnitsOverAWideRangeWithFewerCascades) {
    EXPECT_EQ(cascadesFor(Mapping::anchoredReversed, 0.001, 1.0, 10'000.0), 1u);
    EXPECT_EQ(cascadesFor(Mapping::anchored, 0.001, 1.0, 10'000.0), 3u);
    EXPECT_LT(cascadesFor(Mapping::anchoredReversed, 0.0001, 0.1, 10'000.0),
              cascadesFor(Mapping::anchored, 0.0001, 0.1, 10'000.0));
}

/// Integer depth is mirrored exactly: nothing to choose.
TEST(AnchoredReversed, EqualsAnchoredInIntegerFormats) {
    for (const DepthFormat format : {DepthFormat::d16, DepthFormat::d24}) {
        for (const double w : {1e6, 1e6 + 7.0, 1e6 + 31.0}) {
            const auto step = [&](Mapping mapping) {
                return separationView({.mapping = mapping, .nearView = 1e6, .farView = 1e6 + 32.0}, format,
                                      w);
            };
            EXPECT_NEAR(step(Mapping::anchored) / step(Mapping::anchoredReversed), 1.0, 0.01);
        }
    }
}

TEST(AnchoredReversed, IsForecastLikeAnchored) {
    const ForecastScene scene{
        .nearView = 0.001, .farView = 2e6, .footprintSlope = 5e-8, .atView = 1e6, .spanView = 18.0};
    const auto resolved = [&](const char* name) {
        return forecast(parseTechnique(name), scene).resolvedView();
    };
    EXPECT_LT(resolved("anchored-reversed/fitted"), 2e-5);
    const double ratio = resolved("anchored-reversed/fitted") / resolved("anchored/fitted");
    EXPECT_GT(ratio, 0.5);
    EXPECT_LT(ratio, 2.0);
}

TEST(StepTarget, ScalingKeepsWhatNeedBeNoFiner) {
    const StepTarget target{
        .unitsView = 1e-9, .shareView = 1e-9, .leastUnitsView = 0.5, .leastShareView = 0.25};
    const StepTarget scaled = target.scaled(2.0);
    EXPECT_EQ(scaled.unitsView, 2e-9);
    EXPECT_EQ(scaled.shareView, 2e-9);
    EXPECT_EQ(scaled.leastUnitsView, 0.5);
    EXPECT_EQ(scaled.leastShareView, 0.25);
}

} // namespace
