#pragma once

#include <cdr/gpu/memory.h>
#include <cdr/gpu/retired.h>
#include <cdr/render/upload/scene_meshes.h>
#include <cdr/scene/scene.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace cdr::render {

/// The vertices that meshes had before they were given others, on the device.
class LastVertices {
  public:
    explicit LastVertices(const gpu::Device& device) : m_device(device) {}

    /// Chooses the meshes whose vertices are kept, in the place of those kept before. Waits for what was submitted where they
    /// need more room.
    /// @param meshes have as many vertices as the scene's
    /// @param kept places, repeats allowed
    void choose(const SceneMeshes& meshes, const scene::Scene& scene, std::span<const std::uint32_t> kept);
    /// Copies these vertices as they are on the device, once frames have read those kept before.
    void record(vk::CommandBuffer commands, const SceneMeshes& meshes) const;

    /// Keeps none any more.
    void drop(gpu::Retired& retired);

    /// PackedVertices, mesh by mesh.
    const gpu::Buffer& buffer() const { return m_buffer; }
    /// The first vertex of a mesh in buffer(); nothing of one that is not kept.
    std::optional<std::size_t> firstOf(std::uint32_t mesh) const;

  private:
    const gpu::Device& m_device;
    gpu::Buffer m_buffer;
    std::map<std::uint32_t, std::size_t> m_first; ///< by mesh
    std::vector<vk::BufferCopy> m_copies;
};

} // namespace cdr::render
