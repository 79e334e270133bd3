#pragma once

#include <cdr/scene/scene.h>

#include <glm/glm.hpp>

namespace cdr::scenes {

/// A scene with one white material, a unit cube as its only mesh and a light at the origin.
scene::Scene cubeScene(const char* name, double halfDistanceOfLight);

/// Adds a cube with sides of length `scale` as an object of its own.
void addCube(scene::Scene& scene, const glm::dvec3& position, float scale = 1.0f);

} // namespace cdr::scenes
