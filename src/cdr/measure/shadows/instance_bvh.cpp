#include <cdr/measure/shadows/instance_bvh.h>

#include <algorithm>

namespace cdr::measure {

namespace {

constexpr std::uint32_t kLeafInstances = 4;
/// By how much boxes are enlarged, as a share of the numbers they are made from: covers the roundings of ray against box.
constexpr double kPad = 0x1p-48;

} // namespace

InstanceBvh::InstanceBvh(const scene::Instances& instances, std::span<const std::uint32_t> some)
    : m_order(some.begin(), some.end()) {
    if (!m_order.empty()) {
        m_nodes.reserve(m_order.size());
        m_nodes.emplace_back();
        build(instances, 0, 0, static_cast<std::uint32_t>(m_order.size()));
    }
}

void InstanceBvh::build(const scene::Instances& instances, std::uint32_t node, std::uint32_t begin,
                        std::uint32_t end) {
    glm::dvec3 low(std::numeric_limits<double>::infinity());
    glm::dvec3 high(-std::numeric_limits<double>::infinity());
    for (std::uint32_t i = begin; i < end; ++i) {
        const glm::dvec3 centre = instances.position(m_order[i]);
        const glm::dvec3 reach =
            static_cast<double>(instances.radius[m_order[i]]) * (1.0 + kPad) + kPad * glm::abs(centre);
        low = glm::min(low, centre - reach);
        high = glm::max(high, centre + reach);
    }
    m_nodes[node].low = low;
    m_nodes[node].high = high;
    if (end - begin <= kLeafInstances) {
        m_nodes[node].first = begin;
        m_nodes[node].count = end - begin;
        return;
    }
    const glm::dvec3 size = high - low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(m_order.begin() + begin, m_order.begin() + middle, m_order.begin() + end,
                     [&](std::uint32_t a, std::uint32_t b) {
                         return instances.position(a)[axis] < instances.position(b)[axis];
                     });
    const auto children = static_cast<std::uint32_t>(m_nodes.size());
    m_nodes[node].first = children;
    m_nodes.emplace_back();
    m_nodes.emplace_back();
    build(instances, children, begin, middle);
    build(instances, children + 1, middle, end);
}

bool InstanceBvh::isMet(const Node& node, const glm::dvec3& origin, const glm::dvec3& inverse, double first,
                        double last) {
    const double size = glm::length(origin) * kPad;
    for (int axis = 0; axis < 3; ++axis) {
        const double a = (node.low[axis] - size - origin[axis]) * inverse[axis];
        const double b = (node.high[axis] + size - origin[axis]) * inverse[axis];
        if (a == a && b == b) { // a ray within the plane of a side says nothing
            first = std::max(first, std::min(a, b) * (1.0 - kPad));
            last = std::min(last, std::max(a, b) * (1.0 + kPad));
        }
    }
    return first <= last;
}

} // namespace cdr::measure
