#pragma once

/// @file
/// @errors None. What a path gives for a frame throws as lookAt().
/// @units Places and lengths are in world space, in scene units.

#include <cdr/base/export.h>
#include <cdr/scene/camera.h>

#include <cstdint>
#include <functional>

namespace cdr::scene {

/// A camera as a pure function of the frame number, so that any frame can be rendered alone.
struct CameraPath {
    /// The length of the path. Frame numbers beyond it repeat it, or stay at the end of an animation.
    std::uint32_t frames = 1;
    std::function<Camera(std::uint32_t frame)> at; ///< the camera of a frame
};

/// The same camera at every frame.
CDR_EXPORT CameraPath stillPath(const Camera& camera);

/// Circles `target` once about the y axis at `radius` and at its height, looking at it. Frame 0 is at +z.
/// @throws base::InputError for no frames.
CDR_EXPORT CameraPath orbitPath(const Camera& lens, const glm::dvec3& target, double radius,
                                std::uint32_t frames);

/// Turns once about the y axis without moving. Frame 0 looks down -z.
/// @throws base::InputError for no frames.
CDR_EXPORT CameraPath turnPath(const Camera& lens, const glm::dvec3& eye, std::uint32_t frames);

} // namespace cdr::scene
