#include "reference_caster.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace cdr::test {

namespace {

using Real = long double;
using Vector = ReferenceCaster::Vector;

Vector vector(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}
Vector operator+(const Vector& a, const Vector& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
Vector operator-(const Vector& a, const Vector& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Vector operator*(Real s, const Vector& v) {
    return {s * v.x, s * v.y, s * v.z};
}
Real dot(const Vector& a, const Vector& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
Vector cross(const Vector& a, const Vector& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

Vector toWorld(const glm::mat3& basis, const glm::vec3& v) {
    return static_cast<Real>(v.x) * vector(glm::dvec3(basis[0])) +
           static_cast<Real>(v.y) * vector(glm::dvec3(basis[1])) +
           static_cast<Real>(v.z) * vector(glm::dvec3(basis[2]));
}

} // namespace

ReferenceCaster::ReferenceCaster(const scene::Scene& scene, const scene::Camera& camera, std::uint32_t width,
                                 std::uint32_t height)
    : m_camera(camera),
      m_width(width),
      m_height(height) {
    const scene::Instances& instances = scene.instances;
    for (std::size_t i = 0; i < instances.size(); ++i) {
        const scene::Mesh& mesh = scene.meshes[instances.mesh[i]];
        const glm::mat3& basis = instances.basis[i];
        const Vector offset = vector(instances.position(i)) - vector(camera.position);
        const bool mirrors = glm::determinant(glm::dmat3(basis)) < 0.0;
        for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
            const auto corner = [&](std::size_t k) {
                return offset + toWorld(basis, mesh.vertices[mesh.indices[t + k]].position);
            };
            // Mirroring turns the winding round in world space; the front stays the object's outside.
            const Vector a = corner(0);
            const Vector b = corner(mirrors ? 2 : 1);
            const Vector c = corner(mirrors ? 1 : 2);
            const Vector normal = cross(b - a, c - a);
            m_triangles.push_back({{a, b, c},
                                   normal,
                                   {cross(normal, b - a), cross(normal, c - b), cross(normal, a - c)},
                                   instances.object[i] + 1,
                                   scene.materials[instances.material[i]].doubleSided});
        }
    }
}

bool ReferenceCaster::WorldTriangle::holds(const Vector& point) const {
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (dot(point - corners[i], inward[i]) < 0) {
            return false;
        }
    }
    return true;
}

std::vector<ReferenceHit> ReferenceCaster::hits(std::uint32_t x, std::uint32_t y) const {
    const Real halfHeight = std::tan(static_cast<Real>(m_camera.fovY) / 2);
    const Real ndcX = (static_cast<Real>(x) + 0.5L) / m_width * 2 - 1;
    const Real ndcY = 1 - (static_cast<Real>(y) + 0.5L) / m_height * 2;
    const Real aspect = static_cast<Real>(m_width) / m_height;
    const Vector ray = Real{-1} * vector(m_camera.back) +
                       ndcX * aspect * halfHeight * vector(m_camera.right) +
                       ndcY * halfHeight * vector(m_camera.up);
    std::map<std::uint32_t, Real> nearest;
    for (const WorldTriangle& triangle : m_triangles) {
        const Real facing = dot(ray, triangle.normal);
        if (facing == 0 || (facing > 0 && !triangle.doubleSided)) {
            continue;
        }
        const Real distance = dot(triangle.corners[0], triangle.normal) / facing;
        if (distance >= m_camera.nearView && distance <= m_camera.farView && triangle.holds(distance * ray)) {
            const auto [entry, isNew] = nearest.try_emplace(triangle.id, distance);
            entry->second = std::min(entry->second, distance);
        }
    }
    std::vector<ReferenceHit> hits;
    for (const auto& [id, distance] : nearest) {
        hits.push_back({id, distance});
    }
    std::ranges::stable_sort(hits, {}, &ReferenceHit::distanceView);
    return hits;
}

} // namespace cdr::test
