#include "tangents.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace cdr::scene::gltf {

namespace {

constexpr std::uint32_t kNoTwin = std::numeric_limits<std::uint32_t>::max();

/// How a triangle lies in its texture.
struct TextureFrame {
    glm::dvec3 tangent{0.0}; ///< where u grows; zero where the texture is flattened
    bool isMirrored = false; ///< seen from the front, the texture is a mirror image
};

TextureFrame frameOf(const std::array<glm::dvec3, 3>& positions, const std::array<glm::dvec2, 3>& uv) {
    const glm::dvec3 edge1 = positions[1] - positions[0];
    const glm::dvec3 edge2 = positions[2] - positions[0];
    const glm::dvec2 step1 = uv[1] - uv[0];
    const glm::dvec2 step2 = uv[2] - uv[0];
    const double area = step1.x * step2.y - step2.x * step1.y;
    const glm::dvec3 tangent = (edge1 * step2.y - edge2 * step1.y) * (area < 0.0 ? -1.0 : 1.0);
    const double length = glm::length(tangent);
    if (area == 0.0 || !(length > 0.0) || !std::isfinite(length)) {
        return {};
    }
    // v points down a texture: of one that is not mirrored u, v and the front's normal are left-handed.
    return {.tangent = tangent / length, .isMirrored = area > 0.0};
}

/// The vertices of a mesh by the sense in which their triangles run through the texture.
class Senses {
  public:
    explicit Senses(SourceMesh& mesh)
        : m_mesh(mesh),
          m_sense(mesh.vertices.size(), 0),
          m_twin(mesh.vertices.size(), kNoTwin),
          m_sum(mesh.vertices.size(), glm::dvec3(0.0)) {}

    /// The vertex to use for a corner: the one there, or its twin of the other sense.
    std::uint32_t vertexFor(std::uint32_t vertex, bool isMirrored) {
        const int sense = isMirrored ? -1 : 1;
        if (m_sense[vertex] == 0) {
            m_sense[vertex] = sense;
        }
        if (m_sense[vertex] == sense) {
            return vertex;
        }
        if (m_twin[vertex] == kNoTwin) {
            m_twin[vertex] = static_cast<std::uint32_t>(m_mesh.vertices.size());
            m_mesh.vertices.push_back(Vertex(m_mesh.vertices[vertex]));
            m_mesh.details.push_back(VertexDetail(m_mesh.details[vertex]));
            m_sense.push_back(sense);
            m_twin.push_back(vertex);
            m_sum.emplace_back(0.0);
        }
        return m_twin[vertex];
    }

    void add(std::uint32_t vertex, const glm::dvec3& tangent) { m_sum[vertex] += tangent; }

    void finish() const {
        for (std::size_t i = 0; i < m_sum.size(); ++i) {
            const glm::dvec3 normal(m_mesh.vertices[i].normal);
            const glm::dvec3 inPlane = m_sum[i] - normal * glm::dot(normal, m_sum[i]);
            const double length = glm::length(inPlane);
            const glm::vec3 tangent =
                length > 1e-12 ? glm::vec3(inPlane / length) : anyTangent(m_mesh.vertices[i].normal);
            m_mesh.details[i].tangent = glm::vec4(tangent, m_sense[i] < 0 ? -1.0f : 1.0f);
        }
    }

  private:
    SourceMesh& m_mesh;
    std::vector<int> m_sense; ///< by vertex: 1, -1 mirrored, 0 not known yet
    std::vector<std::uint32_t> m_twin;
    std::vector<glm::dvec3> m_sum; ///< by vertex: of tangents
};

} // namespace

double angleBetween(const glm::dvec3& a, const glm::dvec3& b) {
    const double lengths = glm::length(a) * glm::length(b);
    return lengths > 0.0 ? std::acos(std::clamp(glm::dot(a, b) / lengths, -1.0, 1.0)) : 0.0;
}

glm::vec3 anyTangent(const glm::vec3& normal) {
    const glm::vec3 axis =
        std::abs(normal.x) < 0.5f ? glm::vec3(1.0f, 0.0f, 0.0f) : glm::vec3(0.0f, 1.0f, 0.0f);
    return glm::normalize(axis - normal * glm::dot(axis, normal));
}

void deriveTangents(SourceMesh& mesh, UvPlaces::Tangents along) {
    Senses senses(mesh);
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        std::array<glm::dvec3, 3> positions;
        std::array<glm::dvec2, 3> uv;
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint32_t vertex = mesh.indices[i + c];
            positions[c] = glm::dvec3(mesh.vertices[vertex].position);
            uv[c] = glm::dvec2(along == UvPlaces::Tangents::second ? mesh.details[vertex].uv
                                                                   : mesh.vertices[vertex].uv);
        }
        const TextureFrame frame = frameOf(positions, uv);
        if (frame.tangent == glm::dvec3(0.0)) {
            continue;
        }
        for (std::size_t c = 0; c < 3; ++c) {
            std::uint32_t& vertex = mesh.indices[i + c];
            vertex = senses.vertexFor(vertex, frame.isMirrored);
            const double angle =
                angleBetween(positions[(c + 1) % 3] - positions[c], positions[(c + 2) % 3] - positions[c]);
            senses.add(vertex, frame.tangent * angle);
        }
    }
    senses.finish();
}

} // namespace cdr::scene::gltf
