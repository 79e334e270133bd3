#pragma once

#include "camera_input.h"

#include <cdr/scene/camera.h>

namespace cdr::viewer {

/// How fast a flight goes.
struct FlySpeed {
    double perSecond = 0.7;       ///< ahead: share of the way to what is looked at; sideways: of the picture
    double fasterBy = 8.0;        ///< with CameraKey::faster, and the reverse with slower
    double perNotch = 0.15;       ///< the same for a notch of scrolling
    double axisTurnHeights = 1.5; ///< picture heights per second that a gamepad turns by at full deflection
};

/// Flies freely: keys and scrolling move, dragging looks about, so that what is under the pointer follows it pixel by
/// pixel.
///
/// Speed follows from the distance of what is looked at. Ahead it is a share of the way there, so a surface
/// is approached and never passed. Sideways it is a share of what the picture covers there, so it looks
/// equally fast through every lens. Independent of the frame rate. A camera that turns loses its roll; one
/// that does not keeps its bits.
/// @param surfaceView view distance of what is looked at, or of the nearest surface: see flightDistance().
scene::Camera fly(const scene::Camera& camera, const CameraInput& input, double surfaceView,
                  const FlySpeed& speed = {});

/// What is left of the way to a surface that was `surfaceView` ahead of `then`. Pictures come late: without this a camera
/// that flies on would pass what they show. 0 where it was passed.
double surfaceAhead(const scene::Camera& now, const scene::Camera& then, double surfaceView);

/// The distance that a flight's speed follows from. It is a little less than `surfaceView`, so that an approach
/// stops before the near plane cuts the surface. If `surfaceView` is infinite or 0, it is the last such distance.
/// Without a last one, it is the geometric mean of near and far. It is always between near and far.
/// @param lastView what this gave last, 0 at first.
double flightDistance(const scene::Camera& camera, double surfaceView, double lastView);

} // namespace cdr::viewer
