#include <cdr/base/format_error.h>
#include <cdr/gpu/upload.h>
#include <cdr/render/materials/packed_vertex.h>
#include <cdr/render/upload/closed_mesh.h>
#include <cdr/render/upload/scene_meshes.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <utility>

namespace cdr::render {

namespace {

bool hasDetail(const scene::Scene& scene) {
    return std::any_of(scene.materials.begin(), scene.materials.end(),
                       [](const scene::Material& material) { return scene::hasDetail(material); });
}

/// Least cosine between a facet's normal and that of its triangles, which float32 positions round.
constexpr double kMinFacetCosine = 0.999;

/// Whether a triangle has one colour and one normal, which is its own.
bool isFacet(const scene::Vertex& a, const scene::Vertex& b, const scene::Vertex& c) {
    if (a.normal != b.normal || a.normal != c.normal || a.color != b.color || a.color != c.color) {
        return false;
    }
    const glm::dvec3 first(a.position);
    const glm::dvec3 area = glm::cross(glm::dvec3(b.position) - first, glm::dvec3(c.position) - first);
    const double least = kMinFacetCosine * glm::length(area) * glm::length(glm::dvec3(a.normal));
    return std::abs(glm::dot(area, glm::dvec3(a.normal))) >= least;
}

/// At every level and in every cluster, since they share pipelines.
bool isFaceted(const scene::Mesh& mesh) {
    return areFaceted(mesh.vertices, mesh.indices) && areFaceted(mesh.vertices, mesh.clusters.indices) &&
           std::all_of(mesh.levels.begin(), mesh.levels.end(), [&](const scene::MeshLevel& level) {
               return areFaceted(mesh.vertices, level.indices);
           });
}

template <typename T>
gpu::BufferPart partOf(std::size_t first, const std::vector<T>& values) {
    const std::span<const std::byte> bytes = std::as_bytes(std::span(values));
    return {.offset = first * sizeof(T), .bytes = {bytes.begin(), bytes.end()}};
}

std::vector<PackedVertex> verticesOf(const scene::Mesh& mesh) {
    std::vector<PackedVertex> vertices(mesh.vertices.size());
    std::transform(mesh.vertices.begin(), mesh.vertices.end(), vertices.begin(),
                   [](const scene::Vertex& vertex) { return packed(vertex); });
    return vertices;
}

std::vector<PackedDetail> detailsOf(const scene::Mesh& mesh) {
    std::vector<PackedDetail> details(mesh.vertices.size(), packed(scene::VertexDetail{}));
    std::transform(mesh.details.begin(), mesh.details.end(), details.begin(),
                   [](const scene::VertexDetail& detail) { return packed(detail); });
    return details;
}

} // namespace

bool areFaceted(std::span<const scene::Vertex> vertices, std::span<const std::uint32_t> indices) {
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        if (!isFacet(vertices[indices[i]], vertices[indices[i + 1]], vertices[indices[i + 2]])) {
            return false;
        }
    }
    return true;
}

/// On their way into the buffers.
struct SceneMeshes::Packed {
    std::vector<PackedVertex> vertices;
    std::vector<std::uint32_t> indices;
};

SceneMeshes::Counts SceneMeshes::countsOf(const scene::Mesh& mesh) {
    Counts counts{.vertices = mesh.vertices.size(),
                  .indices = mesh.indices.size() + mesh.clusters.indices.size()};
    for (const scene::MeshLevel& level : mesh.levels) {
        counts.indices += level.indices.size();
    }
    return counts;
}

SceneMeshes::Counts SceneMeshes::countsOf(const scene::Scene& scene) {
    Counts counts;
    for (const scene::Mesh& mesh : scene.meshes) {
        const Counts more = countsOf(mesh);
        counts.vertices += more.vertices;
        counts.indices += more.indices;
    }
    return counts;
}

SceneMeshes::Counts SceneMeshes::most() const {
    const std::uint64_t bytes = m_device.info().maxBufferBytes;
    // As MeshRange holds their numbers.
    constexpr std::uint64_t kVertices = std::numeric_limits<std::int32_t>::max();
    constexpr std::uint64_t kIndices = std::numeric_limits<std::uint32_t>::max();
    return {.vertices = std::min(bytes / sizeof(PackedVertex), kVertices),
            .indices = std::min(bytes / sizeof(std::uint32_t), kIndices)};
}

void SceneMeshes::requireRoom(const scene::Scene& scene) const {
    const Counts needed = countsOf(scene);
    const Counts room = most();
    if (needed.vertices > room.vertices || needed.indices > room.indices) {
        throw base::runError(
            "the meshes of scene {} have {} vertices and {} indices, {} has buffers for {} and {}",
            scene.name, needed.vertices, needed.indices, m_device.info().name, room.vertices, room.indices);
    }
}

void SceneMeshes::requireIndices(const scene::Scene& scene, std::uint32_t mesh) const {
    const std::size_t vertices = scene.meshes[mesh].vertices.size();
    const std::uint64_t nameable = std::uint64_t{m_device.info().maxIndex} + 1;
    if (vertices > nameable) {
        throw base::inputError("mesh {} of scene {} has {} vertices, {} draws at most {} of a mesh", mesh,
                               scene.name, vertices, m_device.info().name, nameable);
    }
}

void SceneMeshes::requireIndices(const scene::Scene& scene) const {
    for (std::uint32_t mesh = 0; mesh < scene.meshes.size(); ++mesh) {
        requireIndices(scene, mesh);
    }
}

MeshRange SceneMeshes::place(const scene::Mesh& mesh, Packed& into) {
    const auto placeIndices = [&](const std::vector<std::uint32_t>& indices) {
        const auto first = static_cast<std::uint32_t>(m_used.indices);
        into.indices.insert(into.indices.end(), indices.begin(), indices.end());
        m_used.indices += indices.size();
        return first;
    };
    const std::vector<visibility::MeshChunk> chunks = visibility::chunksOf(mesh.vertices, mesh.indices);
    const MeshRange range{.firstIndex = placeIndices(mesh.indices),
                          .indexCount = static_cast<std::uint32_t>(mesh.indices.size()),
                          .vertexOffset = static_cast<std::int32_t>(m_used.vertices),
                          .firstLevel = static_cast<std::uint32_t>(m_levels.size()),
                          .levelCount = static_cast<std::uint32_t>(mesh.levels.size()),
                          .firstClusterIndex = placeIndices(mesh.clusters.indices),
                          .boundingRadius = mesh.boundingRadius,
                          .isFaceted = isFaceted(mesh),
                          .isClosed = isClosed(mesh.vertices, mesh.indices),
                          .firstChunk = static_cast<std::uint32_t>(m_chunks.size()),
                          .chunkCount = static_cast<std::uint32_t>(chunks.size())};
    m_chunks.insert(m_chunks.end(), chunks.begin(), chunks.end());
    for (const scene::MeshLevel& level : mesh.levels) {
        m_levels.push_back({.firstIndex = placeIndices(level.indices),
                            .indexCount = static_cast<std::uint32_t>(level.indices.size()),
                            .error = level.error});
    }
    const std::vector<PackedVertex> vertices = verticesOf(mesh);
    into.vertices.insert(into.vertices.end(), vertices.begin(), vertices.end());
    m_used.vertices += mesh.vertices.size();
    return range;
}

void SceneMeshes::upload(const scene::Scene& scene) {
    requireIndices(scene);
    requireRoom(scene);
    upload(scene, countsOf(scene));
}

void SceneMeshes::upload(const scene::Scene& scene, const Counts& room) {
    m_room.reset(); // until all is there
    m_used = {};
    m_ranges.clear();
    m_levels.clear();
    m_chunks.clear();
    const auto made = [&](std::size_t bytes, vk::BufferUsageFlags usage, const char* name) {
        return gpu::Buffer(m_device, bytes, usage | vk::BufferUsageFlagBits::eTransferDst,
                           gpu::MemoryUse::deviceOnly, name);
    };
    m_vertices = made(room.vertices * sizeof(PackedVertex),
                      vk::BufferUsageFlagBits::eVertexBuffer | vk::BufferUsageFlagBits::eStorageBuffer |
                          vk::BufferUsageFlagBits::eTransferSrc,
                      "scene vertices");
    m_indices =
        made(room.indices * sizeof(std::uint32_t), vk::BufferUsageFlagBits::eIndexBuffer, "scene indices");
    // Mesh by mesh, since large scenes should not be in memory once more.
    gpu::BufferFill vertices(m_device, m_vertices);
    gpu::BufferFill indices(m_device, m_indices);
    for (const scene::Mesh& mesh : scene.meshes) {
        Packed packed;
        m_ranges.push_back(place(mesh, packed));
        vertices.add(std::as_bytes(std::span(packed.vertices)));
        indices.add(std::as_bytes(std::span(packed.indices)));
    }
    vertices.finish();
    indices.finish();
    uploadDetails(scene, room.vertices);
    m_room = room;
}

bool SceneMeshes::follow(const scene::Scene& scene, std::optional<std::span<const std::uint32_t>> changed,
                         gpu::Retired& retired) {
    if (changed && append(scene, {changed->begin(), changed->end()})) {
        return false;
    }
    requireIndices(scene);
    requireRoom(scene);
    const std::uint64_t bytes = predictBytes(scene);
    gpu::requireDeviceBytes(m_device, bytes, "the meshes of scene " + scene.name);
    const std::size_t times = 2 * bytes <= gpu::freeDeviceBytes(m_device) ? 2 : 1;
    const Counts needed = countsOf(scene);
    for (gpu::Buffer* buffer : {&m_vertices, &m_indices, &m_details}) {
        retired.add(std::exchange(*buffer, {}));
    }
    const Counts room = most();
    upload(scene, {.vertices = std::min(times * needed.vertices, room.vertices),
                   .indices = std::min(times * needed.indices, room.indices)});
    return true;
}

bool SceneMeshes::append(const scene::Scene& scene, const std::set<std::uint32_t>& changed) {
    const Counts before = m_used;
    Counts after = before;
    for (const std::uint32_t mesh : changed) {
        requireIndices(scene, mesh);
        const Counts added = countsOf(scene.meshes[mesh]);
        after.vertices += added.vertices;
        after.indices += added.indices;
    }
    if (!m_room || after.vertices > m_room->vertices || after.indices > m_room->indices) {
        return false;
    }
    Packed packed;
    std::vector<PackedDetail> details;
    m_ranges.resize(scene.meshes.size());
    for (const std::uint32_t mesh : changed) {
        m_ranges[mesh] = place(scene.meshes[mesh], packed);
        const std::vector<PackedDetail> more = detailsOf(scene.meshes[mesh]);
        details.insert(details.end(), more.begin(), more.end());
    }
    gpu::writeBuffer(m_device, m_vertices, {{partOf(before.vertices, packed.vertices)}});
    gpu::writeBuffer(m_device, m_indices, {{partOf(before.indices, packed.indices)}});
    if (m_details.size() != 0) {
        gpu::writeBuffer(m_device, m_details, {{partOf(before.vertices, details)}});
    }
    return true;
}

void SceneMeshes::uploadDetails(const scene::Scene& scene, std::size_t room) {
    m_details = {};
    if (!hasDetail(scene)) {
        return;
    }
    std::vector<PackedDetail> details(room);
    for (std::size_t mesh = 0; mesh < scene.meshes.size(); ++mesh) {
        const std::vector<PackedDetail> more = detailsOf(scene.meshes[mesh]);
        std::copy(more.begin(), more.end(), details.begin() + m_ranges[mesh].vertexOffset);
    }
    m_details =
        gpu::uploadBuffer(m_device, std::as_bytes(std::span(details)),
                          vk::BufferUsageFlagBits::eVertexBuffer | vk::BufferUsageFlagBits::eStorageBuffer,
                          "scene vertex details");
}

void SceneMeshes::followDetails(const scene::Scene& scene, gpu::Retired& retired) {
    if ((m_details.size() != 0) != hasDetail(scene)) {
        retired.add(std::exchange(m_details, {}));
        uploadDetails(scene, m_room->vertices);
    }
}

void SceneMeshes::followVertices(const scene::Scene& scene, std::span<const std::uint32_t> changed) {
    std::vector<gpu::BufferPart> vertices;
    std::vector<gpu::BufferPart> details;
    for (const std::uint32_t i : std::set<std::uint32_t>(changed.begin(), changed.end())) {
        const scene::Mesh& mesh = scene.meshes[i];
        MeshRange& range = m_ranges[i];
        const auto first = static_cast<std::size_t>(range.vertexOffset);
        vertices.push_back(partOf(first, verticesOf(mesh)));
        if (m_details.size() != 0) {
            details.push_back(partOf(first, detailsOf(mesh)));
        }
        if (range.chunkCount > 0) {
            std::ranges::copy(visibility::chunksOf(mesh.vertices, mesh.indices),
                              m_chunks.begin() + range.firstChunk);
        }
        range.isFaceted = isFaceted(mesh);
        range.isClosed = isClosed(mesh.vertices, mesh.indices);
    }
    gpu::writeBuffer(m_device, m_vertices, vertices);
    if (!details.empty()) {
        gpu::writeBuffer(m_device, m_details, details);
    }
}

void SceneMeshes::followPose(std::uint32_t mesh, bool isFaceted) {
    MeshRange& range = m_ranges[mesh];
    range.isFaceted = isFaceted;
    range.isClosed = false;
    range.chunkCount = 0;
}

std::uint64_t SceneMeshes::predictBytes(const scene::Scene& scene) {
    const Counts counts = countsOf(scene);
    return counts.vertices * (sizeof(PackedVertex) + (hasDetail(scene) ? sizeof(PackedDetail) : 0)) +
           counts.indices * sizeof(std::uint32_t);
}

} // namespace cdr::render
