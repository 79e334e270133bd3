#include "../cameras.h"

#include <viewer/state/camera/gamepad.h>
#include <viewer/state/camera/heading.h>
#include <viewer/state/camera/lens_zoom.h>

namespace cdr::viewer {

namespace {

using namespace viewer_test;

/// The world direction under a pixel.
glm::dvec3 rayUnder(const scene::Camera& camera, const glm::dvec2& pixel, const PictureExtent& extent) {
    const glm::dvec2 slope = slopeOf(camera, pixel, extent.width, extent.height);
    return glm::normalize(slope.x * camera.right + slope.y * camera.up - camera.back);
}

TEST(LensZoom, KeepsWhatIsUnderTheCursorThere) {
    for (const double elevation : {0.0, 0.8, -1.3, -1.5}) {
        scene::Camera camera = cameraWith(90.0, {1e6, 0.0, 0.0},
                                          glm::dvec3(1e6 - std::cos(elevation), std::sin(elevation), 0.3));
        const CameraInput input{.cursor = {900.0, 400.0}, .lens = 2.0};
        const glm::dvec3 target = rayUnder(camera, input.cursor, input.extent);
        int steps = 0;
        while (camera.fovY > scene::radiansOf(kNarrowestDegrees) * 1.001) {
            const scene::Camera zoomed = zoomLens(camera, input);
            ASSERT_LT(zoomed.fovY, camera.fovY);
            camera = zoomed;
            expectLevel(camera);
            const glm::dvec2 seen = pixelOf(camera, camera.position + 1e6 * target, input.extent);
            ASSERT_NEAR(glm::distance(seen, input.cursor), 0.0, 0.05)
                << elevation << " after " << ++steps << " at " << scene::degreesOf(camera.fovY);
        }
        EXPECT_EQ(camera.fovY, scene::radiansOf(kNarrowestDegrees));
        expectSame(zoomLens(camera, input), camera); // at its end
    }
}

TEST(LensZoom, IsExponentialReversibleAndBounded) {
    const scene::Camera camera = cameraWith(30.0, glm::dvec3(0.0), {0.0, 0.0, -1.0});
    const CameraInput in{.cursor = {10.0, 700.0}, .lens = 1.0};
    CameraInput out = in;
    out.lens = -1.0;
    const scene::Camera once = zoomLens(camera, in);
    EXPECT_NEAR(once.fovY / camera.fovY, std::exp(-kZoomPerNotch), 1e-12);
    const scene::Camera back = zoomLens(once, out);
    EXPECT_NEAR(back.fovY / camera.fovY, 1.0, 1e-12);
    EXPECT_NEAR(glm::distance(back.back, camera.back), 0.0, 1e-9);
    out.lens = -1e3;
    EXPECT_EQ(zoomLens(camera, out).fovY, scene::radiansOf(kWidestDegrees));
    expectSame(zoomLens(camera, {}), camera);
}

TEST(LensZoom, LensesAreThoseOfTheCommandLine) {
    scene::Camera camera = cameraWith(61.7, glm::dvec3(0.0), {0.3, 0.1, -1.0});
    for (int i = 0; i < 300; ++i) {
        camera = zoomLens(camera, {.cursor = {200.0, 300.0}, .lens = 0.37 * (i % 5 - 1.5)});
        expectSame(scene::canonical(camera), camera);
        ASSERT_FALSE(testing::Test::HasFailure()) << i;
    }
}

TEST(LensZoom, AGamepadZoomsToTheMiddle) {
    const scene::Camera camera = cameraWith(30.0, glm::dvec3(0.0), {0.2, 0.0, -1.0});
    const scene::Camera zoomed = zoomLens(camera, {.axes = {.zoom = 1.0}, .seconds = 0.1});
    EXPECT_LT(zoomed.fovY, camera.fovY);
    EXPECT_EQ(zoomed.back, camera.back);
}

/// A notch changes no lens by more than it does any other.
TEST(LensZoom, LeadsALensFromBeyondTheLimitsBack) {
    const CameraInput in{.cursor = {10.0, 700.0}, .lens = 1.0};
    CameraInput out = in;
    out.lens = -1.0;
    const scene::Camera wide = cameraWith(120.0, glm::dvec3(0.0), {0.0, 0.0, -1.0});
    EXPECT_NEAR(zoomLens(wide, in).fovY / wide.fovY, std::exp(-kZoomPerNotch), 1e-12);
    EXPECT_NEAR(zoomLens(wide, out).fovY, wide.fovY, 1e-12);
    const scene::Camera narrow = cameraWith(1e-5, glm::dvec3(0.0), {0.0, 0.0, -1.0});
    EXPECT_NEAR(zoomLens(narrow, out).fovY / narrow.fovY, std::exp(kZoomPerNotch), 1e-12);
    EXPECT_NEAR(zoomLens(narrow, in).fovY / narrow.fovY, 1.0, 1e-12);
}

TEST(SetLens, HoldsTheLimits) {
    EXPECT_EQ(setLens({}, 45.0).fovY, scene::radiansOf(45.0));
    EXPECT_EQ(setLens({}, 170.0).fovY, scene::radiansOf(kWidestDegrees));
    EXPECT_EQ(setLens({}, -1.0).fovY, scene::radiansOf(kNarrowestDegrees));
}

TEST(Gamepad, RestsWithinTheDeadZoneAndIsContinuousBeyond) {
    const GamepadCurve curve;
    EXPECT_EQ(shapeStick({0.1, -0.1}), glm::dvec2(0.0));
    EXPECT_EQ(shapeStick({std::nan(""), 1.0}), glm::dvec2(0.0));
    EXPECT_EQ(shapeStick({INFINITY, 0.0}), glm::dvec2(0.0));
    EXPECT_NEAR(shapeStick({curve.deadZone + 1e-6, 0.0}).x, 0.0, 1e-9);
    EXPECT_NEAR(glm::length(shapeStick({1.0, 1.0})), 1.0, 1e-12); // corners reach no further
    EXPECT_NEAR(glm::length(shapeStick({0.0, -1.0})), 1.0, 1e-12);
    double last = 0.0;
    for (double x = 0.0; x <= 1.0; x += 0.01) {
        const double shaped = shapeStick({x, 0.0}).x;
        EXPECT_GE(shaped, last);
        EXPECT_LE(shaped, x); // finer near rest
        last = shaped;
    }
    const glm::dvec2 askew = shapeStick({0.3, 0.4});
    EXPECT_NEAR(askew.y / askew.x, 4.0 / 3.0, 1e-12); // the direction stays
}

TEST(Gamepad, SticksAndTriggersMeanWhatTheySay) {
    EXPECT_EQ(gamepadAxes({}), CameraAxes{});
    const CameraAxes axes = gamepadAxes({.leftX = 1.0,
                                         .leftY = -1.0,
                                         .rightX = 0.0,
                                         .rightY = -1.0,
                                         .leftTrigger = -1.0,
                                         .rightTrigger = 1.0,
                                         .leftBumper = false,
                                         .rightBumper = true});
    EXPECT_GT(axes.move.x, 0.0);
    EXPECT_EQ(axes.move.y, 1.0);
    EXPECT_GT(axes.move.z, 0.0); // forward is the stick's up
    EXPECT_GT(axes.look.y, 0.0);
    EXPECT_EQ(axes.zoom, 1.0);
}

} // namespace

} // namespace cdr::viewer
