#include <cdr/image/srgb.h>

#include <gtest/gtest.h>

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

TEST(Srgb, WhatLiesOutsideIsClamped) {
    EXPECT_EQ(srgbOfLinear(-1.0), 0);
    EXPECT_EQ(srgbOfLinear(7.0), 255);
}

} // namespace cdr::image
