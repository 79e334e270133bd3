#pragma once

#include <glm/glm.hpp>

namespace cdr::visibility {

/// How far from its place the device may put a vertex of an instance, before it is snapped to pixels. Float32 rounds by 2^-24
/// of the distance to the instance's far side: about eight times to turn and to move a vertex, and as often again until a
/// cascade's plane has cut a triangle.
/// @param fromCamera to the instance's centre. @param radius of its bounding sphere.
inline double vertexRounding(const glm::dvec3& fromCamera, double radius) {
    return 0x1p-20 * (glm::length(fromCamera) + radius);
}

} // namespace cdr::visibility
