#pragma once

#include <cdr/scene/scene.h>

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace cdr::measure {

/// A scene's instances in a tree of boxes around their bounding spheres, for rays in any direction.
class InstanceBvh {
  public:
    /// @param some instances, each of which has a finite place and radius.
    InstanceBvh(const scene::Instances& instances, std::span<const std::uint32_t> some);

    /// Calls `meet` for each instance whose box a ray may pass at a parameter in [first, last]. `meet` returns the last
    /// parameter that matters from then on; less than `first` ends the search.
    /// @param origin world space. @param direction the ray is origin + t * direction.
    template <typename Meet>
    void visit(const glm::dvec3& origin, const glm::dvec3& direction, double first, double last,
               const Meet& meet) const {
        std::array<std::uint32_t, kMostDepth> open;
        std::size_t count = 0;
        if (!m_nodes.empty()) {
            open[count++] = 0;
        }
        const glm::dvec3 inverse = 1.0 / direction;
        while (count > 0 && last >= first) {
            const Node& node = m_nodes[open[--count]];
            if (!isMet(node, origin, inverse, first, last)) {
                continue;
            }
            if (node.count == 0) {
                open[count++] = node.first;
                open[count++] = node.first + 1;
                continue;
            }
            for (std::uint32_t i = node.first; i < node.first + node.count && last >= first; ++i) {
                last = meet(m_order[i]);
            }
        }
    }

  private:
    struct Node {
        glm::dvec3 low{0.0};
        glm::dvec3 high{0.0};
        std::uint32_t first =
            0; ///< a leaf's first of m_order, else the first of two children that follow each other
        std::uint32_t count = 0; ///< a leaf's instances; 0 for an inner node
    };
    /// Halves 2^32 instances 32 times; each level leaves one node open.
    static constexpr std::size_t kMostDepth = 64;

    static bool isMet(const Node& node, const glm::dvec3& origin, const glm::dvec3& inverse, double first,
                      double last);
    void build(const scene::Instances& instances, std::uint32_t node, std::uint32_t begin, std::uint32_t end);

    std::vector<Node> m_nodes;
    std::vector<std::uint32_t> m_order; ///< instances in the order of the leaves
};

} // namespace cdr::measure
