#include "orbit_controller.h"

#include "heading.h"

#include <algorithm>
#include <cmath>

namespace cdr::viewer {

namespace {

double held(const CameraKeys& keys, CameraKey more, CameraKey less) {
    return (keys.has(more) ? 1.0 : 0.0) - (keys.has(less) ? 1.0 : 0.0);
}

/// Radians to turn by, right and up.
glm::dvec2 turnOf(const CameraInput& input, double seconds, const OrbitSpeed& speed) {
    const glm::dvec2 byDrag = speed.turnPerHeight / input.extent.height * input.drag;
    const glm::dvec2 byKeys(held(input.keys, CameraKey::left, CameraKey::right),
                            held(input.keys, CameraKey::down, CameraKey::up));
    return glm::dvec2(byDrag.x, -byDrag.y) +
           speed.perSecond * seconds * (byKeys + glm::dvec2(-input.axes.look.x, -input.axes.look.y));
}

/// Natural logarithm of the distance to gain.
double dollyOf(const CameraInput& input, double seconds, const OrbitSpeed& speed) {
    const double byKeys = held(input.keys, CameraKey::backward, CameraKey::forward) - input.axes.move.z;
    return -speed.perNotch * input.scroll + speed.perSecond * seconds * byKeys;
}

} // namespace

Orbit orbit(const Orbit& before, const CameraInput& input, const OrbitSpeed& speed) {
    const double seconds = std::clamp(input.seconds, 0.0, kLongestStep);
    Orbit after = before;
    scene::Camera& camera = after.camera;
    // Where the pivot is seen stays, whatever turns; its distance alone changes.
    glm::dvec3 seen = before.camera.toView(before.pivot);
    if (input.pan != glm::dvec2(0.0)) {
        const double pixel = footprintSlope(camera, input.extent.height) * std::max(-seen.z, camera.nearView);
        const glm::dvec3 shift =
            pixel * (-input.pan.x * before.camera.right + input.pan.y * before.camera.up);
        camera.position += shift;
        after.pivot += shift;
    }
    const glm::dvec2 turn = turnOf(input, seconds, speed);
    const double dolly = dollyOf(input, seconds, speed);
    const double distance = glm::length(seen);
    if ((turn == glm::dvec2(0.0) && dolly == 0.0) || !(distance > 0.0)) {
        return after;
    }
    if (turn != glm::dvec2(0.0)) {
        camera = lookingAlong(camera, turned(headingOf(camera), turn.x, turn.y));
    }
    if (dolly != 0.0) {
        const double nearest = std::min(speed.nearestView * camera.nearView, camera.farView);
        seen *= std::clamp(distance * std::exp(dolly), nearest, camera.farView) / distance;
    }
    camera.position = after.pivot - (seen.x * camera.right + seen.y * camera.up + seen.z * camera.back);
    return after;
}

} // namespace cdr::viewer
