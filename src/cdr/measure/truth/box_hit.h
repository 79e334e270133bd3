#pragma once

#include <cdr/measure/truth/object_ray.h>

#include <glm/glm.hpp>

#include <cmath>

namespace cdr::measure {

/// The nearest visible hit on a box about the origin, as a view distance; kNoHit when there is none. Slabs
/// (Kay and Kajiya 1986). A ray within a face's own plane counts as inside.
/// @param halfSides object space, each at least 0.
/// @param sides both: the face where the ray leaves the box is visible too.
inline double nearestOnBox(const ObjectRay& ray, const glm::dvec3& halfSides, Sidedness sides,
                           const ViewRange& range) {
    double enter = -kNoHit;
    double leave = kNoHit;
    for (int axis = 0; axis < 3; ++axis) {
        const double side = std::copysign(halfSides[axis], ray.direction[axis]);
        const double slabEnter = (-side - ray.origin[axis]) / ray.direction[axis];
        const double slabLeave = (side - ray.origin[axis]) / ray.direction[axis];
        // 0/0, a ray within the face's plane, compares false and so bounds nothing.
        enter = slabEnter > enter ? slabEnter : enter;
        leave = slabLeave < leave ? slabLeave : leave;
    }
    if (!(enter <= leave)) {
        return kNoHit;
    }
    if (range.holds(enter)) {
        return enter;
    }
    return sides == Sidedness::both && range.holds(leave) ? leave : kNoHit;
}

} // namespace cdr::measure
