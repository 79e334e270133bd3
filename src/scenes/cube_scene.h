#pragma once

#include <cdr/scene/scene.h>

#include <glm/glm.hpp>

#include <cstdint>

namespace cdr::scenes {

/// A scene with one white material, a unit cube as its only mesh and a light at the origin.
scene::Scene cubeScene(const char* name, double halfDistanceOfLight);

/// Adds the unit cube that is mesh 0 as an object of its own. Its sides are the columns of `basis`.
void addBox(scene::Scene& scene, std::uint32_t material, const glm::dvec3& centre, const glm::mat3& basis);

/// Adds a cube with sides of length `scale` as an object of its own.
void addCube(scene::Scene& scene, const glm::dvec3& position, float scale = 1.0f);

} // namespace cdr::scenes
