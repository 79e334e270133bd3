#include "../cameras.h"

#include <viewer/state/camera/fly_controller.h>
#include <viewer/state/camera/heading.h>

#include <limits>

namespace cdr::viewer {

namespace {

using namespace viewer_test;

const glm::dvec3 kTarget(0.0);

TEST(Fly, WithoutInputKeepsTheBits) {
    const scene::Camera rolled =
        scene::lookAlong({}, {1.0, 2.0, 3.0}, {0.3, 0.1, -1.0}, glm::dvec3(0.4, 1.0, 0.0));
    expectSame(fly(rolled, {.seconds = 0.016}, 10.0), rolled);
    // Moving alone does not turn.
    const scene::Camera moved = fly(rolled, {.keys = {CameraKey::forward}, .seconds = 0.016}, 10.0);
    EXPECT_EQ(moved.right, rolled.right);
    EXPECT_EQ(moved.back, rolled.back);
    EXPECT_GT(glm::dot(moved.position - rolled.position, -rolled.back), 0.0);
}

TEST(Fly, ApproachesASurfaceAndNeverPassesIt) {
    scene::Camera camera = cameraWith(60.0, {0.0, 0.0, 1000.0}, kTarget);
    for (int frame = 0; frame < 2000; ++frame) {
        const double surface = camera.position.z;
        camera = fly(camera, {.keys = {CameraKey::forward, CameraKey::faster}, .seconds = 0.25},
                     flightDistance(camera, surface, 0.0));
        ASSERT_GT(camera.position.z, 0.0);
        if (surface < 2.0 * camera.nearView) {
            break;
        }
    }
    EXPECT_LT(camera.position.z, 0.01);
}

TEST(Fly, TheWheelGoesNearer) {
    const scene::Camera camera = cameraWith(60.0, {0.0, 0.0, 100.0}, kTarget);
    EXPECT_NEAR(fly(camera, {.scroll = 2.0}, 100.0).position.z, 100.0 * std::exp(-0.3), 1e-9);
    EXPECT_NEAR(fly(camera, {.scroll = -2.0}, 100.0).position.z, 100.0 * std::exp(0.3), 1e-9);
}

TEST(Fly, AFarScrollStaysFinite) {
    const scene::Camera camera = cameraWith(60.0, {0.0, 0.0, 100.0}, kTarget);
    const double back = fly(camera, {.scroll = -20000.0}, 100.0).position.z;
    EXPECT_GT(back, 1e6);
    EXPECT_LT(back, 1e12);
    const double near = fly(camera, {.scroll = 20000.0}, 100.0).position.z;
    EXPECT_GE(near, 0.0);
    EXPECT_LT(near, 1e-3);
}

TEST(Fly, DoesNotDependOnTheFrameRate) {
    const scene::Camera start = cameraWith(40.0, {0.0, 0.0, 100.0}, kTarget);
    const auto after = [&](int frames, CameraKeys keys) {
        scene::Camera camera = start;
        for (int frame = 0; frame < frames; ++frame) {
            // What is looked at comes as near as the camera goes.
            const double surface = camera.position.z;
            camera = fly(camera, {.keys = keys, .seconds = 0.24 / frames}, surface);
        }
        return camera.position;
    };
    for (const CameraKeys keys : {CameraKeys{CameraKey::forward}, CameraKeys{CameraKey::backward},
                                  CameraKeys{CameraKey::forward, CameraKey::right},
                                  CameraKeys{CameraKey::up, CameraKey::left, CameraKey::slower}}) {
        const glm::dvec3 once = after(1, keys);
        EXPECT_GT(glm::distance(once, start.position), 0.1);
        EXPECT_NEAR(glm::distance(after(2, keys), once), 0.0, 1e-12);
        EXPECT_NEAR(glm::distance(after(24, keys), once), 0.0, 1e-11);
    }
}

TEST(Fly, SpeedScalesWithDistanceAndLens) {
    const auto moved = [](double fovDegrees, double distance, CameraKey key) {
        const scene::Camera camera = cameraWith(fovDegrees, {0.0, 0.0, distance}, kTarget);
        return glm::distance(fly(camera, {.keys = {key}, .seconds = 0.1}, distance).position,
                             camera.position);
    };
    EXPECT_NEAR(moved(60.0, 1e8, CameraKey::forward) / moved(60.0, 1.0, CameraKey::forward), 1e8, 1.0);
    // Ahead, the lens does not matter; sideways the same share of the picture goes by.
    EXPECT_NEAR(moved(0.002, 1e6, CameraKey::forward), moved(60.0, 1e6, CameraKey::forward), 1e-6);
    const double wide = moved(60.0, 1e6, CameraKey::right) / std::tan(scene::radiansOf(30.0));
    const double narrow = moved(0.002, 1e6, CameraKey::right) / std::tan(scene::radiansOf(0.001));
    EXPECT_NEAR(narrow / wide, 1.0, 1e-9);
}

TEST(Fly, FasterAndSlowerAreReciprocal) {
    const scene::Camera camera = cameraWith(60.0, {0.0, 0.0, 10.0}, kTarget);
    const auto moved = [&](CameraKeys keys) {
        keys.set(CameraKey::right, true);
        return glm::distance(fly(camera, {.keys = keys, .seconds = 0.1}, 10.0).position, camera.position);
    };
    EXPECT_NEAR(moved({CameraKey::faster}) / moved({}), FlySpeed{}.fasterBy, 1e-9);
    EXPECT_NEAR(moved({}) / moved({CameraKey::slower}), FlySpeed{}.fasterBy, 1e-9);
    EXPECT_NEAR(moved({CameraKey::slower, CameraKey::faster}) / moved({}), 1.0, 1e-12);
    EXPECT_EQ(moved({CameraKey::left}), 0.0); // against right
}

TEST(Fly, AHitchFlingsNobodyAway) {
    const scene::Camera camera = cameraWith(60.0, {0.0, 0.0, 10.0}, kTarget);
    const scene::Camera moved = fly(camera, {.keys = {CameraKey::backward}, .seconds = 60.0}, 10.0);
    EXPECT_LT(glm::distance(moved.position, camera.position), 10.0);
    expectSame(fly(camera, {.keys = {CameraKey::backward}, .seconds = -1.0}, 10.0), camera);
}

/// A pixel of the mouse is a pixel of the picture, in the middle, through every lens and at every elevation.
TEST(Fly, APixelOfMouseIsAPixelOfPicture) {
    for (const double fovDegrees : {90.0, 60.0, 1.0, 0.002}) {
        for (const double elevation : {0.0, 0.7, -1.2, 1.5}) {
            const glm::dvec3 forward(std::cos(elevation) * 0.6, std::sin(elevation),
                                     -std::cos(elevation) * 0.8);
            const scene::Camera camera = cameraWith(fovDegrees, glm::dvec3(0.0), forward);
            const glm::dvec3 middle = 1e6 * forward;
            // Far from level, a wide lens cannot have both; see below.
            const bool sideways = fovDegrees < 2.0 || std::abs(elevation) < 0.1;
            const glm::dvec2 drag(sideways ? 3.0 : 0.0, -2.0);
            const CameraInput input{.drag = drag, .seconds = 0.016};
            const scene::Camera looked = fly(camera, input, 1.0);
            const glm::dvec2 seen = pixelOf(looked, middle, input.extent) - glm::dvec2(640.0, 360.0);
            EXPECT_NEAR(seen.x, -drag.x, 0.02) << fovDegrees << " " << elevation;
            EXPECT_NEAR(seen.y, -drag.y, 0.02) << fovDegrees << " " << elevation;
            expectLevel(looked);
        }
    }
}

TEST(Fly, LooksRightWhenDraggedRightAndUpWhenDraggedUp) {
    const scene::Camera camera = cameraWith(60.0, glm::dvec3(0.0), {0.0, 0.0, -1.0});
    EXPECT_GT(-fly(camera, {.drag = {100.0, 0.0}}, 1.0).back.x, 0.01);
    EXPECT_GT(-fly(camera, {.drag = {0.0, -100.0}}, 1.0).back.y, 0.01);
    const CameraInput pad{.axes = {.look = {1.0, 0.0}}, .seconds = 0.1};
    EXPECT_GT(-fly(camera, pad, 1.0).back.x, 0.01);
}

TEST(Fly, StaysLevelForEverAndStopsShortOfThePoles) {
    scene::Camera camera = cameraWith(60.0, glm::dvec3(0.0), {1.0, 0.2, 0.4});
    for (int i = 0; i < 5000; ++i) {
        camera = fly(camera, {.drag = {137.0 * std::sin(i), 220.0 * std::cos(1.3 * i)}}, 1.0);
        expectLevel(camera);
        ASSERT_FALSE(testing::Test::HasFailure()) << i;
    }
    for (int i = 0; i < 100; ++i) {
        camera = fly(camera, {.drag = {0.0, -500.0}}, 1.0);
    }
    EXPECT_LT(-camera.back.y, 1.0);
    EXPECT_GT(-camera.back.y, 1.0 - 1e-9);
    expectLevel(camera);
}

TEST(Fly, LeavesStraightDownTheWayThePictureStands) {
    // lookAt() straight down has world z at the upper edge.
    const scene::Camera down = cameraWith(60.0, {0.0, 100.0, 0.0}, glm::dvec3(0.0));
    const scene::Camera looked = fly(down, {.drag = {0.0, -50.0}}, 100.0);
    expectLevel(looked);
    EXPECT_GT(glm::dot(looked.up, down.up), 0.9);
    EXPECT_GT(glm::dot(looked.right, down.right), 0.99);
}

TEST(FlightDistance, TakesTheSurfaceElseTheLast) {
    const scene::Camera camera{.nearView = 0.1, .farView = 1e6};
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_DOUBLE_EQ(flightDistance(camera, 50.0, 7.0), 49.8);
    EXPECT_DOUBLE_EQ(flightDistance(camera, infinity, 7.0), 7.0);
    EXPECT_DOUBLE_EQ(flightDistance(camera, std::nan(""), 7.0), 7.0);
    EXPECT_DOUBLE_EQ(flightDistance(camera, 0.15, 7.0), 0.1);
    EXPECT_DOUBLE_EQ(flightDistance(camera, 1e9, 7.0), 1e6);
    EXPECT_NEAR(flightDistance(camera, infinity, 0.0), std::sqrt(0.1 * 1e6), 1e-9);
}

} // namespace

} // namespace cdr::viewer
