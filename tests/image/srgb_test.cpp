#include <cdr/image/srgb.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace cdr::image {

TEST(Srgb, KnownValues) {
    EXPECT_EQ(linearOfSrgb()[0], 0.0);
    EXPECT_EQ(linearOfSrgb()[255], 1.0);
    EXPECT_NEAR(linearOfSrgb()[10], 10.0 / 255.0 / 12.92, 1e-15);
    EXPECT_NEAR(linearOfSrgb()[128], 0.2158605, 1e-7);
    EXPECT_EQ(srgbOfLinear(0.5), 188);
    EXPECT_EQ(srgbOfLinear(0.0031308 * 0.9), 9);
}

TEST(Srgb, EveryValueComesBack) {
    for (std::size_t i = 0; i < 256; ++i) {
        EXPECT_EQ(srgbOfLinear(linearOfSrgb()[i]), i);
    }
}

TEST(Srgb, TheNearestValueIsFoundEverywhere) {
    for (std::size_t i = 0; i <= 100'000; ++i) {
        const double linear = static_cast<double>(i) / 100'000.0;
        const double srgb =
            linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
        EXPECT_NEAR(srgbOfLinear(linear), 255.0 * srgb, 0.501) << linear;
    }
}

TEST(Srgb, WhatLiesOutsideIsClamped) {
    EXPECT_EQ(srgbOfLinear(-1.0), 0);
    EXPECT_EQ(srgbOfLinear(7.0), 255);
    EXPECT_EQ(srgbOfLinear(std::numeric_limits<double>::quiet_NaN()), 255);
}

} // namespace cdr::image
