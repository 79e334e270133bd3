#include <cdr/base/error.h>
#include <cdr/scene/cube_sides.h>
#include <cdr/scene/frustum.h>
#include <cdr/scene/stereo_rig.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace cdr::scene {

namespace {

StereoRig farRig(StereoMode mode, double scale) {
    const Camera camera{.fovY = 0.8, .nearView = 0.1, .farView = 1e6};
    return {.centre =
                lookAlong(camera, glm::dvec3(3.0, -2.0, 7.0) * scale, {0.3, -0.2, -1.0}, {0.1, 1.0, 0.2}),
            .eyeDistance = 0.065,
            .convergence = 4.0,
            .mode = mode};
}

/// Column of a point in a picture, in pixels from its left edge.
double columnOf(const Camera& camera, const glm::dvec3& point, double width, double height) {
    const glm::dvec3 view = camera.toView(point);
    return (view.x / (-view.z * frustumOf(camera, width, height).tanX) + 1.0) * 0.5 * width;
}

TEST(StereoRigTest, ParallelEyesLookAlongTheCamerasAxis) {
    const StereoRig rig = farRig(StereoMode::parallel, 1.0);
    const auto [left, right] = eyesOf(rig);
    for (const Camera& eye : {left, right}) {
        EXPECT_EQ(eye.back, rig.centre.back);
        EXPECT_EQ(eye.right, rig.centre.right);
        EXPECT_EQ(eye.fovY, rig.centre.fovY);
    }
    EXPECT_NEAR(rig.centre.toView(left.position).x, -0.0325, 1e-15);
    EXPECT_NEAR(rig.centre.toView(right.position).x, 0.0325, 1e-15);
    EXPECT_NEAR(rig.centre.viewDistance(left.position), 0.0, 1e-14);
}

/// Near the origin and so far out that a unit of position is rounded.
TEST(StereoRigTest, ToedInEyesMeetAtTheConvergenceDistance) {
    for (const double scale : {0.0, 1.0, 1e9}) {
        const StereoRig rig = farRig(StereoMode::toedIn, scale);
        const glm::dvec3 meeting = rig.centre.position - rig.convergence * rig.centre.back;
        for (const Camera& eye : eyesOf(rig)) {
            const double slack = 1e-14 + scale * 1e-14;
            EXPECT_NEAR(eye.toView(meeting).x, 0.0, slack) << scale;
            EXPECT_NEAR(eye.toView(meeting).y, 0.0, slack) << scale;
            EXPECT_NEAR(glm::dot(eye.right, eye.back), 0.0, 1e-15);
            EXPECT_NEAR(glm::dot(eye.up, rig.centre.up), 1.0, 1e-14);
        }
        const auto [left, right] = eyesOf(rig);
        EXPECT_NEAR(glm::dot(left.back, right.back), std::cos(2.0 * std::atan(0.0325 / 4.0)), 1e-14);
        EXPECT_LT(rig.centre.toView(left.position).x, 0.0);
    }
}

TEST(StereoRigTest, ShiftedPicturesCoincideAtTheConvergenceDistance) {
    StereoRig rig = farRig(StereoMode::parallel, 1.0);
    rig.eyeDistance = 0.5;
    const glm::dvec3 meeting = rig.centre.position - rig.convergence * rig.centre.back;
    const auto [left, right] = eyesOf(rig);
    const double parallax = columnOf(left, meeting, 1280, 720) - columnOf(right, meeting, 1280, 720);
    EXPECT_GT(parallax, 50.0);
    EXPECT_EQ(stereoShift(rig, 1280, 720), static_cast<std::uint32_t>(std::lround(parallax)));
    rig.convergence = std::numeric_limits<double>::infinity();
    EXPECT_EQ(stereoShift(rig, 1280, 720), 0u);
    EXPECT_EQ(stereoShift(farRig(StereoMode::toedIn, 1.0), 1280, 720), 0u);
}

TEST(StereoRigTest, OffAxisEyesSeeTheConvergenceDistanceInTheMiddleOfTheirPictures) {
    for (const double shift : {0.0, 0.3}) {
        StereoRig rig = farRig(StereoMode::offAxis, 1.0);
        rig.centre.lensShift.x = shift;
        const glm::dvec3 meeting =
            rig.centre.position + rig.convergence * (shift * rig.centre.right - rig.centre.back);
        for (const Camera& eye : eyesOf(rig)) {
            EXPECT_EQ(eye.back, rig.centre.back);
            const glm::dvec3 view = eye.toView(meeting);
            EXPECT_NEAR(view.x / -view.z, eye.lensShift.x, 1e-14);
        }
        EXPECT_EQ(stereoShift(rig, 1280, 720), 0u);
    }
}

TEST(StereoRigTest, UnusableRigsAreRefused) {
    const auto refuses = [](auto change) {
        StereoRig rig = farRig(StereoMode::toedIn, 1.0);
        change(rig);
        EXPECT_THROW(eyesOf(rig), base::InputError);
    };
    for (const double bad : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
        refuses([&](StereoRig& rig) { rig.eyeDistance = bad; });
        refuses([&](StereoRig& rig) { rig.convergence = bad; });
        refuses([&](StereoRig& rig) {
            rig.mode = StereoMode::offAxis;
            rig.convergence = bad;
        });
    }
    refuses([](StereoRig& rig) { rig.centre.nearView = 0.0; });
    refuses([](StereoRig& rig) { rig.centre.position.x = 1e17; }); // a step there is 16 units
    StereoRig near = farRig(StereoMode::parallel, 1.0);
    near.convergence = 0.01;
    EXPECT_THROW(stereoShift(near, 1280, 720), base::InputError);
    EXPECT_EQ(parseStereoMode("toed-in"), StereoMode::toedIn);
    EXPECT_THROW(parseStereoMode("toedin"), base::InputError);
}

TEST(CubeSidesTest, SeeEveryDirectionOnce) {
    const Camera camera = farRig(StereoMode::parallel, 1.0).centre;
    const auto sides = cubeSides(camera);
    std::size_t points = 0;
    for (int x = -3; x <= 3; ++x) {
        for (int y = -3; y <= 3; ++y) {
            for (int z = -3; z <= 3; ++z) {
                const glm::dvec3 point(x + 0.11, y + 0.07, z + 0.05); // on no edge
                int seen = 0;
                for (const Camera& side : sides) {
                    const glm::dvec3 view =
                        side.toView(camera.position + 5.0 * (camera.right * point.x + camera.up * point.y +
                                                             camera.back * point.z));
                    seen += -view.z > 0.0 && std::abs(view.x) < -view.z && std::abs(view.y) < -view.z;
                }
                EXPECT_EQ(seen, 1) << x << " " << y << " " << z;
                ++points;
            }
        }
    }
    EXPECT_EQ(points, 343u);
    EXPECT_EQ(sides[5].back, camera.back);
    EXPECT_EQ(sides[0].back, -camera.right);
    for (const Camera& side : sides) {
        const glm::dvec3 back = glm::cross(side.right, side.up);
        EXPECT_NEAR(glm::dot(back, side.back), 1.0, 1e-14); // right-handed
    }
}

} // namespace

} // namespace cdr::scene
