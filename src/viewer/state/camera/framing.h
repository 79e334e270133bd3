#pragma once

#include <cdr/scene/camera.h>
#include <cdr/scene/scene.h>
#include <cdr/scene/sphere_around.h>

#include <cstdint>

namespace cdr::viewer {

/// What holds an object, in world space.
using Ball = scene::Sphere;

/// About all instances of an object: at the middle of their box. Without any, a point at the origin.
Ball ballOf(const scene::Instances& instances, std::uint32_t object);

/// The camera moved, not turned, so that the ball stands in the middle of the picture and fills it.
/// @param aspect width over height.
scene::Camera framed(const scene::Camera& camera, const Ball& ball, double aspect);

} // namespace cdr::viewer
