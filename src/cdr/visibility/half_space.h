#pragma once

#include <glm/glm.hpp>

namespace cdr::visibility {

/// A box whose sides need not be at right angles.
struct SkewBox {
    glm::dvec3 middle{0.0};
    glm::dmat3 halfSides{0.0};

    /// How far it reaches from its middle along a direction, times the direction's length.
    double reach(const glm::dvec3& way) const {
        const glm::dvec3 sides = glm::abs(way * halfSides);
        return sides.x + sides.y + sides.z;
    }
};

/// A box of object space where an instance stands.
/// @param place of the instance. @param basis of it, its columns along the axes of `place`.
inline SkewBox placedBox(const glm::dvec3& place, const glm::dmat3& basis, const glm::vec3& middle,
                         const glm::vec3& half) {
    const glm::dvec3 sides(half);
    return {.middle = place + basis * glm::dvec3(middle),
            .halfSides = {basis[0] * sides.x, basis[1] * sides.y, basis[2] * sides.z}};
}

/// What is on one side of a plane: inside is where dot(normal, place) + offset >= 0.
struct HalfSpace {
    glm::dvec3 normal{0.0}; ///< of any length
    double offset = 0.0;
    double length = 0.0; ///< of the normal

    HalfSpace() = default;
    HalfSpace(const glm::dvec3& inwards, double distance)
        : normal(inwards),
          offset(distance),
          length(glm::length(inwards)) {}

    /// How deep inside a place is, times the normal's length.
    double depth(const glm::dvec3& place) const { return glm::dot(normal, place) + offset; }
    /// Whether something of a sphere is inside.
    bool meets(const glm::dvec3& centre, double radius) const { return !(depth(centre) < -radius * length); }
    /// Whether something of a box, or of what is as near to it as `around`, is inside.
    bool meets(const SkewBox& box, double around) const {
        return !(depth(box.middle) < -(box.reach(normal) + around * length));
    }
    /// Whether all of a sphere is inside.
    bool holds(const glm::dvec3& centre, double radius) const { return depth(centre) >= radius * length; }
};

} // namespace cdr::visibility
