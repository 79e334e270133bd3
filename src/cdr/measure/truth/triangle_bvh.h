#pragma once

#include <cdr/measure/truth/object_ray.h>
#include <cdr/measure/truth/triangle_hit.h>
#include <cdr/scene/mesh.h>

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

namespace cdr::measure {

/// An axis-aligned box in object space. Starts empty.
struct Bounds {
    glm::vec3 lower{std::numeric_limits<float>::infinity()};
    glm::vec3 upper{-std::numeric_limits<float>::infinity()};

    void add(const glm::vec3& p) {
        lower = glm::min(lower, p);
        upper = glm::max(upper, p);
    }
    void add(const Bounds& other) {
        lower = glm::min(lower, other.lower);
        upper = glm::max(upper, other.upper);
    }
};

/// A mesh's triangles in a tree of boxes, for casting many rays at them. Immutable, so threads may share it.
class TriangleBvh {
  public:
    /// base::InputError, naming the mesh, when an index is out of range or a vertex is not finite.
    explicit TriangleBvh(const scene::Mesh& mesh);

    /// The nearest visible hit as a view distance; kNoHit when there is none within `range`. Watertight: a
    /// ray through an edge or corner that triangles share hits at least one of them.
    double nearest(const ObjectRay& ray, Sidedness sides, const ViewRange& range) const;

    /// Whether a hit counts.
    /// @param triangle the first of its three indices in the mesh. @param hitView its view distance.
    using Keeps = std::function<bool(std::uint32_t triangle, double hitView)>;
    /// The nearest hit that counts. Asks of each that is nearer than all that counted before.
    double nearest(const ObjectRay& ray, Sidedness sides, const ViewRange& range, const Keeps& keeps) const;

    /// Encloses every triangle; empty for a mesh without any.
    const Bounds& bounds() const { return m_bounds; }

  private:
    struct Node {
        std::array<glm::vec3, 2> corners; ///< lower and upper, padded
        std::uint32_t
            first; ///< a leaf's first triangle, else the first of two children that follow each other
        std::uint32_t count; ///< a leaf's triangles; 0 for an inner node
    };
    class Builder;
    class Walk;

    template <typename IsKept>
    double nearestOf(const ObjectRay& ray, Sidedness sides, const ViewRange& range,
                     const IsKept& isKept) const;

    Bounds m_bounds;
    glm::dvec3 m_centre{0.0};
    std::vector<Node> m_nodes;
    std::vector<Triangle> m_triangles;   ///< in the order of the leaves
    std::vector<std::uint32_t> m_places; ///< of each, the first of its indices in the mesh
};

} // namespace cdr::measure
