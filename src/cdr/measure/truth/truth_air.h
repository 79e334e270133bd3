#pragma once

#include <cdr/scene/scene.h>

#include <glm/glm.hpp>

namespace cdr::measure {

/// What a colour becomes through the air of a scene, summed along the ray in float64; the same colour where the scene has none.
/// The shading pass has a fit in place of the sum towards the Sun, and fewer steps.
/// @param eye world space.
/// @param fromEye the coloured point less the eye, world axes, not zero.
glm::dvec3 throughAir(const scene::Scene& scene, const glm::dvec3& eye, const glm::dvec3& fromEye,
                      const glm::dvec3& color);

/// The scene's background as it is seen through the air.
/// @param direction world axes, of any length but zero.
glm::dvec3 backgroundAlong(const scene::Scene& scene, const glm::dvec3& eye, const glm::dvec3& direction);

} // namespace cdr::measure
