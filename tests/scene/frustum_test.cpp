#include <cdr/scene/frustum.h>

#include <gtest/gtest.h>

#include <cmath>

namespace {

using cdr::scene::Camera;
using cdr::scene::Frustum;
using cdr::scene::frustumOf;

TEST(Frustum, HasTheTangentsThatACameraProjectsWith) {
    const Camera camera{.fovY = 2.0 * std::atan(0.5)};
    const Frustum frustum = frustumOf(camera, 1280.0, 720.0);
    EXPECT_DOUBLE_EQ(frustum.tanY, 0.5);
    EXPECT_DOUBLE_EQ(frustum.tanX, 0.5 * 16.0 / 9.0);
    EXPECT_DOUBLE_EQ(frustum.aspect, 16.0 / 9.0);
    EXPECT_DOUBLE_EQ(frustum.footprintSlope, 1.0 / 720.0);
}

TEST(Frustum, SinesAndCosinesAreOfThePlanes) {
    for (const double fovY : {1e-6, 0.002, 1.0, 3.0}) {
        const Frustum frustum = frustumOf(Camera{.fovY = fovY}, 1440.0, 810.0);
        EXPECT_NEAR(frustum.sinY / frustum.cosY, frustum.tanY, 1e-14 * frustum.tanY) << fovY;
        EXPECT_NEAR(frustum.sinX / frustum.cosX, frustum.tanX, 1e-14 * frustum.tanX) << fovY;
        EXPECT_NEAR(frustum.sinX * frustum.sinX + frustum.cosX * frustum.cosX, 1.0, 1e-15) << fovY;
    }
}

} // namespace
