#pragma once

#include <cdr/scene/camera.h>
#include <cdr/scene/scene.h>

#include <glm/glm.hpp>

namespace cdr::measure {

/// Ambient and point light that falls on a surface, linear, in float64, as the shading pass has it: what its
/// albedo is multiplied by.
/// @param fromCamera the point less the camera's position, world axes.
/// @param normal unit, world axes.
glm::dvec3 lightAt(const scene::Scene& scene, const scene::Camera& camera, const glm::dvec3& fromCamera,
                   const glm::dvec3& normal);

} // namespace cdr::measure
