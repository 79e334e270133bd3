#pragma once

#include <cdr/scene/mesh.h>

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace cdr::render {

/// A plane piece of a solid, in object space.
struct Facet {
    glm::vec3 normal{0.0f};  ///< unit length
    glm::u8vec4 color{255};  ///< linear, multiplies the material's base colour
    std::uint8_t corner = 0; ///< one of the facet's
    float extent = 0.0f;     ///< no corner of the facet lies farther from that one
};

/// What to write so that some facets of a solid are drawn.
struct FacetPattern {
    struct Vertex {
        std::uint8_t corner = 0; ///< of the solid
        std::uint8_t facet = 0;  ///< into `facets`: the one whose triangles start with this vertex
    };
    std::vector<Vertex> vertices;
    std::vector<std::uint16_t> indices; ///< three per triangle, the provoking vertex first
    std::vector<std::uint8_t> facets;   ///< of the solid
};

/// Most corners, and most facets, of a solid.
inline constexpr std::size_t kMaxSolidParts = 64;
/// A solid of at most so many facets has a pattern for each set of them.
inline constexpr std::size_t kMaxMaskedFacets = 8;

/// A small mesh of plane facets, each of one normal and colour. The CPU can transform it draw by draw, and it
/// can be shaded from a record per facet.
class FacetSolid {
  public:
    /// Empty where a mesh, at one of its levels, has too many parts. Also where the corners of a triangle
    /// differ in normal or colour, or normals are not those of the triangles.
    /// @param indices the mesh's own or a level's.
    static std::optional<FacetSolid> of(const scene::Mesh& mesh, std::span<const std::uint32_t> indices);

    std::span<const glm::vec3> corners() const { return m_corners; }
    std::span<const Facet> facets() const { return m_facets; }
    /// Whether pattern() leaves out facets.
    bool isMasked() const { return m_facets.size() <= kMaxMaskedFacets; }
    /// @param facets bit k is facet k; all are drawn unless isMasked().
    const FacetPattern& pattern(std::uint32_t facets) const {
        return isMasked() ? m_patterns[facets] : m_patterns.front();
    }
    /// The pattern of all facets, which is the largest.
    const FacetPattern& whole() const { return m_patterns.back(); }

  private:
    struct Triangle {
        std::uint8_t corners[3];
        std::uint8_t facet;
    };
    bool addTriangle(const scene::Mesh& mesh, std::span<const std::uint32_t, 3> triangle);
    std::optional<std::uint8_t> cornerAt(const glm::vec3& position);
    std::optional<std::uint8_t> facetOf(const scene::Vertex& vertex, double tolerance);
    double heightOver(const Facet& facet, const glm::vec3& position) const;
    FacetPattern makePattern(std::uint64_t facets) const;

    std::vector<glm::vec3> m_corners;
    std::vector<Facet> m_facets;
    std::vector<Triangle> m_triangles;
    std::vector<FacetPattern> m_patterns; ///< by mask; else that of all facets alone
};

} // namespace cdr::render
