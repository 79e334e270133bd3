#include <cdr/render/shadows/light_shape.h>
#include <cdr/scene/box_tree.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace cdr::render {

namespace {

/// The device finds the angle from the axis in float32: by a cosine, and by places that are rounded too.
constexpr double kCosineRounding = 0x1p-16;
constexpr double kPlaceRounding = 0x1p-10; ///< radians, and a share of the range

double cosineTo(const glm::dvec3& axis, const glm::dvec3& direction) {
    return glm::dot(axis, direction) / glm::length(direction);
}

/// The greatest on the edge where x is given. A function of y with one extreme at most, in between or at an end.
double greatestOnEdge(const glm::dvec3& axis, double x, double lowY, double highY, double depth) {
    const auto at = [&](double y) { return cosineTo(axis, {x, y, depth}); };
    double greatest = std::max(at(lowY), at(highY));
    const double along = axis.x * x + axis.z * depth;
    if (along > 0.0) { // else the extreme is the least
        const double extreme = axis.y * (x * x + depth * depth) / along;
        greatest = std::max(greatest, at(std::clamp(extreme, lowY, highY)));
    }
    return greatest;
}

/// Of points, to a box around corners.
double distanceTo(const std::array<glm::dvec3, 8>& corners, const glm::dvec3& point) {
    scene::Box box;
    for (const glm::dvec3& corner : corners) {
        box.add(corner);
    }
    return glm::distance(point, glm::clamp(point, box.low, box.high));
}

} // namespace

double greatestCosine(const glm::dvec3& axis, const DirectionWindow& window) {
    const glm::dvec2 through = glm::dvec2(axis) * window.depth;
    const bool isThrough = axis.z > 0.0 && glm::all(glm::greaterThanEqual(through, window.low * axis.z)) &&
                           glm::all(glm::lessThanEqual(through, window.high * axis.z));
    if (isThrough) {
        return 1.0;
    }
    const glm::dvec3 swapped(axis.y, axis.x, axis.z);
    const auto& [low, high, depth] = window;
    return std::max({greatestOnEdge(axis, low.x, low.y, high.y, depth),
                     greatestOnEdge(axis, high.x, low.y, high.y, depth),
                     greatestOnEdge(swapped, low.y, low.x, high.x, depth),
                     greatestOnEdge(swapped, high.y, low.x, high.x, depth)});
}

bool isInCone(const scene::PointLight& light, const LightView& view) {
    if (!light.cone) {
        return true;
    }
    const DirectionWindow shown{.low = view.low,
                                .high = view.low + view.texel * glm::dvec2(view.size.width, view.size.height),
                                .depth = 1.0 / view.wPerUnit};
    const double edge = std::acos(std::max(std::cos(light.cone->outer) - kCosineRounding, -1.0));
    const double outside = std::cos(edge + kPlaceRounding);
    return !(greatestCosine(view.toLight(light.cone->direction), shown) < outside);
}

bool isInRange(const scene::PointLight& light, const glm::dvec3& camera, const ReceiverSlice& slice) {
    if (!light.range) {
        return true;
    }
    const glm::dvec3 place = light.position - camera;
    const double nearest = std::max(distanceTo(slice.view, place), distanceTo(slice.boxes, place));
    return !(nearest > *light.range * (1.0 + kPlaceRounding));
}

} // namespace cdr::render
