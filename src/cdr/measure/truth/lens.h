#pragma once

#include <cdr/scene/camera.h>

#include <cmath>

namespace cdr::measure {

/// Half the picture's height at view distance 1. It does not use scene::frustumOf(), since the truth shares no projection code
/// with the renderer.
inline double halfHeightSlope(const scene::Camera& camera) {
    return std::tan(0.5 * camera.fovY);
}

/// Pixels that one unit of slope (height over view distance) covers.
/// @param height of the picture in pixels.
inline double pixelsPerSlope(const scene::Camera& camera, double height) {
    return 0.5 * height / halfHeightSlope(camera);
}

/// Where the view axis meets the picture: in pixels, with (0, 0) at the centre of the first one.
inline glm::dvec2 axisPixel(const scene::Camera& camera, double width, double height) {
    return glm::dvec2(0.5 * (width - 1.0), 0.5 * (height - 1.0)) +
           pixelsPerSlope(camera, height) * glm::dvec2(-camera.lensShift.x, camera.lensShift.y);
}

} // namespace cdr::measure
