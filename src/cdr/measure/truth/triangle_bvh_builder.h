#pragma once

#include <cdr/measure/truth/triangle_bvh.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace cdr::measure {

/// Splits triangles top-down where the surface area heuristic, sampled in bins (Wald 2007), is least.
class TriangleBvh::Builder {
  public:
    /// @param pad object space, by how much every box is enlarged: it covers the rounding of ray against
    /// triangle.
    Builder(const std::vector<Triangle>& triangles, float pad);

    std::vector<Node> nodes;
    std::vector<std::uint32_t> order; ///< triangles in the order of the leaves

    /// Deepest leaf, the root being 0: past kMedianDepth splits halve, and 2^32 triangles halve 32 times.
    static constexpr std::size_t kMaxDepth = 72;

  private:
    struct Task {
        std::uint32_t node;
        std::uint32_t begin;
        std::uint32_t end;
        std::uint32_t depth;
    };
    static constexpr std::uint32_t kMedianDepth = 40;
    static constexpr std::uint32_t kLeafTriangles = 3;
    static constexpr std::size_t kBins = 16;

    void buildNode(const Task& task, std::vector<Task>& open);
    std::uint32_t split(const Task& task);
    std::uint32_t splitAtMedian(const Task& task, int axis);

    std::vector<Bounds> m_bounds;
    std::vector<glm::vec3> m_centres;
    float m_pad;
};

} // namespace cdr::measure
