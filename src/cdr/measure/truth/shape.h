#pragma once

#include <cdr/measure/truth/box_hit.h>
#include <cdr/measure/truth/object_ray.h>
#include <cdr/measure/truth/triangle_bvh.h>
#include <cdr/scene/mesh.h>

#include <glm/glm.hpp>

#include <optional>

namespace cdr::measure {

/// A mesh made ready to be hit by rays: slabs where it says it is a box, else its triangles.
class Shape {
  public:
    /// base::InputError as TriangleBvh.
    explicit Shape(const scene::Mesh& mesh);

    /// The nearest visible hit as a view distance; kNoHit when there is none within `range`.
    double nearest(const ObjectRay& ray, Sidedness sides, const ViewRange& range) const {
        return m_triangles ? m_triangles->nearest(ray, sides, range)
                           : nearestOnBox(ray, m_halfSides, sides, range);
    }

    /// None where the mesh says that it is a box.
    const TriangleBvh* triangles() const { return m_triangles ? &*m_triangles : nullptr; }

    /// The enclosing box in object space. A mesh without triangles has a point.
    const glm::dvec3& centre() const { return m_centre; }
    const glm::dvec3& halfSides() const { return m_halfSides; }

  private:
    glm::dvec3 m_centre{0.0};
    glm::dvec3 m_halfSides{0.0};
    std::optional<TriangleBvh> m_triangles; ///< none: exactly the enclosing box
};

} // namespace cdr::measure
