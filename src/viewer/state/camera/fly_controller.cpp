#include "fly_controller.h"

#include "heading.h"

#include <algorithm>
#include <cmath>

namespace cdr::viewer {

namespace {

constexpr double kMostAhead = 20.0; ///< of a step: exp() of a far scroll would be infinite

double amount(const CameraKeys& keys, CameraKey more, CameraKey less, double axis) {
    const double held = (keys.has(more) ? 1.0 : 0.0) - (keys.has(less) ? 1.0 : 0.0);
    return std::clamp(held + axis, -1.0, 1.0);
}

/// Right, up and ahead, each from -1 to 1.
glm::dvec3 wish(const CameraInput& input) {
    return {amount(input.keys, CameraKey::right, CameraKey::left, input.axes.move.x),
            amount(input.keys, CameraKey::up, CameraKey::down, input.axes.move.y),
            amount(input.keys, CameraKey::forward, CameraKey::backward, input.axes.move.z)};
}

double rateOf(const CameraKeys& keys, const FlySpeed& speed) {
    const double faster = keys.has(CameraKey::faster) ? speed.fasterBy : 1.0;
    const double slower = keys.has(CameraKey::slower) ? speed.fasterBy : 1.0;
    return speed.perSecond * faster / slower;
}

scene::Camera look(const scene::Camera& camera, const CameraInput& input, double seconds,
                   const FlySpeed& speed) {
    const double pixel = footprintSlope(camera, input.extent.height);
    const double axisPixels = speed.axisTurnHeights * seconds * input.extent.height;
    const glm::dvec2 pixels = glm::dvec2(input.drag.x, -input.drag.y) + axisPixels * input.axes.look;
    if (pixels == glm::dvec2(0.0)) {
        return camera;
    }
    const Heading heading = headingOf(camera);
    // Near straight down a turn about the vertical moves the picture's centre little. A narrow lens makes up
    // for that, as far as the picture does not spin.
    const double widest = std::max(1.0, 0.5 * kSteepest / camera.fovY);
    const double upright = std::min(1.0 / std::cos(heading.elevation), widest);
    return lookingAlong(camera,
                        turned(heading, upright * std::atan(pixel * pixels.x), std::atan(pixel * pixels.y)));
}

} // namespace

scene::Camera fly(const scene::Camera& camera, const CameraInput& input, double surfaceView,
                  const FlySpeed& speed) {
    const double seconds = std::clamp(input.seconds, 0.0, kLongestStep);
    scene::Camera flown = look(camera, input, seconds, speed);
    const glm::dvec3 wanted = wish(input);
    const double rate = rateOf(input.keys, speed) * seconds;
    // The surface comes nearer all the while: its distance falls as exp(-ahead).
    const double ahead = std::clamp(rate * wanted.z + speed.perNotch * input.scroll, -kMostAhead, kMostAhead);
    if (ahead == 0.0 && rate * glm::dvec2(wanted) == glm::dvec2(0.0)) {
        return flown;
    }
    const double travelled = -surfaceView * std::expm1(-ahead);
    const double meanView = ahead == 0.0 ? surfaceView : travelled / ahead;
    const double across = rate * meanView * footprintSlope(camera, 1);
    flown.position += across * (wanted.x * flown.right + wanted.y * flown.up) - travelled * flown.back;
    return flown;
}

double surfaceAhead(const scene::Camera& now, const scene::Camera& then, double surfaceView) {
    const double travelled = glm::dot(then.position - now.position, then.back);
    return std::max(surfaceView - travelled, 0.0);
}

double flightDistance(const scene::Camera& camera, double surfaceView, double lastView) {
    const auto isOne = [](double view) { return std::isfinite(view) && view > 0.0; };
    // Short of the surface by two near planes, so that it is not cut open.
    const double view = isOne(surfaceView) ? surfaceView - 2.0 * camera.nearView
                        : isOne(lastView)  ? lastView
                                           : std::sqrt(camera.nearView) * std::sqrt(camera.farView);
    return std::clamp(view, camera.nearView, camera.farView);
}

} // namespace cdr::viewer
