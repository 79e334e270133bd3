#pragma once

#include "camera_input.h"

#include <cdr/scene/camera.h>

namespace cdr::viewer {

/// A camera and the point it circles.
struct Orbit {
    scene::Camera camera;
    glm::dvec3 pivot{0.0}; ///< world space
};

/// How fast an orbit goes.
struct OrbitSpeed {
    double turnPerHeight = 2.0; ///< radians that dragging by the picture's height turns by
    double perNotch = 0.15;     ///< natural logarithm of the distance that a notch of scrolling dollies by
    double perSecond = 1.0;     ///< the same per second, and radians per second, by keys and gamepad
    double nearestView = 4.0;   ///< near planes that the pivot stays away
};

/// Circles the pivot. Dragging turns, scrolling changes the distance by a factor per notch. Panning shifts
/// camera and pivot by pixels at the pivot's distance. The pivot keeps its place in the picture whatever it
/// is, so picking one does not move the view. A camera that turns loses its roll.
Orbit orbit(const Orbit& before, const CameraInput& input, const OrbitSpeed& speed = {});

} // namespace cdr::viewer
