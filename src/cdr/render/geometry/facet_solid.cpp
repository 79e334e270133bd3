#include <cdr/render/geometry/facet_solid.h>
#include <cdr/render/geometry/facet_vertices.h>

#include <algorithm>
#include <limits>

namespace cdr::render {

namespace {

/// How far, of a mesh's radius, a corner may lie off its facet's plane: roundings of float32 positions.
constexpr double kFlatness = 1e-6;
/// Least cosine between a facet's normal and that of its triangles.
constexpr double kMinCosine = 0.9999;

/// Twice the area, as a vector.
glm::dvec3 areaOf(const scene::Mesh& mesh, std::span<const std::uint32_t, 3> triangle) {
    const glm::dvec3 first(mesh.vertices[triangle[0]].position);
    return glm::cross(glm::dvec3(mesh.vertices[triangle[1]].position) - first,
                      glm::dvec3(mesh.vertices[triangle[2]].position) - first);
}

} // namespace

std::optional<FacetSolid> FacetSolid::of(const scene::Mesh& mesh, std::span<const std::uint32_t> indices) {
    FacetSolid solid;
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        if (!solid.addTriangle(mesh, indices.subspan(i).first<3>())) {
            return std::nullopt;
        }
    }
    if (solid.isMasked()) {
        for (std::uint64_t mask = 0; mask < std::uint64_t{1} << solid.m_facets.size(); ++mask) {
            solid.m_patterns.push_back(solid.makePattern(mask));
        }
    } else {
        solid.m_patterns.push_back(solid.makePattern(std::numeric_limits<std::uint64_t>::max()));
    }
    return solid;
}

double FacetSolid::heightOver(const Facet& facet, const glm::vec3& position) const {
    return glm::dot(glm::dvec3(facet.normal), glm::dvec3(position) - glm::dvec3(m_corners[facet.corner]));
}

bool FacetSolid::addTriangle(const scene::Mesh& mesh, std::span<const std::uint32_t, 3> triangle) {
    const glm::dvec3 area = areaOf(mesh, triangle);
    const double size = glm::length(area);
    const scene::Vertex& first = mesh.vertices[triangle[0]];
    if (size == 0.0) {
        return true; // covers no pixel
    }
    if (!(glm::dot(area, glm::dvec3(first.normal)) >= kMinCosine * size)) {
        return false;
    }
    const double tolerance = kFlatness * static_cast<double>(mesh.boundingRadius);
    const std::optional<std::uint8_t> index = facetOf(first, tolerance);
    if (!index) {
        return false;
    }
    Facet& facet = m_facets[*index];
    Triangle added{.corners = {}, .facet = *index};
    for (std::size_t i = 0; i < 3; ++i) {
        const scene::Vertex& vertex = mesh.vertices[triangle[i]];
        const std::optional<std::uint8_t> corner = cornerAt(vertex.position);
        if (!corner || std::abs(heightOver(facet, vertex.position)) > tolerance ||
            vertex.normal != first.normal || vertex.color != first.color) {
            return false;
        }
        added.corners[i] = *corner;
        facet.extent = std::max(facet.extent, glm::distance(m_corners[facet.corner], vertex.position));
    }
    m_triangles.push_back(added);
    return true;
}

std::optional<std::uint8_t> FacetSolid::cornerAt(const glm::vec3& position) {
    const auto found = std::find(m_corners.begin(), m_corners.end(), position);
    const auto corner = static_cast<std::uint8_t>(found - m_corners.begin());
    if (found == m_corners.end()) {
        if (m_corners.size() == kMaxSolidParts) {
            return std::nullopt;
        }
        m_corners.push_back(position);
    }
    return corner;
}

std::optional<std::uint8_t> FacetSolid::facetOf(const scene::Vertex& vertex, double tolerance) {
    const auto found = std::find_if(m_facets.begin(), m_facets.end(), [&](const Facet& facet) {
        return facet.normal == vertex.normal && facet.color == vertex.color &&
               std::abs(heightOver(facet, vertex.position)) <= tolerance;
    });
    const auto index = static_cast<std::uint8_t>(found - m_facets.begin());
    if (found == m_facets.end()) {
        const std::optional<std::uint8_t> corner = cornerAt(vertex.position);
        if (!corner || m_facets.size() == kMaxSolidParts) {
            return std::nullopt;
        }
        m_facets.push_back({.normal = vertex.normal, .color = vertex.color, .corner = *corner});
    }
    return index;
}

FacetPattern FacetSolid::makePattern(std::uint64_t facets) const {
    FacetPattern pattern;
    scene::Mesh mesh; // its colours are the facets of the pattern, so that each keeps vertices of its own
    for (std::size_t facet = 0; facet < m_facets.size(); ++facet) {
        if ((facets >> facet & 1) == 0) {
            continue;
        }
        const auto listed = static_cast<std::uint8_t>(pattern.facets.size());
        pattern.facets.push_back(static_cast<std::uint8_t>(facet));
        for (const Triangle& triangle : m_triangles) {
            for (const std::uint8_t corner : triangle.corners) {
                if (triangle.facet == facet) {
                    mesh.indices.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
                    mesh.vertices.push_back({.position = m_corners[corner], .color = glm::u8vec4(listed)});
                }
            }
        }
    }
    const scene::Mesh shared = shareFacetVertices(mesh);
    for (const scene::Vertex& vertex : shared.vertices) {
        const auto corner = std::find(m_corners.begin(), m_corners.end(), vertex.position);
        pattern.vertices.push_back({static_cast<std::uint8_t>(corner - m_corners.begin()), vertex.color.x});
    }
    pattern.indices.assign(shared.indices.begin(), shared.indices.end());
    return pattern;
}

} // namespace cdr::render
