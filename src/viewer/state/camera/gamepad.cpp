#include "gamepad.h"

#include <algorithm>
#include <cmath>

namespace cdr::viewer {

namespace {

/// A trigger's way from rest, 0 to 1.
double pressed(double trigger, const GamepadCurve& curve) {
    const double way = std::isfinite(trigger) ? 0.5 * (std::clamp(trigger, -1.0, 1.0) + 1.0) : 0.0;
    return shapeStick({way, 0.0}, curve).x;
}

} // namespace

glm::dvec2 shapeStick(const glm::dvec2& stick, const GamepadCurve& curve) {
    const double length = glm::length(stick);
    if (!std::isfinite(length) || length <= curve.deadZone) {
        return glm::dvec2(0.0);
    }
    const double beyond = (std::min(length, 1.0) - curve.deadZone) / (1.0 - curve.deadZone);
    return std::pow(beyond, curve.exponent) / length * stick;
}

CameraAxes gamepadAxes(const GamepadState& state, const GamepadCurve& curve) {
    const glm::dvec2 left = shapeStick({state.leftX, state.leftY}, curve);
    const glm::dvec2 right = shapeStick({state.rightX, state.rightY}, curve);
    const double lift = (state.rightBumper ? 1.0 : 0.0) - (state.leftBumper ? 1.0 : 0.0);
    return {.move = {left.x, lift, -left.y},
            .look = {right.x, -right.y},
            .zoom = pressed(state.rightTrigger, curve) - pressed(state.leftTrigger, curve)};
}

} // namespace cdr::viewer
