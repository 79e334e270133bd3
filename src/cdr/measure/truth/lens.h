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

} // namespace cdr::measure
