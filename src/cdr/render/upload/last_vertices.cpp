#include <cdr/gpu/commands.h>
#include <cdr/render/materials/packed_vertex.h>
#include <cdr/render/upload/last_vertices.h>

#include <vector>

namespace cdr::render {

void LastVertices::keep(const SceneMeshes& meshes, const scene::Scene& scene,
                        std::span<const std::uint32_t> kept) {
    m_first.clear();
    std::vector<vk::BufferCopy> copies;
    std::size_t bytes = 0;
    for (const std::uint32_t mesh : kept) {
        if (!m_first.try_emplace(mesh, bytes / sizeof(PackedVertex)).second) {
            continue;
        }
        const auto first = static_cast<std::size_t>(meshes.ranges()[mesh].vertexOffset);
        const std::size_t size = scene.meshes[mesh].vertices.size() * sizeof(PackedVertex);
        if (size > 0) {
            copies.push_back({.srcOffset = first * sizeof(PackedVertex), .dstOffset = bytes, .size = size});
        }
        bytes += size;
    }
    if (copies.empty()) {
        return;
    }
    if (m_buffer.size() < bytes) {
        gpu::requireDeviceBytes(m_device, bytes, "the last vertices of scene " + scene.name);
        m_buffer = gpu::Buffer(m_device, bytes,
                               vk::BufferUsageFlagBits::eVertexBuffer | vk::BufferUsageFlagBits::eTransferDst,
                               gpu::MemoryUse::deviceOnly, "last vertices");
    }
    gpu::runOnce(m_device, [&](vk::CommandBuffer commands) {
        commands.copyBuffer(meshes.vertices().handle(), m_buffer.handle(), copies);
    });
}

std::optional<std::size_t> LastVertices::firstOf(std::uint32_t mesh) const {
    const auto found = m_first.find(mesh);
    return found == m_first.end() ? std::nullopt : std::optional(found->second);
}

} // namespace cdr::render
