#pragma once

#include <cdr/gpu/memory.h>
#include <cdr/scene/scene.h>

#include <vulkan/vulkan.hpp>

#include <cstdint>
#include <vector>

namespace cdr::render {

/// Where a mesh lies in the shared vertex and index buffers.
struct MeshRange {
    std::uint32_t firstIndex = 0;
    std::uint32_t indexCount = 0;
    std::int32_t vertexOffset = 0;
};

/// What a material asks of the pipeline and the rasteriser; the rest is in the material buffer.
struct MaterialState {
    bool textured = false;
    bool masked = false;
    bool doubleSided = false;
    vk::DescriptorSet textureSet; ///< set 1
};

/// A scene's meshes, materials and textures on a device. Immutable, so any number of renderers may share it.
class GpuScene {
  public:
    /// Uploads and waits. base::RunError, with both figures, when the device has too little memory.
    GpuScene(const gpu::Device& device, const scene::Scene& scene);

    vk::Buffer vertices() const { return m_vertices.handle(); }
    vk::Buffer indices() const { return m_indices.handle(); }
    vk::Buffer materials() const { return m_materials.handle(); }
    vk::DescriptorSetLayout textureLayout() const { return *m_textureLayout; }
    const MeshRange& mesh(std::uint32_t index) const { return m_meshes[index]; }
    const MaterialState& material(std::uint32_t index) const { return m_materialStates[index]; }
    const std::vector<MaterialState>& materialStates() const { return m_materialStates; }

    static vk::VertexInputBindingDescription vertexBinding();
    static std::vector<vk::VertexInputAttributeDescription> vertexAttributes();

  private:
    void uploadMeshes(const gpu::Device& device, const scene::Scene& scene);
    void uploadMaterials(const gpu::Device& device, const scene::Scene& scene);
    void uploadTextures(const gpu::Device& device, const scene::Scene& scene);

    gpu::Buffer m_vertices;
    gpu::Buffer m_indices;
    gpu::Buffer m_materials;
    std::vector<MeshRange> m_meshes;
    std::vector<gpu::Image> m_textures; ///< the scene's, then one white pixel
    std::vector<vk::UniqueSampler> m_samplers;
    vk::UniqueDescriptorSetLayout m_textureLayout;
    vk::UniqueDescriptorPool m_pool;
    std::vector<MaterialState> m_materialStates;
};

} // namespace cdr::render
