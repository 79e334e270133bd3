#include <cdr/gpu/upload.h>
#include <cdr/render/materials/packed_vertex.h>
#include <cdr/render/upload/scene_meshes.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <set>

namespace cdr::render {

namespace {

bool hasDetail(const scene::Scene& scene) {
    return std::any_of(scene.materials.begin(), scene.materials.end(),
                       [](const scene::Material& material) { return scene::hasDetail(material); });
}

PackedVertex packedVertex(const scene::Vertex& vertex) {
    return packed(vertex);
}

bool areFaceted(const std::vector<scene::Vertex>& vertices, const std::vector<std::uint32_t>& indices) {
    const auto looksLike = [&](std::uint32_t a, std::uint32_t b) {
        return vertices[a].normal == vertices[b].normal && vertices[a].color == vertices[b].color;
    };
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        if (!looksLike(indices[i], indices[i + 1]) || !looksLike(indices[i], indices[i + 2])) {
            return false;
        }
    }
    return true;
}

/// At every level, since they share pipelines.
bool isFaceted(const scene::Mesh& mesh) {
    return areFaceted(mesh.vertices, mesh.indices) &&
           std::all_of(mesh.levels.begin(), mesh.levels.end(), [&](const scene::MeshLevel& level) {
               return areFaceted(mesh.vertices, level.indices);
           });
}

} // namespace

void SceneMeshes::upload(const scene::Scene& scene) {
    m_ranges.clear();
    m_levels.clear();
    std::vector<PackedVertex> vertices;
    std::vector<std::uint32_t> indices;
    for (const scene::Mesh& mesh : scene.meshes) {
        m_ranges.push_back({.firstIndex = static_cast<std::uint32_t>(indices.size()),
                            .indexCount = static_cast<std::uint32_t>(mesh.indices.size()),
                            .vertexOffset = static_cast<std::int32_t>(vertices.size()),
                            .firstLevel = static_cast<std::uint32_t>(m_levels.size()),
                            .levelCount = static_cast<std::uint32_t>(mesh.levels.size()),
                            .boundingRadius = mesh.boundingRadius,
                            .isFaceted = isFaceted(mesh)});
        indices.insert(indices.end(), mesh.indices.begin(), mesh.indices.end());
        for (const scene::MeshLevel& level : mesh.levels) {
            m_levels.push_back({.firstIndex = static_cast<std::uint32_t>(indices.size()),
                                .indexCount = static_cast<std::uint32_t>(level.indices.size()),
                                .error = level.error});
            indices.insert(indices.end(), level.indices.begin(), level.indices.end());
        }
        std::transform(mesh.vertices.begin(), mesh.vertices.end(), std::back_inserter(vertices),
                       packedVertex);
    }
    m_vertices = gpu::uploadBuffer(m_device, std::as_bytes(std::span(vertices)),
                                   vk::BufferUsageFlagBits::eVertexBuffer, "scene vertices");
    m_indices = gpu::uploadBuffer(m_device, std::as_bytes(std::span(indices)),
                                  vk::BufferUsageFlagBits::eIndexBuffer, "scene indices");
    uploadDetails(scene);
}

void SceneMeshes::uploadDetails(const scene::Scene& scene) {
    m_details = {};
    if (!hasDetail(scene)) {
        return;
    }
    std::vector<PackedDetail> details;
    for (const scene::Mesh& mesh : scene.meshes) {
        for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
            details.push_back(packed(mesh.details.empty() ? scene::VertexDetail{} : mesh.details[i]));
        }
    }
    m_details = gpu::uploadBuffer(m_device, std::as_bytes(std::span(details)),
                                  vk::BufferUsageFlagBits::eVertexBuffer, "scene vertex details");
}

void SceneMeshes::followDetails(const scene::Scene& scene) {
    if ((m_details.size() != 0) != hasDetail(scene)) {
        uploadDetails(scene);
    }
}

bool SceneMeshes::followVertices(const scene::Scene& scene, std::span<const std::uint32_t> changed) {
    bool changesPipeline = false;
    std::vector<gpu::BufferPart> parts;
    for (const std::uint32_t i : std::set<std::uint32_t>(changed.begin(), changed.end())) {
        const scene::Mesh& mesh = scene.meshes[i];
        MeshRange& range = m_ranges[i];
        std::vector<PackedVertex> vertices(mesh.vertices.size());
        std::transform(mesh.vertices.begin(), mesh.vertices.end(), vertices.begin(), packedVertex);
        const std::span<const std::byte> bytes = std::as_bytes(std::span(vertices));
        parts.push_back({.offset = static_cast<std::size_t>(range.vertexOffset) * sizeof(PackedVertex),
                         .bytes = {bytes.begin(), bytes.end()}});
        range.boundingRadius = mesh.boundingRadius;
        changesPipeline = changesPipeline || range.isFaceted != isFaceted(mesh);
        range.isFaceted = isFaceted(mesh);
    }
    gpu::writeBuffer(m_device, m_vertices, parts);
    return changesPipeline;
}

std::uint64_t SceneMeshes::predictBytes(const scene::Scene& scene) {
    std::uint64_t bytes = 0;
    const std::size_t vertexBytes = sizeof(PackedVertex) + (hasDetail(scene) ? sizeof(PackedDetail) : 0);
    for (const scene::Mesh& mesh : scene.meshes) {
        bytes += mesh.vertices.size() * vertexBytes + mesh.indices.size() * sizeof(std::uint32_t);
        for (const scene::MeshLevel& level : mesh.levels) {
            bytes += level.indices.size() * sizeof(std::uint32_t);
        }
    }
    return bytes;
}

} // namespace cdr::render
