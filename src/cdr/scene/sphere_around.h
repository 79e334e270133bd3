#pragma once

#include <cdr/scene/box_tree.h>
#include <cdr/scene/scene.h>

#include <algorithm>
#include <cstddef>

namespace cdr::scene {

/// World space.
struct Sphere {
    glm::dvec3 centre{0.0};
    double radius = 0.0; ///< scene units
};

/// A sphere around the instances that are meant, about the middle of their box. Without any, a point at the origin. Places
/// of a world that hold no instance do not count.
/// @param isMeant tells by an instance's index
template <typename IsMeant>
Sphere sphereAround(const Instances& instances, const IsMeant& isMeant) {
    const auto counts = [&](std::size_t i) { return instances.radius[i] != kNoRadius && isMeant(i); };
    Box box;
    for (std::size_t i = 0; i < instances.size(); ++i) {
        if (counts(i)) {
            box.add(instances.position(i), static_cast<double>(instances.radius[i]));
        }
    }
    Sphere sphere{.centre = box.centre()};
    for (std::size_t i = 0; i < instances.size(); ++i) {
        if (counts(i)) {
            sphere.radius = std::max(sphere.radius, glm::distance(sphere.centre, instances.position(i)) +
                                                        static_cast<double>(instances.radius[i]));
        }
    }
    return sphere;
}

/// The same for all of them.
inline Sphere sphereAround(const Instances& instances) {
    return sphereAround(instances, [](std::size_t) { return true; });
}

} // namespace cdr::scene
