#pragma once

#include <cdr/render/frame_view.h>
#include <cdr/render/geometry/facet_light.h>
#include <cdr/render/geometry/facet_solid.h>
#include <cdr/render/uploaded_scene.h>
#include <cdr/render/view_transform.h>
#include <cdr/shaders/shared.h>

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <limits>

namespace cdr::render {

/// How much one writer wrote.
struct FacetCounts {
    std::uint32_t vertices = 0;
    std::uint32_t indices = 0;
    std::uint32_t facets = 0;

    bool operator==(const FacetCounts&) const = default;
};

/// What a writer writes, and where: mapped and with room for all that it is given.
struct FacetStreams {
    shaders::FacetVertex* vertices = nullptr;
    std::uint32_t* indices = nullptr; ///< from 0, the writer's first vertex
    /// Null where facets are lit while they are drawn; else `lit` is.
    shaders::FacetRecord* facets = nullptr;
    std::uint32_t firstFacet = 0;   ///< index of the first among all of the frame's
    glm::vec3* lit = nullptr;       ///< FacetLight::stride() for each vertex
    bool metallicRoughness = false; ///< GeometryOptions::metallicRoughness: `facets` hold it
};

/// Transforms solids into one cascade's vertices, and records of the facets that face the camera. Camera and
/// anchor are subtracted in float64, and corners are rounded as geometry.vert rounds them.
class FacetWriter {
  public:
    /// @param light what writes FacetStreams::lit; null where there is none.
    FacetWriter(const FrameView& view, std::size_t cascade, const FacetStreams& into,
                FacetLight* light = nullptr);

    void add(const FacetSolid& solid, const DrawSource& source, const MaterialWords& material);
    const FacetCounts& counts() const { return m_counts; }

  private:
    /// What draws of one solid, basis and material share.
    struct Turned {
        const FacetSolid* solid = nullptr;
        glm::mat3 basis{std::numeric_limits<float>::quiet_NaN()};
        std::uint32_t material = 0;
        bool isMirrored = false;
        std::array<glm::vec3, kMaxSolidParts> corners{};            ///< in view space, before they are moved
        std::array<glm::dvec3, kMaxSolidParts> normals{};           ///< world space, unit, outward
        std::array<double, kMaxSolidParts> heights{};               ///< of the facets' planes over the origin
        std::array<shaders::FacetRecord, kMaxSolidParts> records{}; ///< but for place and id
    };
    void turn(const FacetSolid& solid, const DrawSource& source, const shaders::DrawRecord& record);
    void turnFacet(std::size_t index, const glm::dmat3& basis, const shaders::DrawRecord& record);
    std::uint32_t facing(const DrawSource& source) const;
    void writeRecords(const FacetSolid& solid, const FacetPattern& pattern, const glm::vec3& place,
                      std::uint32_t id);
    void writeLight(const FacetPattern& pattern, const glm::dvec3& origin);

    glm::dvec3 m_cameraPosition;
    glm::dmat3 m_toView; ///< turns world space
    DrawRecordMaker m_records;
    std::uint32_t m_cascadeBits;
    FacetStreams m_into;
    FacetLight* m_light;
    FacetCounts m_counts;
    Turned m_turned;
};

} // namespace cdr::render
