#pragma once

#include <glm/glm.hpp>

#include <algorithm>

namespace cdr::visibility {

/// How far from its place the device may put a vertex of an instance, before it is snapped to pixels. Float32 rounds by 2^-24
/// of the distance to the instance's far side: about eight times to turn and to move a vertex, and as often again until a
/// cascade's plane has cut a triangle. Where view distances are counted from an anchor plane that is farther away, it rounds by
/// that plane's distance.
/// @param fromCamera to the instance's centre. @param radius of its bounding sphere. @param anchorView depth::ClipTerms.
inline double vertexRounding(const glm::dvec3& fromCamera, double radius, double anchorView = 0.0) {
    return 0x1p-20 * (std::max(glm::length(fromCamera), anchorView) + radius);
}

} // namespace cdr::visibility
