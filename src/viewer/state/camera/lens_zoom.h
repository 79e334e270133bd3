#pragma once

#include "camera_input.h"

#include <cdr/scene/camera.h>

namespace cdr::viewer {

inline constexpr double kWidestDegrees = 90.0;
inline constexpr double kNarrowestDegrees = 0.001;
/// Natural logarithm of the field of view that a notch of scrolling takes.
inline constexpr double kZoomPerNotch = 0.15;

/// Narrows the lens by a factor per notch, within the limits above, and turns so that what is under the
/// cursor stays there. The new field of view is one that `--fov` gives back to the bit (scene::radiansOf()).
scene::Camera zoomLens(const scene::Camera& camera, const CameraInput& input);

/// Sets the vertical field of view, in degrees, within the limits or at least no farther beyond them; the view direction
/// stays.
scene::Camera setLens(const scene::Camera& camera, double fovDegrees);

} // namespace cdr::viewer
