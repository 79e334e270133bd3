#include "morphed_tangents.h"

#include "../materials/tangents.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace cdr::scene::gltf {

namespace {

glm::dvec3 acrossNormal(const glm::dvec3& v, const glm::dvec3& normal) {
    return v - normal * glm::dot(normal, v);
}

/// How vertices that share a tangent lie in the texture: sums over their corners, by angle.
struct TangentSum {
    glm::dvec3 direction{0.0}; ///< of unit tangents
    double stretch = 0.0;      ///< of lengths, scene units per unit of u
    double weight = 0.0;       ///< of angles

    /// The tangent, as long as one unit of u; nothing where the texture is flattened.
    std::optional<glm::dvec3> tangent() const {
        const double length = glm::length(direction);
        if (!(length > 1e-12) || !std::isfinite(length) || !std::isfinite(stretch)) {
            return std::nullopt;
        }
        return direction * (stretch / weight / length);
    }
};

/// A mesh as MikkTSpace sees it, with the vertices that it was split into at rest.
class TangentMesh {
  public:
    TangentMesh(const Deformer& deformer, std::span<const std::uint32_t> indices, UvPlaces::Tangents along)
        : m_deformer(deformer),
          m_indices(indices),
          m_along(along),
          m_group(deformer.vertices.size()) {
        findGroups();
    }

    /// Vertices that are equal at rest have one, and one tangent.
    std::uint32_t groupOf(std::size_t vertex) const { return m_group[vertex]; }

    /// By group, complete where wanted. @param vertices of the mesh, deformed or not.
    std::vector<TangentSum> sums(std::span<const Vertex> vertices, const std::vector<bool>& isWanted) const {
        std::vector<TangentSum> sums(m_group.size());
        for (std::size_t i = 0; i + 2 < m_indices.size(); i += 3) {
            const auto corners = m_indices.subspan(i, 3);
            if (std::ranges::any_of(corners, [&](std::uint32_t v) { return isWanted[m_group[v]]; })) {
                addTriangle(i, vertices, sums);
            }
        }
        return sums;
    }

    /// By group, whether a triangle at it has a vertex that a target moves.
    std::vector<bool> touchedBy(const std::vector<MorphDelta>& deltas) const {
        std::vector<bool> isMoved(m_group.size(), false);
        for (const MorphDelta& delta : deltas) {
            isMoved[delta.vertex] = true;
        }
        std::vector<bool> isTouched(m_group.size(), false);
        for (std::size_t i = 0; i + 2 < m_indices.size(); i += 3) {
            const auto corners = m_indices.subspan(i, 3);
            if (std::any_of(corners.begin(), corners.end(), [&](std::uint32_t v) { return isMoved[v]; })) {
                for (const std::uint32_t vertex : corners) {
                    isTouched[m_group[vertex]] = true;
                }
            }
        }
        return isTouched;
    }

  private:
    glm::dvec2 uv(std::uint32_t vertex) const {
        return glm::dvec2(m_along == UvPlaces::Tangents::second ? m_deformer.details[vertex].uv
                                                                : m_deformer.vertices[vertex].uv);
    }

    void findGroups() {
        const auto key = [&](std::uint32_t i) {
            const Vertex& v = m_deformer.vertices[i];
            const glm::vec4& t = m_deformer.details[i].tangent;
            const glm::dvec2 place = uv(i);
            return std::tuple(v.position.x, v.position.y, v.position.z, v.normal.x, v.normal.y, v.normal.z,
                              place.x, place.y, t.x, t.y, t.z, t.w);
        };
        std::vector<std::uint32_t> order(m_group.size());
        std::iota(order.begin(), order.end(), 0u);
        std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
        for (std::size_t i = 0; i < order.size(); ++i) {
            const bool isFirst = i == 0 || key(order[i - 1]) != key(order[i]);
            m_group[order[i]] = isFirst ? order[i] : m_group[order[i - 1]];
        }
    }

    void addTriangle(std::size_t first, std::span<const Vertex> vertices,
                     std::vector<TangentSum>& sums) const {
        const auto corner = [&](std::size_t c) { return m_indices[first + c % 3]; };
        const auto edge = [&](std::size_t from, std::size_t to) {
            return glm::dvec3(vertices[corner(to)].position) - glm::dvec3(vertices[corner(from)].position);
        };
        const glm::dvec2 step1 = uv(corner(1)) - uv(corner(0));
        const glm::dvec2 step2 = uv(corner(2)) - uv(corner(0));
        const double area = step1.x * step2.y - step2.x * step1.y;
        if (area == 0.0) {
            return;
        }
        const glm::dvec3 perU = (edge(0, 1) * step2.y - edge(0, 2) * step1.y) / area;
        for (std::size_t c = 0; c < 3; ++c) {
            const glm::dvec3 normal(vertices[corner(c)].normal);
            const glm::dvec3 tangent = acrossNormal(perU, normal);
            const double length = glm::length(tangent);
            const double angle =
                angleBetween(acrossNormal(edge(c, c + 1), normal), acrossNormal(edge(c, c + 2), normal));
            if (length > 0.0 && angle > 0.0) {
                TangentSum& sum = sums[m_group[corner(c)]];
                sum.direction += angle / length * tangent;
                sum.stretch += angle * length;
                sum.weight += angle;
            }
        }
    }

    const Deformer& m_deformer;
    std::span<const std::uint32_t> m_indices;
    UvPlaces::Tangents m_along;
    std::vector<std::uint32_t> m_group; ///< by vertex: the first that is equal
};

/// The mesh with one target in full.
std::vector<Vertex> inFull(const Deformer& deformer, const std::vector<MorphDelta>& deltas) {
    std::vector<Vertex> vertices = deformer.vertices;
    for (const MorphDelta& delta : deltas) {
        Vertex& vertex = vertices[delta.vertex];
        vertex.position += delta.position;
        const glm::dvec3 normal = glm::dvec3(vertex.normal) + glm::dvec3(delta.normal);
        const double length = glm::length(normal);
        vertex.normal = length > 0.0 ? glm::vec3(normal / length) : vertex.normal;
    }
    setFlatNormals(deformer, vertices);
    return vertices;
}

} // namespace

void addTangentDeltas(Deformer& deformer, std::span<const std::uint32_t> indices, UvPlaces::Tangents along) {
    const TangentMesh mesh(deformer, indices, along);
    const std::vector<TangentSum> atRest =
        mesh.sums(deformer.vertices, std::vector<bool>(deformer.vertices.size(), true));
    for (std::vector<MorphDelta>& target : deformer.targets) {
        const std::vector<bool> isTouched = mesh.touchedBy(target);
        const std::vector<TangentSum> moved = mesh.sums(inFull(deformer, target), isTouched);
        std::vector<MorphDelta> deltas;
        auto next = target.begin();
        for (std::uint32_t i = 0; i < deformer.vertices.size(); ++i) {
            const bool isMoved = next != target.end() && next->vertex == i;
            MorphDelta delta = isMoved ? *next++ : MorphDelta{.vertex = i};
            const std::uint32_t group = mesh.groupOf(i);
            const auto before = atRest[group].tangent();
            const auto after = moved[group].tangent();
            if (isTouched[group] && before && after) {
                const glm::dvec3 tangent(deformer.details[i].tangent);
                delta.tangent = glm::vec3(*after / glm::length(*before) - tangent);
            }
            if (isMoved || delta.tangent != glm::vec3(0.0f)) {
                deltas.push_back(delta);
            }
        }
        target = std::move(deltas);
    }
}

} // namespace cdr::scene::gltf
