#pragma once

#include <cdr/gpu/memory.h>
#include <cdr/render/material_words.h>
#include <cdr/scene/scene.h>

#include <vulkan/vulkan.hpp>

#include <cstdint>
#include <vector>

namespace cdr::render {

/// Where a mesh lies in the shared vertex and index buffers.
struct MeshRange {
    std::uint32_t firstIndex = 0; ///< of the mesh itself, level of detail 0
    std::uint32_t indexCount = 0;
    std::int32_t vertexOffset = 0; ///< the same for all levels
    std::uint32_t firstLevel = 0;  ///< its coarser levels, into GpuScene::levels()
    std::uint32_t levelCount = 0;
    float boundingRadius = 0.0f; ///< object space
    bool isFaceted = false;      ///< the vertices of every triangle share their normal and colour
};

/// A coarser level of a mesh in the shared index buffer.
struct LevelRange {
    std::uint32_t firstIndex = 0;
    std::uint32_t indexCount = 0;
    float error = 0.0f; ///< scene::MeshLevel::error
};

/// Which of a technique's pipelines a mesh and its material need: a sum of these.
inline constexpr std::uint32_t kTexturedVariant = 1;
inline constexpr std::uint32_t kMaskedVariant = 2;
/// Every triangle is of one colour and normal and seen from one side, so its surface is encoded per vertex.
/// Never textured or masked.
inline constexpr std::uint32_t kFacetedVariant = 4;
inline constexpr std::size_t kPipelineVariants = 5;

/// What draws of the same mesh, material and handedness share. Consecutive draws of one kind bind nothing in
/// between and may become one instanced draw.
struct DrawKind {
    MeshRange mesh;
    std::uint32_t variant = 0; ///< below kPipelineVariants
    bool doubleSided = false;
    bool mirrored = false;
    vk::DescriptorSet textureSet; ///< set 0
};

/// One instance as recording reads it: all of it in two cache lines, where the scene's structure of arrays,
/// made for culling, would take eight.
struct DrawSource {
    glm::dvec3 position; ///< world space
    glm::mat3 basis;
    std::uint32_t id = 0; ///< shaders::DrawRecord::id
    std::uint32_t material = 0;
    std::uint32_t kind = 0; ///< into GpuScene::kinds()
};

/// A scene's meshes, materials and textures on a device. Immutable, so any number of renderers may share it.
class GpuScene {
  public:
    /// Uploads and waits. base::RunError, with both figures, when the device has too little memory.
    GpuScene(const gpu::Device& device, const scene::Scene& scene);

    vk::Buffer vertices() const { return m_vertices.handle(); }
    vk::Buffer indices() const { return m_indices.handle(); }
    vk::DescriptorSetLayout textureLayout() const { return *m_textureLayout; }
    /// The part of a draw record that the material decides, by material.
    const std::vector<MaterialWords>& materials() const { return m_materials; }
    /// Whether any material shines; a scene without is drawn by pipelines that know matt surfaces alone.
    bool isShiny() const { return m_isShiny; }
    /// By instance.
    const std::vector<DrawSource>& sources() const { return m_sources; }
    const std::vector<DrawKind>& kinds() const { return m_kinds; }
    /// The coarser levels of all meshes, mesh by mesh.
    const std::vector<LevelRange>& levels() const { return m_levels; }
    /// The indices of a mesh at a level of detail, at most MeshRange::levelCount.
    LevelRange indicesOf(const MeshRange& mesh, std::uint32_t level) const {
        return level == 0 ? LevelRange{mesh.firstIndex, mesh.indexCount, 0.0f}
                          : m_levels[mesh.firstLevel + level - 1];
    }

    /// Binding 0, locations 0 to 3.
    static vk::VertexInputBindingDescription vertexBinding();
    static std::vector<vk::VertexInputAttributeDescription> vertexAttributes();

  private:
    void uploadMeshes(const gpu::Device& device, const scene::Scene& scene);
    void uploadMaterials(const gpu::Device& device, const scene::Scene& scene);
    void uploadTextures(const gpu::Device& device, const scene::Scene& scene);
    void sortKinds(const scene::Scene& scene);

    gpu::Buffer m_vertices;
    gpu::Buffer m_indices;
    std::vector<MeshRange> m_meshes;
    std::vector<LevelRange> m_levels;
    std::vector<gpu::Image> m_textures; ///< the scene's, then one white pixel
    std::vector<vk::UniqueSampler> m_samplers;
    vk::UniqueDescriptorSetLayout m_textureLayout;
    vk::UniqueDescriptorPool m_pool;
    std::vector<MaterialWords> m_materials;
    bool m_isShiny = false;
    std::vector<vk::DescriptorSet> m_textureSets; ///< by material
    std::vector<DrawKind> m_kinds;
    std::vector<DrawSource> m_sources;
};

} // namespace cdr::render
