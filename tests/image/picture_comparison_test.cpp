#include "../support/difference_picture.h"
#include "../support/picture_comparison.h"

#include <gtest/gtest.h>

namespace cdr::test {

namespace {

/// 100x50 pixels, so that 5 are a thousandth.
image::ImageRgba8 grey() {
    return {100, 50, {100, 100, 100, 255}};
}

/// grey() with one channel of the first `pixels` moved by `step`.
image::ImageRgba8 moved(std::size_t pixels, std::size_t channel, int step) {
    image::ImageRgba8 picture = grey();
    for (std::size_t i = 0; i < pixels; ++i) {
        picture.pixels[i * 7][channel] = static_cast<std::uint8_t>(picture.pixels[i * 7][channel] + step);
    }
    return picture;
}

TEST(Compare, EqualPicturesPass) {
    const Comparison comparison = compare(grey(), grey());
    EXPECT_TRUE(comparison.passes);
    EXPECT_EQ(comparison.largest, 0);
}

TEST(Compare, OneChannelOffBySixInATwoThousandthFails) {
    for (std::size_t channel = 0; channel < 3; ++channel) {
        for (const int step : {6, -6}) {
            const Comparison comparison = compare(grey(), moved(10, channel, step));
            EXPECT_FALSE(comparison.passes) << channel << ' ' << step;
            EXPECT_EQ(comparison.beyond, 10u);
            EXPECT_EQ(comparison.largest, 6);
        }
    }
    EXPECT_FALSE(compare(grey(), moved(10, 3, -6)).passes); // alpha too
}

TEST(Compare, AThousandthMayGoBeyondAndNotOnePixelMore) {
    EXPECT_TRUE(compare(grey(), moved(5, 1, 90)).passes);
    EXPECT_FALSE(compare(grey(), moved(6, 1, 90)).passes);
}

TEST(Compare, FiveOffEverywherePasses) {
    for (const int step : {5, -5}) {
        EXPECT_TRUE(compare(grey(), moved(700, 2, step)).passes);
        EXPECT_FALSE(compare(grey(), moved(700, 2, step > 0 ? 6 : -6)).passes);
    }
}

TEST(Compare, AnotherSizeFails) {
    EXPECT_FALSE(compare(grey(), {50, 100, {100, 100, 100, 255}}).passes);
    EXPECT_FALSE(compare(grey(), {100, 49, {100, 100, 100, 255}}).passes);
    EXPECT_FALSE(compare({}, {}).passes);
    EXPECT_EQ(describe(compare(grey(), {})), "the sizes differ");
}

TEST(Compare, TheDifferenceShowsBothSigns) {
    image::ImageRgba8 render = moved(1, 0, 20);
    render.pixels[1] = {90, 100, 100, 255};
    const image::ImageRgba8 difference = differencePicture(grey(), render, 10);
    EXPECT_EQ(difference.pixels[0], (image::Rgba8{200, 0, 0, 255}));
    EXPECT_EQ(difference.pixels[1], (image::Rgba8{100, 0, 0, 255}));
    EXPECT_EQ(difference.pixels[2], (image::Rgba8{0, 0, 0, 255}));
    EXPECT_THROW(differencePicture(grey(), {1, 1}, 1), base::InputError);
}

} // namespace

} // namespace cdr::test
