#pragma once

#include <cdr/scene/box_tree.h>
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
        const std::span<const scene::BoxTree::Node> nodes = m_tree.nodes();
        std::array<std::uint32_t, scene::BoxTree::kMaxDepth + 2> open; // each level leaves one node open
        std::size_t count = 0;
        if (!nodes.empty()) {
            open[count++] = 0;
        }
        const glm::dvec3 inverse = 1.0 / direction;
        while (count > 0 && last >= first) {
            const scene::BoxTree::Node& node = nodes[open[--count]];
            if (!isMet(node.box, origin, inverse, first, last)) {
                continue;
            }
            if (node.count == 0) {
                open[count++] = node.first;
                open[count++] = node.first + 1;
                continue;
            }
            for (std::uint32_t i = node.first; i < node.first + node.count && last >= first; ++i) {
                last = meet(m_instances[m_tree.order()[i]]);
            }
        }
    }

  private:
    static std::vector<scene::Box> boxesOf(const scene::Instances& instances,
                                           std::span<const std::uint32_t> some);
    static bool isMet(const scene::Box& box, const glm::dvec3& origin, const glm::dvec3& inverse,
                      double first, double last);

    std::vector<std::uint32_t> m_instances; ///< the tree's items
    scene::BoxTree m_tree;
};

} // namespace cdr::measure
