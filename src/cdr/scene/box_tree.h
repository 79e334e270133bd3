#pragma once

#include <cdr/base/export.h>

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace cdr::scene {

/// A box along the axes that grows with what is added; empty until then. Once something is added that is not a number, no
/// side is one.
struct Box {
    glm::dvec3 low{std::numeric_limits<double>::infinity()};
    glm::dvec3 high{-std::numeric_limits<double>::infinity()};

    void add(const glm::dvec3& point) { add(Box{.low = point, .high = point}); }
    void add(const Box& box) {
        low = glm::min(low, box.low);
        high = glm::max(high, box.high);
        if (glm::any(glm::isnan(box.low)) || glm::any(glm::isnan(box.high))) { // comparisons lose these
            low = high = glm::dvec3(std::numeric_limits<double>::quiet_NaN());
        }
    }
    /// A sphere.
    void add(const glm::dvec3& centre, double radius) {
        add(Box{.low = centre - radius, .high = centre + radius});
    }
    bool isEmpty() const { return low.x > high.x; }
    /// The origin where it is empty.
    glm::dvec3 centre() const { return isEmpty() ? glm::dvec3(0.0) : (low + high) * 0.5; }
    CDR_EXPORT std::array<glm::dvec3, 8> corners() const;
    double diagonal() const { return glm::distance(low, high); }
    /// 0, 1 or 2: the axis of the longest side, the first of equals.
    int longestAxis() const;
};

/// A binary tree of boxes over items that have boxes. Each inner node halves its items by their centres along its longest
/// side.
class BoxTree {
  public:
    struct Node {
        Box box;
        /// A leaf's first of order(), or else the first of two children that follow each other.
        std::uint32_t first = 0;
        std::uint32_t count = 0; ///< a leaf's items; 0 for an inner node
    };
    /// Most nodes between the root and a leaf: 2^32 items are halved 32 times.
    static constexpr std::size_t kMaxDepth = 32;

    /// @param boxes of the items, fewer than 2^31; finite.
    explicit BoxTree(std::span<const Box> boxes);

    /// The root first; none where there are no items.
    std::span<const Node> nodes() const { return m_nodes; }
    /// The items, leaf by leaf.
    std::span<const std::uint32_t> order() const { return m_order; }

  private:
    void build(std::span<const Box> boxes, std::uint32_t node, std::uint32_t begin, std::uint32_t end);

    std::vector<Node> m_nodes;
    std::vector<std::uint32_t> m_order;
};

} // namespace cdr::scene
