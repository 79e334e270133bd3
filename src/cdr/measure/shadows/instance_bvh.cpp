#include <cdr/measure/shadows/instance_bvh.h>

#include <algorithm>

namespace cdr::measure {

namespace {

/// By how much boxes are enlarged, as a share of the numbers they are made from: covers the roundings of ray against box.
constexpr double kPad = 0x1p-48;

} // namespace

InstanceBvh::InstanceBvh(const scene::Instances& instances, std::span<const std::uint32_t> some)
    : m_instances(some.begin(), some.end()),
      m_tree(boxesOf(instances, some)) {}

std::vector<scene::Box> InstanceBvh::boxesOf(const scene::Instances& instances,
                                             std::span<const std::uint32_t> some) {
    std::vector<scene::Box> boxes;
    boxes.reserve(some.size());
    for (const std::uint32_t instance : some) {
        const glm::dvec3 centre = instances.position(instance);
        const glm::dvec3 reach =
            static_cast<double>(instances.radius[instance]) * (1.0 + kPad) + kPad * glm::abs(centre);
        boxes.push_back({.low = centre - reach, .high = centre + reach});
    }
    return boxes;
}

bool InstanceBvh::isMet(const scene::Box& box, const glm::dvec3& origin, const glm::dvec3& inverse,
                        double first, double last) {
    const double size = glm::length(origin) * kPad;
    for (int axis = 0; axis < 3; ++axis) {
        const double a = (box.low[axis] - size - origin[axis]) * inverse[axis];
        const double b = (box.high[axis] + size - origin[axis]) * inverse[axis];
        if (a == a && b == b) { // a ray within the plane of a side says nothing
            first = std::max(first, std::min(a, b) * (1.0 - kPad));
            last = std::min(last, std::max(a, b) * (1.0 + kPad));
        }
    }
    return first <= last;
}

} // namespace cdr::measure
