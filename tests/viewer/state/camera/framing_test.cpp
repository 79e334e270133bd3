#include "../cameras.h"

#include <viewer/state/camera/framing.h>

#include <cmath>

namespace cdr::viewer {

namespace {

using namespace viewer_test;

TEST(BallOf, HoldsAllInstancesOfAnObject) {
    scene::Instances instances;
    instances.x = {-3.0, 5.0, 100.0, 900.0};
    instances.y = instances.z = {0.0, 0.0, 0.0, 0.0};
    instances.radius = {1.0f, 1.0f, 7.0f, scene::kNoRadius}; // a world removed the last one
    instances.object = {4, 4, 5, 4};
    const Ball ball = ballOf(instances, 4);
    EXPECT_EQ(ball.centre, glm::dvec3(1.0, 0.0, 0.0));
    EXPECT_DOUBLE_EQ(ball.radius, 5.0);
    EXPECT_EQ(ballOf(instances, 5).radius, 7.0);
    EXPECT_EQ(ballOf(instances, 6).radius, 0.0);
}

TEST(Framed, ShowsTheBallWholeAndInTheMiddle) {
    const scene::Camera camera = cameraWith(40.0, {10.0, 20.0, 100.0}, {3.0, 1.0, 0.0});
    const Ball ball{.centre = {-50.0, 3.0, 8.0}, .radius = 2.0};
    for (const double aspect : {0.5, 1.0, 2.0}) {
        const scene::Camera seen = framed(camera, ball, aspect);
        EXPECT_EQ(seen.back, camera.back);
        const glm::dvec3 centre = seen.toView(ball.centre);
        EXPECT_NEAR(std::hypot(centre.x, centre.y), 0.0, 1e-9);
        const double halfAngle = std::atan(std::tan(0.5 * camera.fovY) * std::min(aspect, 1.0));
        EXPECT_NEAR(-centre.z, ball.radius / std::sin(halfAngle), 1e-9) << aspect;
    }
    // The camera keeps away from a point.
    EXPECT_GT(-framed(camera, {.centre = ball.centre}, 1.0).toView(ball.centre).z, camera.nearView);
}

} // namespace

} // namespace cdr::viewer
