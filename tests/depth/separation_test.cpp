#include <cdr/base/error.h>
#include <cdr/depth/make_cascades.h>
#include <cdr/depth/separation.h>
#include <cdr/depth/technique.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace {

using namespace cdr::depth;

struct ThesisRow {
    const char* technique;
    std::array<double, 4> distancesView;
};

/// Table 4.1: near 0.001, far 10^8, 24 bits, separations 0.001, 0.01, 0.1 and 1.
class ThesisTable : public testing::TestWithParam<ThesisRow> {};

TEST_P(ThesisTable, IsReproducedWithinATenthOfAPercent) {
    const Technique technique = parseTechnique(GetParam().technique);
    const Cascades cascades = makeCascades(technique.split, {.nearView = 0.001, .farView = 1e8});
    double separation = 0.001;
    for (const double expected : GetParam().distancesView) {
        const auto crossing =
            findCrossing([&](double w) { return thesisSeparationView(technique.mapping, cascades, 24, w); },
                         separation, 0.001, 1e8);
        ASSERT_TRUE(crossing.has_value());
        EXPECT_NEAR(crossing->reachedFirstView / expected, 1.0, 1e-3);
        EXPECT_GE(crossing->heldLastView, crossing->reachedFirstView * (1.0 - 1e-12));
        separation *= 10.0;
    }
}

INSTANTIATE_TEST_SUITE_P(Rows, ThesisTable,
                         testing::Values(ThesisRow{"standard", {4.096, 12.958, 41.010, 130.028}},
                                         ThesisRow{"cdr", {129.592, 409.810, 40980.545, 129592.205}},
                                         ThesisRow{"log", {662.386, 6623.860, 66238.604, 662386.037}},
                                         ThesisRow{"logcdr", {2428.750, 24287.501, 242875.013, 3643125.454}}),
                         [](const auto& row) { return std::string(row.param.technique); });

TEST(Separation, IsTheDistanceToTheNextStoredDepth) {
    const Cascade span{0.1, 1e5};
    for (const Mapping mapping : kMappings) {
        const DepthRange range{.mapping = mapping, .nearView = span.nearView, .farView = span.farView};
        for (const DepthFormat format : kDepthFormats) {
            for (double w = 0.2; w < 5e3; w *= 1.7) {
                const double gap = separationView(range, format, w);
                if (!std::isfinite(gap) || w + gap > span.farView) {
                    continue;
                }
                const double z = zNdcAt(range, w);
                const double moved = std::abs(zNdcAt(range, w + gap) - z);
                // Depths near 1 lose digits to cancellation here, in the test, not in separationView().
                EXPECT_NEAR(moved / depthStep(format, z), 1.0, 1e-6)
                    << nameOf(mapping) << " " << nameOf(format) << " " << w;
            }
        }
    }
}

TEST(Separation, ReversedFloatIsAConstantShareOfTheDistance) {
    const DepthRange range{.mapping = Mapping::reversed, .nearView = 0.001, .farView = std::nullopt};
    for (double w = 1.0; w < 1e9; w *= 3.3) {
        const double share = separationView(range, DepthFormat::d32f, w) / w;
        EXPECT_LE(share, 0x1p-23 * 1.0001);
        EXPECT_GE(share, 0x1p-25);
    }
}

TEST(Separation, IsInfiniteOutsideTheCascades) {
    const Cascades cascades{{1.0, 10.0}};
    EXPECT_TRUE(std::isinf(separationView(Mapping::standard, cascades, DepthFormat::d24, 11.0)));
    EXPECT_FALSE(std::isinf(separationView(Mapping::standard, cascades, DepthFormat::d24, 10.0)));
}

TEST(FindCrossing, TellsFirstFromLastOnASaw) {
    // Rises to 9.99 below 10, then starts again.
    const auto saw = [](double w) { return w < 10.0 ? w : w - 9.0; };
    const auto crossing = findCrossing(saw, 5.0, 1.0, 100.0);
    ASSERT_TRUE(crossing.has_value());
    EXPECT_NEAR(crossing->reachedFirstView, 5.0, 1e-9);
    EXPECT_NEAR(crossing->heldLastView, 14.0, 1e-9);
    EXPECT_FALSE(findCrossing(saw, 1000.0, 1.0, 100.0).has_value());
    EXPECT_EQ(findCrossing(saw, 0.5, 1.0, 100.0)->reachedFirstView, 1.0);

    const std::vector<double> several{1000.0, 5.0, 0.5};
    const auto crossings = findCrossings(saw, several, 1.0, 100.0);
    ASSERT_EQ(crossings.size(), several.size());
    EXPECT_FALSE(crossings[0].has_value());
    EXPECT_EQ(crossings[1]->reachedFirstView, crossing->reachedFirstView);
    EXPECT_EQ(crossings[1]->heldLastView, crossing->heldLastView);
    EXPECT_EQ(crossings[2]->reachedFirstView, 1.0);
}

TEST(ThesisSeparation, RefusesMappingsTheThesisDoesNotKnow) {
    const Cascades cascades{{1.0, 10.0}};
    EXPECT_THROW(thesisSeparationView(Mapping::reversed, cascades, 24, 2.0), cdr::base::InputError);
}

} // namespace
