#include <cdr/gpu/upload.h>
#include <cdr/render/octahedral.h>
#include <cdr/render/upload/scene_meshes.h>

#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <set>

namespace cdr::render {

namespace {

/// A vertex as the device reads it: 28 bytes.
struct PackedVertex {
    glm::vec3 position;
    std::uint32_t normal; ///< octahedral, two snorm16
    glm::vec2 uv;
    glm::u8vec4 color;
};
static_assert(sizeof(PackedVertex) == 28);

PackedVertex packed(const scene::Vertex& vertex) {
    return {vertex.position, glm::packSnorm2x16(encodeOctahedral(vertex.normal)), vertex.uv, vertex.color};
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
        std::transform(mesh.vertices.begin(), mesh.vertices.end(), std::back_inserter(vertices), packed);
    }
    m_vertices = gpu::uploadBuffer(m_device, std::as_bytes(std::span(vertices)),
                                   vk::BufferUsageFlagBits::eVertexBuffer, "scene vertices");
    m_indices = gpu::uploadBuffer(m_device, std::as_bytes(std::span(indices)),
                                  vk::BufferUsageFlagBits::eIndexBuffer, "scene indices");
}

bool SceneMeshes::followVertices(const scene::Scene& scene, std::span<const std::uint32_t> changed) {
    bool changesPipeline = false;
    std::vector<gpu::BufferPart> parts;
    for (const std::uint32_t i : std::set<std::uint32_t>(changed.begin(), changed.end())) {
        const scene::Mesh& mesh = scene.meshes[i];
        MeshRange& range = m_ranges[i];
        std::vector<PackedVertex> vertices(mesh.vertices.size());
        std::transform(mesh.vertices.begin(), mesh.vertices.end(), vertices.begin(), packed);
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
    for (const scene::Mesh& mesh : scene.meshes) {
        bytes += mesh.vertices.size() * sizeof(PackedVertex) + mesh.indices.size() * sizeof(std::uint32_t);
        for (const scene::MeshLevel& level : mesh.levels) {
            bytes += level.indices.size() * sizeof(std::uint32_t);
        }
    }
    return bytes;
}

vk::VertexInputBindingDescription vertexBinding() {
    return {.binding = 0, .stride = sizeof(PackedVertex), .inputRate = vk::VertexInputRate::eVertex};
}

std::vector<vk::VertexInputAttributeDescription> vertexAttributes() {
    return {{0, 0, vk::Format::eR32G32B32Sfloat, offsetof(PackedVertex, position)},
            {1, 0, vk::Format::eR16G16Snorm, offsetof(PackedVertex, normal)},
            {2, 0, vk::Format::eR32G32Sfloat, offsetof(PackedVertex, uv)},
            {3, 0, vk::Format::eR8G8B8A8Unorm, offsetof(PackedVertex, color)}};
}

} // namespace cdr::render
