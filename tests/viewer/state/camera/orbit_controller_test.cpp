#include "../cameras.h"

#include <viewer/state/camera/orbit_controller.h>

namespace cdr::viewer {

namespace {

using namespace viewer_test;

const PictureExtent kExtent;

/// Telephoto a million units away, and something in the upper left of the picture as the pivot.
Orbit farAway() {
    const scene::Camera camera = cameraWith(0.002, {3e5, 4e5, 1e6}, glm::dvec3(0.0));
    return {.camera = camera, .pivot = -8.0 * camera.right + 5.0 * camera.up};
}

TEST(Orbit, WithoutInputKeepsTheBits) {
    const Orbit before = farAway();
    const Orbit after = orbit(before, {.seconds = 0.016});
    expectSame(after.camera, before.camera);
    EXPECT_EQ(after.pivot, before.pivot);
}

TEST(Orbit, ThePivotKeepsItsPixelAndItsDistanceWhileTurning) {
    Orbit state = farAway();
    const glm::dvec2 pixel = pixelOf(state.camera, state.pivot, kExtent);
    const double distance = glm::distance(state.camera.position, state.pivot);
    for (int i = 0; i < 1000; ++i) {
        state = orbit(state, {.drag = {30.0 * std::sin(i), 20.0 * std::cos(0.7 * i)}});
        const glm::dvec2 now = pixelOf(state.camera, state.pivot, kExtent);
        ASSERT_NEAR(glm::distance(now, pixel), 0.0, 1e-3) << i;
        expectLevel(state.camera);
    }
    EXPECT_NEAR(glm::distance(state.camera.position, state.pivot) / distance, 1.0, 1e-9);
}

TEST(Orbit, TheFrontFollowsThePointer) {
    // A ball that fills the picture's height: a point on its front moves by about a pixel per pixel dragged.
    const Orbit before{.camera = cameraWith(1.0, {0.0, 0.0, 1000.0}, glm::dvec3(0.0)),
                       .pivot = glm::dvec3(0.0)};
    const glm::dvec3 front(0.0, 0.0, 1000.0 * std::tan(scene::radiansOf(0.5)));
    const glm::dvec2 drag(4.0, 3.0);
    const Orbit after = orbit(before, {.drag = drag});
    const glm::dvec2 moved = pixelOf(after.camera, front, kExtent) - pixelOf(before.camera, front, kExtent);
    EXPECT_NEAR(moved.x, drag.x, 0.1);
    EXPECT_NEAR(moved.y, drag.y, 0.1);
}

TEST(Orbit, ScrollingIsExponentialAndReversible) {
    const Orbit before = farAway();
    const double distance = glm::distance(before.camera.position, before.pivot);
    const auto distanceAfter = [&](double notches) {
        const Orbit after = orbit(before, {.scroll = notches});
        EXPECT_NEAR(glm::distance(pixelOf(after.camera, after.pivot, kExtent),
                                  pixelOf(before.camera, before.pivot, kExtent)),
                    0.0, 1e-3);
        return glm::distance(after.camera.position, after.pivot);
    };
    EXPECT_NEAR(distanceAfter(1.0) / distance, std::exp(-OrbitSpeed{}.perNotch), 1e-9);
    EXPECT_NEAR(distanceAfter(10.0) / distance, std::pow(distanceAfter(1.0) / distance, 10.0), 1e-9);
    const Orbit back = orbit(orbit(before, {.scroll = 5.0}), {.scroll = -5.0});
    EXPECT_NEAR(glm::distance(back.camera.position, before.camera.position), 0.0, 1e-6);
}

TEST(Orbit, StopsBeforeThePivotAndAtFar) {
    Orbit state = farAway();
    state = orbit(state, {.scroll = 1e4});
    EXPECT_NEAR(glm::distance(state.camera.position, state.pivot),
                OrbitSpeed{}.nearestView * state.camera.nearView, 1e-8);
    state = orbit(state, {.scroll = -1e4});
    EXPECT_NEAR(glm::distance(state.camera.position, state.pivot) / state.camera.farView, 1.0, 1e-9);
}

TEST(Orbit, PanningShiftsBothByPixels) {
    const Orbit before = farAway();
    const glm::dvec3 something = before.pivot + 2.0 * before.camera.right;
    const glm::dvec2 pan(12.0, -7.0);
    const Orbit after = orbit(before, {.pan = pan});
    const glm::dvec2 moved =
        pixelOf(after.camera, something, kExtent) - pixelOf(before.camera, something, kExtent);
    EXPECT_NEAR(moved.x, pan.x, 1e-3);
    EXPECT_NEAR(moved.y, pan.y, 1e-3);
    EXPECT_NEAR(glm::distance(pixelOf(after.camera, after.pivot, kExtent),
                              pixelOf(before.camera, before.pivot, kExtent)),
                0.0, 1e-3);
    EXPECT_EQ(after.camera.back, before.camera.back);
}

TEST(Orbit, KeysTurnAndDollyWhateverTheFrameRate) {
    const Orbit before = farAway();
    const CameraKeys keys{CameraKey::forward, CameraKey::right};
    const Orbit once = orbit(before, {.keys = keys, .seconds = 0.2});
    const Orbit twice = orbit(orbit(before, {.keys = keys, .seconds = 0.1}), {.keys = keys, .seconds = 0.1});
    EXPECT_GT(glm::distance(once.camera.position, before.camera.position), 1e4);
    EXPECT_NEAR(glm::distance(once.camera.position, twice.camera.position), 0.0, 1e-6);
    // To the right means the camera moves right.
    EXPECT_GT(glm::dot(orbit(before, {.keys = {CameraKey::right}, .seconds = 0.1}).camera.position -
                           before.camera.position,
                       before.camera.right),
              0.0);
    EXPECT_GT(orbit(before, {.keys = {CameraKey::up}, .seconds = 0.1}).camera.position.y,
              before.camera.position.y);
}

TEST(Orbit, APivotAtTheEyeDoesNothing) {
    Orbit state = farAway();
    state.pivot = state.camera.position;
    expectSame(orbit(state, {.drag = {5.0, 5.0}, .scroll = 1.0}).camera, state.camera);
}

} // namespace

} // namespace cdr::viewer
