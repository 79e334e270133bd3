#include <cdr/render/geometry/facet_writer.h>
#include <cdr/render/octahedral.h>

#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <cmath>

namespace cdr::render {

namespace {

/// A facet that the camera sees from behind by more than this share of its distance is left out. float32
/// turns no facet by as much. So the device would cull what is left out too.
constexpr double kFacingMargin = 1e-6;

/// As encodeAlbedo() of shaders/targets/gbuffer.glsl.
std::uint32_t encodeAlbedo(const glm::vec4& baseColor) {
    return glm::packUnorm4x8(glm::vec4(glm::sqrt(glm::vec3(baseColor)), 0.0f));
}

/// In the order in which geometry.vert sums.
float along(const glm::vec4& row, const glm::vec3& corner) {
    return row.x * corner.x + row.y * corner.y + row.z * corner.z;
}

} // namespace

FacetWriter::FacetWriter(const FrameView& view, std::size_t cascade, const FacetStreams& into,
                         FacetLight* light)
    : m_cameraPosition(view.camera.position),
      m_toView(glm::transpose(glm::dmat3(view.camera.right, view.camera.up, view.camera.back))),
      m_records(view.camera, view.cascades[cascade].terms.anchorView),
      m_cascadeBits(static_cast<std::uint32_t>(cascade) << shaders::kIdBits),
      m_into(into),
      m_light(light) {}

void FacetWriter::turn(const FacetSolid& solid, const DrawSource& source, const shaders::DrawRecord& record) {
    m_turned.solid = &solid;
    m_turned.basis = source.basis;
    m_turned.material = source.material;
    m_turned.isMirrored = isMirror(source.basis);
    for (std::size_t i = 0; i < solid.corners().size(); ++i) {
        const glm::vec3& corner = solid.corners()[i];
        m_turned.corners[i] = {along(record.right, corner), along(record.up, corner),
                               along(record.ahead, corner)};
    }
    for (std::size_t i = 0; i < solid.facets().size(); ++i) {
        turnFacet(i, glm::dmat3(source.basis), record);
    }
}

void FacetWriter::turnFacet(std::size_t index, const glm::dmat3& basis, const shaders::DrawRecord& record) {
    const Facet& facet = m_turned.solid->facets()[index];
    // Normals turn by the cofactor matrix, and a mirror turns them round once more.
    const glm::dmat3 cofactor(glm::cross(basis[1], basis[2]), glm::cross(basis[2], basis[0]),
                              glm::cross(basis[0], basis[1]));
    const glm::dvec3 normal =
        glm::normalize(cofactor * glm::dvec3(facet.normal) * (m_turned.isMirrored ? -1.0 : 1.0));
    m_turned.normals[index] = normal;
    m_turned.heights[index] = glm::dot(normal, basis * glm::dvec3(m_turned.solid->corners()[facet.corner]));

    const glm::vec4 baseColor =
        glm::vec4(facet.color) / 255.0f *
        glm::vec4(glm::unpackHalf2x16(record.baseColorRg), glm::unpackHalf2x16(record.baseColorBa));
    if (m_light != nullptr) {
        m_light->turn(index, glm::vec3(baseColor),
                      (record.id & shaders::kIdUnlit) != 0 ? Reflection::unlit : Reflection::matt);
    }
    const double scale =
        std::sqrt(glm::dot(basis[0], basis[0]) + glm::dot(basis[1], basis[1]) + glm::dot(basis[2], basis[2]));
    m_turned.records[index] = {.normal = glm::vec2(encodeOctahedral(m_toView * normal)),
                               .extent = static_cast<float>(scale * static_cast<double>(facet.extent)),
                               .albedo =
                                   encodeAlbedo(baseColor) |
                                   (m_into.metallicRoughness ? record.cutoffAndMetallicRoughness << 24 : 0u),
                               .x = 0.0f,
                               .y = 0.0f,
                               .ahead = 0.0f,
                               .id = 0};
}

/// Bit k is set where facet k may face the camera.
std::uint32_t FacetWriter::facing(const DrawSource& source) const {
    const glm::dvec3 toCamera = m_cameraPosition - source.position;
    const double margin =
        kFacingMargin * (std::abs(toCamera.x) + std::abs(toCamera.y) + std::abs(toCamera.z));
    std::uint32_t mask = 0;
    for (std::size_t i = 0; i < m_turned.solid->facets().size(); ++i) {
        const bool isFacing = glm::dot(m_turned.normals[i], toCamera) - m_turned.heights[i] >= -margin;
        mask |= isFacing ? 1u << i : 0u;
    }
    return mask;
}

void FacetWriter::writeRecords(const FacetSolid& solid, const FacetPattern& pattern, const glm::vec3& place,
                               std::uint32_t id) {
    shaders::FacetRecord* facet = m_into.facets + m_counts.facets;
    for (const std::uint8_t listed : pattern.facets) {
        const glm::vec3 at = m_turned.corners[solid.facets()[listed].corner] + place;
        *facet = m_turned.records[listed];
        facet->x = at.x;
        facet->y = at.y;
        facet->ahead = at.z;
        facet->id = id;
        ++facet;
    }
}

void FacetWriter::writeLight(const FacetPattern& pattern, const glm::dvec3& origin) {
    const std::size_t stride = m_light->stride();
    std::array<glm::vec3, kMaxSolidParts*(1 + shaders::kPushedLights)> lit;
    for (std::size_t i = 0; i < pattern.facets.size(); ++i) {
        const std::size_t facet = pattern.facets[i];
        m_light->write(facet, m_turned.normals[facet], m_turned.heights[facet], origin, &lit[i * stride]);
    }
    glm::vec3* into = m_into.lit + m_counts.vertices * stride;
    for (const FacetPattern::Vertex& vertex : pattern.vertices) {
        into = std::copy_n(&lit[vertex.facet * stride], stride, into);
    }
}

void FacetWriter::add(const FacetSolid& solid, const DrawSource& source, const MaterialWords& material) {
    const shaders::DrawRecord record = m_records.make(source, material);
    if (&solid != m_turned.solid || source.basis != m_turned.basis || source.material != m_turned.material) {
        turn(solid, source, record);
    }
    const glm::vec3 place(record.right.w, record.up.w, record.ahead.w);
    const FacetPattern& pattern = solid.pattern(solid.isMasked() ? facing(source) : 0u);
    const std::uint32_t firstId = m_into.firstFacet + m_counts.facets + 1;
    shaders::FacetVertex* vertex = m_into.vertices + m_counts.vertices;
    for (const FacetPattern::Vertex& made : pattern.vertices) {
        const glm::vec3 at = m_turned.corners[made.corner] + place;
        *vertex++ = {.x = at.x, .y = at.y, .ahead = at.z, .facet = firstId + made.facet};
    }
    std::uint32_t* index = m_into.indices + m_counts.indices;
    const std::size_t second = m_turned.isMirrored ? 2 : 1; // a mirror turns triangles round
    for (std::size_t i = 0; i < pattern.indices.size(); i += 3) {
        *index++ = m_counts.vertices + pattern.indices[i];
        *index++ = m_counts.vertices + pattern.indices[i + second];
        *index++ = m_counts.vertices + pattern.indices[i + 3 - second];
    }
    if (m_light != nullptr) {
        writeLight(pattern, source.position);
    } else {
        writeRecords(solid, pattern, place, (record.id & ~shaders::kIdMirror) | m_cascadeBits);
    }
    m_counts.vertices += static_cast<std::uint32_t>(pattern.vertices.size());
    m_counts.indices += static_cast<std::uint32_t>(pattern.indices.size());
    m_counts.facets += static_cast<std::uint32_t>(pattern.facets.size());
}

} // namespace cdr::render
