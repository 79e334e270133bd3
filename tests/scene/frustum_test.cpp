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

/// Every point that the picture shows passes, and so does a sphere that touches it.
TEST(Frustum, PlanesOfAShiftedLensLeaveNothingOut) {
    for (const double shift : {0.0, 0.4, -3.0}) {
        Camera camera{.fovY = 0.7};
        camera.lensShift = {shift, -0.5 * shift};
        const Frustum frustum = frustumOf(camera, 16.0, 9.0);
        for (const double side : {-1.0, 1.0}) {
            const double edge = shift + side * frustum.tanX; // slope of the picture's edge
            const double length = std::hypot(1.0, edge);
            for (const double off : {0.0, 0.5}) { // of a sphere's centre beyond the edge, across the plane
                const double w = 10.0 - side * off * edge / length;
                const double x = 10.0 * edge + side * off / length;
                EXPECT_GE(w * frustum.sinX - std::abs(x - w * frustum.centre.x) * frustum.cosX + off, -1e-12)
                    << shift;
            }
        }
        EXPECT_LT(frustum.sinX - 1.1 * frustum.tanX * frustum.cosX, 0.0); // what lies beyond does not pass
    }
}

} // namespace
