#pragma once

#include <cdr/scene/camera.h>

#include <cstdint>
#include <functional>

namespace cdr::scene {

/// A camera as a function of the frame number: pure, so any frame can be rendered by itself.
struct CameraPath {
    std::uint32_t frames = 1; ///< the path's natural length; frame numbers beyond it go on periodically
    std::function<Camera(std::uint32_t frame)> at;
};

/// The same camera at every frame.
CameraPath stillPath(const Camera& camera);

/// Circles `target` once about the y axis at `radius`, level with it, looking at it; frame 0 is at +z.
CameraPath orbitPath(const Camera& lens, const glm::dvec3& target, double radius, std::uint32_t frames);

/// Turns once about the y axis on the spot; frame 0 looks down -z.
CameraPath turnPath(const Camera& lens, const glm::dvec3& eye, std::uint32_t frames);

} // namespace cdr::scene
