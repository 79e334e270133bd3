#include "mikktspace_tangents.h"

#include "../mikktspace/module.h"
#include "tangents.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <tuple>
#include <vector>

namespace cdr::scene::gltf {

namespace {

constexpr std::uint32_t kNoVariant = std::numeric_limits<std::uint32_t>::max();

/// Bytes for each corner of the tables here.
constexpr std::uint64_t kCornerTableBytes = 64;

/// MikkTSpace compares triangles that meet at a vertex with each other. Usually six do.
constexpr std::uint64_t kMeetingsPerCorner = 64;
/// For meshes that are small: about a disc of a thousand triangles.
constexpr std::uint64_t kFewMeetings = 1u << 20u;

TangentCorner cornerOf(const SourceMesh& mesh, std::uint32_t vertex, UvPlaces::Tangents along) {
    const Vertex& source = mesh.vertices[vertex];
    return {source.position, source.normal,
            along == UvPlaces::Tangents::second ? mesh.details[vertex].uv : source.uv};
}

/// The places in the index list of those corners whose triangles have no two corners at one position.
std::vector<std::uint32_t> drawnCorners(const SourceMesh& mesh) {
    std::vector<std::uint32_t> corners;
    corners.reserve(mesh.indices.size());
    const auto position = [&](std::size_t i) { return mesh.vertices[mesh.indices[i]].position; };
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        if (position(i) != position(i + 1) && position(i + 1) != position(i + 2) &&
            position(i + 2) != position(i)) {
            for (std::size_t c = 0; c < 3; ++c) {
                corners.push_back(static_cast<std::uint32_t>(i + c));
            }
        }
    }
    return corners;
}

/// Over all vertices, the square of how many corners are there. Vertices that are equal are one.
std::uint64_t meetingsOf(const SourceMesh& mesh, const std::vector<std::uint32_t>& corners,
                         UvPlaces::Tangents along) {
    std::vector<std::uint32_t> uses(mesh.vertices.size(), 0);
    for (const std::uint32_t corner : corners) {
        ++uses[mesh.indices[corner]];
    }
    std::vector<std::uint32_t> order(mesh.vertices.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto key = [&](std::uint32_t vertex) {
        const TangentCorner c = cornerOf(mesh, vertex, along);
        return std::tuple(c.position.x, c.position.y, c.position.z, c.normal.x, c.normal.y, c.normal.z,
                          c.uv.x, c.uv.y);
    };
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    std::uint64_t meetings = 0;
    std::uint64_t here = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        here += uses[order[i]];
        if (i + 1 == order.size() || key(order[i]) != key(order[i + 1])) {
            meetings += here * here;
            here = 0;
        }
    }
    return meetings;
}

/// What a vertex is in some of its corners.
struct Variant {
    glm::vec4 tangent;
    std::uint32_t vertex; ///< of the mesh, before
    std::uint32_t next;   ///< of the same vertex, or kNoVariant
};

/// The vertices that a mesh gets.
class Variants {
  public:
    explicit Variants(std::size_t vertices) : m_first(vertices, kNoVariant) {}

    /// The variant of a vertex with a tangent.
    std::uint32_t find(std::uint32_t vertex, const glm::vec4& tangent) {
        std::uint32_t last = kNoVariant;
        for (std::uint32_t i = m_first[vertex]; i != kNoVariant; i = m_all[i].next) {
            if (m_all[i].tangent == tangent) {
                return i;
            }
            last = i;
        }
        const auto added = static_cast<std::uint32_t>(m_all.size());
        (last == kNoVariant ? m_first[vertex] : m_all[last].next) = added;
        m_all.push_back({tangent, vertex, kNoVariant});
        m_further += last == kNoVariant ? 0 : 1;
        return added;
    }

    /// Those that need a vertex of their own.
    std::size_t further() const { return m_further; }

    /// Makes them vertices, and returns the place of each.
    std::vector<std::uint32_t> place(SourceMesh& mesh) const {
        std::vector<std::uint32_t> places(m_all.size());
        for (std::uint32_t i = 0; i < m_all.size(); ++i) {
            places[i] = m_all[i].vertex;
            if (m_first[places[i]] != i) {
                places[i] = static_cast<std::uint32_t>(mesh.vertices.size());
                mesh.vertices.push_back(Vertex(mesh.vertices[m_all[i].vertex]));
                mesh.details.push_back(VertexDetail(mesh.details[m_all[i].vertex]));
            }
            mesh.details[places[i]].tangent = m_all[i].tangent;
        }
        for (std::size_t vertex = 0; vertex < m_first.size(); ++vertex) {
            if (m_first[vertex] == kNoVariant) { // in triangles without extent
                mesh.details[vertex].tangent = glm::vec4(anyTangent(mesh.vertices[vertex].normal), 1.0f);
            }
        }
        return places;
    }

  private:
    std::vector<std::uint32_t> m_first; ///< by vertex of the mesh: its first one
    std::vector<Variant> m_all;
    std::size_t m_further = 0;
};

/// A tangent that can be used: MikkTSpace gives any where a texture is flattened.
glm::vec4 usable(const glm::vec4& tangent, const glm::vec3& normal) {
    const glm::vec3 direction(tangent);
    const bool isUsable =
        std::abs(glm::length(direction) - 1.0f) < 1e-3f && glm::length(glm::cross(normal, direction)) > 1e-3f;
    return {isUsable ? direction : anyTangent(normal), tangent.w < 0.0f ? -1.0f : 1.0f};
}

} // namespace

std::optional<std::string> deriveMikkTSpaceTangents(SourceMesh& mesh, UvPlaces::Tangents along,
                                                    std::uint64_t bytes) {
    const std::uint64_t tables = kCornerTableBytes * mesh.indices.size();
    if (!hasMikkTSpace()) {
        return "cdr was built without MikkTSpace";
    }
    if (tables > bytes) {
        return "MikkTSpace would take too much memory";
    }
    const std::vector<std::uint32_t> corners = drawnCorners(mesh);
    if (meetingsOf(mesh, corners, along) > kFewMeetings + kMeetingsPerCorner * corners.size()) {
        return "too many triangles meet at a point for MikkTSpace";
    }
    const auto cornerAt = [&](std::size_t i) { return cornerOf(mesh, mesh.indices[corners[i]], along); };
    const base::Result<std::vector<glm::vec4>> tangents =
        mikkTSpace(corners.size(), cornerAt, {.bytes = bytes - tables});
    if (!tangents) {
        return tangents.refusal().message;
    }
    Variants variants(mesh.vertices.size());
    std::vector<std::uint32_t> variantOf(corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const std::uint32_t vertex = mesh.indices[corners[i]];
        variantOf[i] = variants.find(vertex, usable((*tangents)[i], mesh.vertices[vertex].normal));
    }
    if (variants.further() > mesh.vertices.size()) {
        return "MikkTSpace would make more than two vertices of one";
    }
    const std::vector<std::uint32_t> places = variants.place(mesh);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        mesh.indices[corners[i]] = places[variantOf[i]];
    }
    return std::nullopt;
}

} // namespace cdr::scene::gltf
