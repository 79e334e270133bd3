#pragma once

#include <cdr/gpu/memory.h>
#include <cdr/render/material_words.h>
#include <cdr/scene/world/world.h>

#include <vulkan/vulkan.hpp>

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <tuple>
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

/// A scene's meshes, materials and textures on a device, and its instances as recording reads them. Any number of
/// renderers may share it.
class GpuScene {
  public:
    /// Of a scene that stays as it is. Uploads and waits. base::InputError as scene::requireUsable(); base::RunError,
    /// with both figures, when the device has too little memory.
    GpuScene(const gpu::Device& device, const scene::Scene& scene);
    /// Of a scene that changes; the world must outlive this.
    GpuScene(const gpu::Device& device, const scene::World& world);

    /// Follows the world's edits since the last call; renderers call it at the start of a frame. Instances take time
    /// by the number that changed. Meshes, materials and textures wait for all that the queue was given before.
    /// base::RunError as the constructor.
    void update();

    const scene::Scene& scene() const { return *m_scene; }
    bool isLive() const { return m_world != nullptr; }
    /// Whether update() would find nothing to do.
    bool isCurrent() const;
    /// Another number after each update() that found something to do.
    std::uint64_t revision() const { return m_revision; }
    /// Another number after each update() that changed more than instances: what a draw kind or a material says.
    std::uint64_t tablesRevision() const { return m_tablesRevision; }
    /// Which instances changed.
    const scene::ChangeLog& instanceChanges() const;

    vk::Buffer vertices() const { return m_vertices.handle(); }
    vk::Buffer indices() const { return m_indices.handle(); }
    vk::DescriptorSetLayout textureLayout() const { return *m_textureLayout; }
    /// The part of a draw record that the material decides, by material.
    const std::vector<MaterialWords>& materials() const { return m_materials; }
    /// Whether any material shines; a scene without is drawn by pipelines that know matt surfaces alone.
    bool isShiny() const { return m_isShiny; }
    /// Whether any material blends; a scene without is drawn without a pass for translucent surfaces.
    bool hasBlended() const { return m_hasBlended; }
    /// The instances whose material blends, ascending. They are drawn after all others.
    std::span<const std::uint32_t> blended() const { return m_blended; }
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
    /// The scene's texture, or one white pixel for materials without.
    struct UploadedTexture {
        gpu::Image image;
        vk::UniqueSampler sampler;
        vk::UniqueDescriptorPool pool;
        vk::DescriptorSet set;
    };
    /// Mesh, material, mirrored.
    using KindKey = std::tuple<std::uint32_t, std::uint32_t, bool>;
    /// How far the world's changes were followed.
    struct Followed {
        std::uint64_t instances = 0;
        std::uint64_t meshes = 0;
        std::uint64_t materials = 0;
        std::uint64_t textures = 0;
    };

    void uploadMeshes(const gpu::Device& device, const scene::Scene& scene);
    UploadedTexture uploadTexture(const scene::Texture& texture) const;
    void updateTables();
    void updateTextures();
    void readMaterials();
    DrawKind kindOf(const KindKey& key) const;
    std::uint32_t kindIndexOf(const KindKey& key);
    void readInstance(std::size_t i);
    void readAllInstances();
    void updateInstances();

    const gpu::Device& m_device;
    const scene::Scene* m_scene;
    const scene::World* m_world = nullptr;
    Followed m_followed;
    std::uint64_t m_revision = 0;
    std::uint64_t m_tablesRevision = 0;
    gpu::Buffer m_vertices;
    gpu::Buffer m_indices;
    std::vector<MeshRange> m_meshes;
    std::vector<LevelRange> m_levels;
    vk::UniqueDescriptorSetLayout m_textureLayout;
    UploadedTexture m_white;
    std::vector<UploadedTexture> m_textures; ///< the scene's
    std::vector<MaterialWords> m_materials;
    bool m_isShiny = false;
    bool m_hasBlended = false;
    std::vector<DrawKind> m_kinds; ///< only ever more
    std::vector<KindKey> m_kindKeys;
    std::map<KindKey, std::uint32_t> m_kindIndices;
    std::vector<DrawSource> m_sources;
    std::vector<std::uint32_t> m_blended;
};

} // namespace cdr::render
