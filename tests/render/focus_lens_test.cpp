#include <cdr/render/focus.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace cdr::render_test {

namespace {

using render::FocusLens;

/// Circles of 20 pixels at infinity, sharp at 10.
FocusLens lensOf20() {
    constexpr double kTanY = 0.5;
    constexpr std::uint32_t kHeight = 100;
    return {{.distance = 10.0, .aperture = 2.0}, kTanY, kHeight};
}

TEST(FocusLensTest, CirclesAreThoseOfAThinLens) {
    const FocusLens lens = lensOf20();
    EXPECT_DOUBLE_EQ(lens.circleAt(10.0), 0.0);
    EXPECT_DOUBLE_EQ(lens.circleAt(5.0), 20.0); // 2 * (10 - 5) / 5 units across at 10, of 10 pixels each
    EXPECT_DOUBLE_EQ(lens.circleAt(20.0), 10.0);
    EXPECT_DOUBLE_EQ(lens.circleAt(1e300), 20.0);
}

TEST(FocusLensTest, WithoutAnApertureThereAreNoBoundaries) {
    EXPECT_EQ(FocusLens({.distance = 10.0, .aperture = 0.0}, 0.5, 100).boundaries(), std::vector<double>());
}

TEST(FocusLensTest, NothingIsBlurredMoreThanTheLensWould) {
    const FocusLens lens = lensOf20();
    EXPECT_EQ(lens.scaleOf({9.0, 11.0}), 1u);
    EXPECT_EQ(lens.scaleOf({1.0, 10.0}), 1u);  // sharp at its very end
    EXPECT_EQ(lens.scaleOf({10.5, 99.0}), 1u); // 0.95 pixels at its near end
    EXPECT_EQ(lens.scaleOf({15.0, 99.0}), 4u); // 6.7 pixels
    EXPECT_EQ(lens.scaleOf({20.0, 99.0}), 8u); // 10 pixels
    EXPECT_EQ(lens.scaleOf({0.1, 5.0}), 16u);  // 20 pixels at its far end
    EXPECT_EQ(lens.scaleOf({0.01, 0.1}), 16u); // 1980 pixels: no layer is smaller
}

TEST(FocusLensTest, BoundariesHaveTheCirclesOfTheScales) {
    const FocusLens lens = lensOf20();
    const std::vector<double> boundaries = lens.boundaries();
    const std::vector<double> circles{16, 8, 4, 2, 2, 4, 8, 16};
    ASSERT_EQ(boundaries.size(), circles.size());
    for (std::size_t i = 0; i < circles.size(); ++i) {
        EXPECT_NEAR(lens.circleAt(boundaries[i]), circles[i], 1e-6);
        // The cascade on the blurred side has that scale.
        const double beyond = i < 4 ? 0.9 * boundaries[i] : 1.1 * boundaries[i];
        EXPECT_EQ(lens.scaleOf({std::min(beyond, boundaries[i]), std::max(beyond, boundaries[i])}),
                  circles[i]);
    }
    EXPECT_TRUE(std::is_sorted(boundaries.begin(), boundaries.end()));
    EXPECT_EQ(FocusLens({.distance = 10.0, .aperture = 0.5}, 0.5, 100).boundaries().size(), 6u);
}

TEST(FocusLensTest, OverlapsStayBehindWhatIsSharp) {
    const FocusLens lens = lensOf20();
    const depth::Cascades cut{{1.0, 5.0},   {5.0, 10.6},  {10.6, 30.0},
                              {30.0, 31.0}, {31.0, 50.0}, {60.0, 99.0}};
    const depth::Cascades ranges = lens.overlapping(cut);
    ASSERT_EQ(ranges.size(), cut.size());
    EXPECT_EQ(ranges[0], cut[0]);
    EXPECT_DOUBLE_EQ(ranges[1].nearView, 4.0);
    EXPECT_DOUBLE_EQ(ranges[2].nearView, 8.48); // drawn in full, so it may reach into what is sharp
    EXPECT_DOUBLE_EQ(ranges[3].nearView, 24.0);
    EXPECT_DOUBLE_EQ(ranges[4].nearView, 30.0); // no earlier than the cascade before
    EXPECT_EQ(ranges[5], cut[5]);               // a gap hides nothing
    for (std::size_t i = 0; i < cut.size(); ++i) {
        EXPECT_EQ(ranges[i].farView, cut[i].farView);
    }
    // Two pixels of blur at 11.2; a fifth earlier would reach before the sharp distance.
    const depth::Cascades late = lens.overlapping({{1.0, 11.2}, {11.2, 50.0}});
    EXPECT_NEAR(lens.circleAt(late[1].nearView), 1.0, 1e-9);
    EXPECT_GT(late[1].nearView, 10.0);
}

} // namespace

} // namespace cdr::render_test
