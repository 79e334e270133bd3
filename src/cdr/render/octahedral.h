#pragma once

#include <glm/glm.hpp>

#include <cmath>

namespace cdr::render {

/// Turns the other half of the octahedron inside out, or back.
template <typename T>
glm::vec<2, T> foldOctahedral(const glm::vec<2, T>& p) {
    return {(T(1) - std::abs(p.y)) * (p.x >= T(0) ? T(1) : T(-1)),
            (T(1) - std::abs(p.x)) * (p.y >= T(0) ? T(1) : T(-1))};
}

/// A direction, of any length, as two numbers in [-1, 1], as shaders/public/cdr_octahedral.glsl has it. (0, 0) for
/// no direction.
template <typename T>
glm::vec<2, T> encodeOctahedral(const glm::vec<3, T>& n) {
    const T sum = std::abs(n.x) + std::abs(n.y) + std::abs(n.z);
    if (!(sum > T(0))) {
        return glm::vec<2, T>(T(0));
    }
    const glm::vec<2, T> p(n.x / sum, n.y / sum);
    return n.z >= T(0) ? p : foldOctahedral(p);
}

/// The direction, not of unit length.
template <typename T>
glm::vec<3, T> decodeOctahedral(const glm::vec<2, T>& p) {
    const T z = T(1) - std::abs(p.x) - std::abs(p.y);
    return {z < T(0) ? foldOctahedral(p) : p, z};
}

} // namespace cdr::render
