#include <cdr/scene/box_tree.h>

#include <algorithm>
#include <numeric>

namespace cdr::scene {

namespace {

constexpr std::uint32_t kLeafItems = 4;

} // namespace

std::array<glm::dvec3, 8> Box::corners() const {
    std::array<glm::dvec3, 8> all;
    for (std::size_t i = 0; i < all.size(); ++i) {
        all[i] = {(i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y,
                  (i & 4) != 0 ? high.z : low.z};
    }
    return all;
}

int Box::longestAxis() const {
    const glm::dvec3 sides = high - low;
    return sides.x >= sides.y && sides.x >= sides.z ? 0 : sides.y >= sides.z ? 1 : 2;
}

BoxTree::BoxTree(std::span<const Box> boxes) : m_order(boxes.size()) {
    std::iota(m_order.begin(), m_order.end(), 0u);
    if (!boxes.empty()) {
        m_nodes.reserve(boxes.size());
        m_nodes.emplace_back();
        build(boxes, 0, 0, static_cast<std::uint32_t>(boxes.size()));
    }
}

void BoxTree::build(std::span<const Box> boxes, std::uint32_t node, std::uint32_t begin, std::uint32_t end) {
    Box box;
    for (std::uint32_t i = begin; i < end; ++i) {
        box.add(boxes[m_order[i]]);
    }
    m_nodes[node] = {.box = box, .first = begin, .count = end - begin};
    if (end - begin <= kLeafItems) {
        return;
    }
    const int axis = box.longestAxis();
    const std::uint32_t middle = begin + (end - begin) / 2;
    const auto centre2 = [&](std::uint32_t item) { return boxes[item].low[axis] + boxes[item].high[axis]; };
    std::nth_element(m_order.begin() + begin, m_order.begin() + middle, m_order.begin() + end,
                     [&](std::uint32_t a, std::uint32_t b) { return centre2(a) < centre2(b); });
    const auto children = static_cast<std::uint32_t>(m_nodes.size());
    m_nodes[node].first = children;
    m_nodes[node].count = 0;
    m_nodes.resize(m_nodes.size() + 2);
    build(boxes, children, begin, middle);
    build(boxes, children + 1, middle, end);
}

} // namespace cdr::scene
