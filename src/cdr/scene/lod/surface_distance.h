#pragma once

#include <cdr/scene/box_tree.h>

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace cdr::scene {

/// How far points lie from a triangle mesh, in float64: a tree of boxes over the triangles.
class SurfaceDistance {
  public:
    /// @param indices three per triangle, at least one triangle, each below positions.size().
    SurfaceDistance(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices);

    /// What is nearest to a point.
    struct Nearest {
        double squared = std::numeric_limits<double>::infinity(); ///< distance
        std::uint32_t triangle = 0;                               ///< in the order of the indices
    };
    Nearest nearestTo(const glm::dvec3& point) const;

    /// The larger of `known` and the squared distance. Mostly the search ends early: any triangle within `known` decides it.
    double largerSquared(const glm::dvec3& point, double known) const;

    /// The largest of `known` and of points spread evenly over a triangle, corners and edges among them.
    /// @param points about how many.
    double largestSquaredTo(const std::array<glm::dvec3, 3>& triangle, double points, double known) const;

  private:
    struct Triangle {
        glm::dvec3 a, b, c;
    };
    static std::vector<Triangle> trianglesOf(std::span<const glm::vec3> positions,
                                             std::span<const std::uint32_t> indices);
    static std::vector<Box> boxesOf(std::span<const Triangle> triangles);
    /// Ends as soon as a triangle is found whose squared distance is `enough` or less.
    void search(std::uint32_t node, const glm::dvec3& point, double enough, Nearest& best) const;

    std::vector<Triangle> m_triangles;
    BoxTree m_tree;
};

/// Hausdorff distance of two surfaces over the same vertices, sampled. The vertices that `full` uses are held
/// against `coarse`. Points spread over each triangle of `coarse`, about as many as `full` has triangles, are
/// held against `full`. Both need a triangle.
double surfaceDeviation(std::span<const glm::vec3> positions, std::span<const std::uint32_t> full,
                        std::span<const std::uint32_t> coarse);

} // namespace cdr::scene
