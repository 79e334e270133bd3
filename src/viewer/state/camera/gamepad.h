#pragma once

#include "camera_input.h"

namespace cdr::viewer {

/// A gamepad's sticks and triggers as window systems report them. Sticks are -1 to 1, x right, y down;
/// triggers -1 at rest to 1 pressed.
struct GamepadState {
    double leftX = 0.0;
    double leftY = 0.0;
    double rightX = 0.0;
    double rightY = 0.0;
    double leftTrigger = -1.0;
    double rightTrigger = -1.0;
    bool leftBumper = false;
    bool rightBumper = false;
};

/// How deflection becomes motion.
struct GamepadCurve {
    double deadZone = 0.15; ///< deflection that counts as rest, 0 to below 1
    double exponent = 2.0;  ///< above 1 is finer near rest
};

/// A stick's deflection without its round dead zone, and its length bent by the curve. Continuous, 0 at
/// rest, at most 1 long. What is not finite is rest.
glm::dvec2 shapeStick(const glm::dvec2& stick, const GamepadCurve& curve = {});

/// The left stick moves, the bumpers lift and sink, the right stick looks, the triggers zoom.
CameraAxes gamepadAxes(const GamepadState& state, const GamepadCurve& curve = {});

} // namespace cdr::viewer
