#include <cdr/gpu/commands.h>
#include <cdr/render/materials/packed_vertex.h>
#include <cdr/render/upload/last_vertices.h>

#include <utility>

namespace cdr::render {

void LastVertices::choose(const SceneMeshes& meshes, const scene::Scene& scene,
                          std::span<const std::uint32_t> kept) {
    m_first.clear();
    m_copies.clear();
    std::size_t bytes = 0;
    for (const std::uint32_t mesh : kept) {
        if (!m_first.try_emplace(mesh, bytes / sizeof(PackedVertex)).second) {
            continue;
        }
        const auto first = static_cast<std::size_t>(meshes.ranges()[mesh].vertexOffset);
        const std::size_t size = scene.meshes[mesh].vertices.size() * sizeof(PackedVertex);
        if (size > 0) {
            m_copies.push_back({.srcOffset = first * sizeof(PackedVertex), .dstOffset = bytes, .size = size});
        }
        bytes += size;
    }
    if (m_buffer.size() < bytes) {
        gpu::requireDeviceBytes(m_device, bytes, "the last vertices of scene " + scene.name);
        gpu::waitForQueue(m_device);
        m_buffer = gpu::Buffer(m_device, bytes,
                               vk::BufferUsageFlagBits::eVertexBuffer | vk::BufferUsageFlagBits::eTransferDst,
                               gpu::MemoryUse::deviceOnly, "last vertices");
    }
}

void LastVertices::record(vk::CommandBuffer commands, const SceneMeshes& meshes) const {
    using Stage = vk::PipelineStageFlagBits2;
    using Touch = vk::AccessFlagBits2;
    if (m_copies.empty()) {
        return;
    }
    gpu::memoryBarrier(commands, Stage::eVertexAttributeInput | Stage::eComputeShader | Stage::eCopy,
                       Touch::eShaderStorageWrite | Touch::eTransferWrite, Stage::eCopy,
                       Touch::eTransferRead | Touch::eTransferWrite);
    commands.copyBuffer(meshes.vertices().handle(), m_buffer.handle(), m_copies);
    gpu::memoryBarrier(commands, Stage::eCopy, Touch::eTransferWrite, Stage::eVertexAttributeInput,
                       Touch::eVertexAttributeRead);
}

void LastVertices::drop(gpu::Retired& retired) {
    m_first.clear();
    m_copies.clear();
    if (m_buffer.size() != 0) {
        retired.add(std::exchange(m_buffer, {}));
    }
}

std::optional<std::size_t> LastVertices::firstOf(std::uint32_t mesh) const {
    const auto found = m_first.find(mesh);
    return found == m_first.end() ? std::nullopt : std::optional(found->second);
}

} // namespace cdr::render
