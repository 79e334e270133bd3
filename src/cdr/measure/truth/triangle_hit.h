#pragma once

#include <cdr/measure/truth/object_ray.h>
#include <cdr/scene/mesh.h>

#include <glm/glm.hpp>

#include <array>
#include <cmath>
#include <utility>

namespace cdr::measure {

/// A triangle's corners in object space, counter-clockwise seen from its front.
using Triangle = std::array<glm::vec3, 3>;

/// @param first of the triangle's indices.
inline Triangle triangleOf(const scene::Mesh& mesh, std::size_t first) {
    return {mesh.vertices[mesh.indices[first]].position, mesh.vertices[mesh.indices[first + 1]].position,
            mesh.vertices[mesh.indices[first + 2]].position};
}

/// Intersects a ray with triangles, after Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection" (2013).
/// Space is sheared so that the ray is an axis, and three edge functions decide in 2D.
///
/// Two triangles that share an edge compute the same edge function with opposite signs, and the sign is exact.
/// 0 counts as a hit. So no ray passes between them.
class ShearedRay {
  public:
    explicit ShearedRay(const ObjectRay& ray) : m_origin(ray.origin) {
        const glm::dvec3 size = glm::abs(ray.direction);
        m_z = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
        m_x = (m_z + 1) % 3;
        m_y = (m_z + 2) % 3;
        // Exchanging the axes makes up for the mirroring by a negative scale, so fronts stay fronts.
        if (ray.direction[m_z] < 0.0) {
            std::swap(m_x, m_y);
        }
        m_shear = {ray.direction[m_x] / ray.direction[m_z], ray.direction[m_y] / ray.direction[m_z],
                   1.0 / ray.direction[m_z]};
    }

    /// The ray parameter of the hit, whatever its sign; kNoHit when the ray misses or meets a back that is
    /// not to be seen.
    double meet(const Triangle& triangle, Sidedness sides) const {
        const glm::dvec3 a = shear(triangle[0]);
        const glm::dvec3 b = shear(triangle[1]);
        const glm::dvec3 c = shear(triangle[2]);
        const double u = edge(c, b);
        const double v = edge(a, c);
        const double w = edge(b, a);
        const bool front = u >= 0.0 && v >= 0.0 && w >= 0.0;
        const bool back = u <= 0.0 && v <= 0.0 && w <= 0.0;
        const double sum = u + v + w;
        if (!(front || (sides == Sidedness::both && back)) || sum == 0.0) {
            return kNoHit;
        }
        return (u * a.z + v * b.z + w * c.z) / sum;
    }

    /// The weights of the triangle's corners at a hit, their sum 1; one of 0 says that the ray meets an edge.
    glm::dvec3 weights(const Triangle& triangle) const {
        const glm::dvec3 a = shear(triangle[0]);
        const glm::dvec3 b = shear(triangle[1]);
        const glm::dvec3 c = shear(triangle[2]);
        const glm::dvec3 areas(edge(c, b), edge(a, c), edge(b, a));
        return areas / (areas.x + areas.y + areas.z);
    }

    /// Whether the ray, which meets the triangle, comes from its front.
    bool meetsFront(const Triangle& triangle) const { return meet(triangle, Sidedness::fronts) < kNoHit; }

  private:
    /// Twice the area of (ray, p, q), with the sign it has without rounding.
    static double edge(const glm::dvec3& p, const glm::dvec3& q) {
        const double a = p.x * q.y;
        const double b = p.y * q.x;
        // Rounded products never compare the wrong way round; where they are equal, what was rounded away
        // decides.
        return a != b ? a - b : std::fma(p.x, q.y, -a) - std::fma(p.y, q.x, -b);
    }

    glm::dvec3 shear(const glm::vec3& corner) const {
        const glm::dvec3 p = glm::dvec3(corner) - m_origin;
        return {p[m_x] - m_shear.x * p[m_z], p[m_y] - m_shear.y * p[m_z], m_shear.z * p[m_z]};
    }

    glm::dvec3 m_origin;
    glm::dvec3 m_shear;
    int m_x;
    int m_y;
    int m_z;
};

} // namespace cdr::measure
