#pragma once

#include <cdr/gpu/memory.h>
#include <cdr/gpu/retired.h>
#include <cdr/render/draw_kinds.h>
#include <cdr/render/materials/material_words.h>
#include <cdr/render/materials/scene_textures.h>
#include <cdr/render/upload/last_vertices.h>
#include <cdr/render/upload/scene_meshes.h>
#include <cdr/render/upload/vertex_updates.h>
#include <cdr/scene/world/world.h>
#include <cdr/visibility/instance_cells.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

namespace cdr::platform {
class WorkerPool;
}

namespace cdr::render {

/// What a GpuScene has: the meshes, materials and textures on the device, and the instances as recording reads them.
/// @threads, @errors, @lifetime As GpuScene.
class UploadedScene {
  public:
    UploadedScene(const gpu::Device& device, const scene::Scene& scene, std::size_t threads);
    UploadedScene(const gpu::Device& device, const scene::World& world, std::size_t threads);

    /// GpuScene::update().
    void update();

    // What it was made of, and how far it has followed.

    const gpu::Device& device() const { return m_device; }
    /// As it is now.
    const scene::Scene& scene() const { return *m_scene; }
    /// Whether it follows a world.
    bool isLive() const { return m_world != nullptr; }
    /// Whether update() would find nothing to do.
    bool isCurrent() const;
    /// Another number after each update() that found something to do.
    std::uint64_t revision() const { return m_revision; }
    /// Another number after each update() that changed what a draw kind says, or that read all instances anew.
    std::uint64_t tablesRevision() const { return m_tablesRevision; }
    /// Another number after each update() that may have changed a mesh or a material, or that read all instances anew.
    std::uint64_t meshesRevision() const { return m_meshesRevision; }
    /// Another number, larger by one, after each update() that gave meshes other vertices.
    std::uint64_t verticesRevision() const { return m_verticesRevision; }
    /// Which instances changed.
    /// @lifetime That of the world, or the program's where there is none.
    const scene::ChangeLog& instanceChanges() const;
    /// How far in that log update() has come: what was noted later, sources() do not have yet.
    std::uint64_t followedInstances() const { return m_followed.instances; }

    // Meshes.

    /// Of all meshes, one after another.
    VkBuffer vertices() const { return m_meshes.vertices().handle(); }
    /// What vertices have beside vertices(), of all meshes; null where no material has detail.
    VkBuffer details() const { return m_meshes.details().handle(); }
    /// Of all meshes and their levels.
    VkBuffer indices() const { return m_meshes.indices().handle(); }
    /// The coarser levels of all meshes, mesh by mesh.
    const std::vector<LevelRange>& levels() const { return m_meshes.levels(); }
    /// The indices of a mesh at a level of detail, at most MeshRange::levelCount.
    LevelRange indicesOf(const MeshRange& mesh, std::uint32_t level) const;
    /// The chunks of a large mesh itself; none of a small mesh, and of one that the device deforms.
    std::span<const visibility::MeshChunk> chunksOf(const MeshRange& mesh) const;
    /// update() keeps the vertices that meshes had before, as long as somebody has what this returns.
    [[nodiscard]] std::shared_ptr<const void> keepLastVertices() const { return m_lastVerticesUse; }
    /// The vertices before the last update() that gave meshes others, of these meshes. Those after it, if the update also
    /// uploaded all meshes again.
    const LastVertices& lastVertices() const { return m_lastVertices; }
    /// Whether scene() has the vertices that are drawn; else the device alone has those of some meshes (World::setPose()).
    bool hasHostVertices() const { return !isLive() || m_world->hasPosedVertices(); }

    // Materials.

    /// Of the set that DrawKind::textureSet is.
    const gpu::SetLayout& textureLayout() const { return m_textures.baseColorLayout(); }
    /// Of the set that DrawKind::detailSet is.
    const gpu::SetLayout& detailLayout() const { return m_textures.detailLayout(); }
    /// The part of a draw record that the material decides, by material.
    const std::vector<MaterialWords>& materials() const { return m_materials; }
    /// Whether any material has Material::metallicRoughness; a scene without is drawn by pipelines that know matt surfaces alone.
    bool hasMetallicRoughness() const { return m_hasMetallicRoughness; }
    /// Whether any material blends; a scene without is drawn without a pass for translucent surfaces.
    bool hasBlended() const { return m_hasBlended; }
    /// Whether shading must be told what opaque surfaces emit, and how much ambient light arrives there.
    bool hasEmission() const { return m_hasEmission; }
    /// Whether any material has a layer.
    bool hasLayers() const;

    // Instances.

    /// By instance.
    const std::vector<DrawSource>& sources() const { return m_sources; }
    /// What draws have in common, by DrawSource::kind.
    const std::vector<DrawKind>& kinds() const { return m_kinds.all(); }
    /// The instances whose material blends, ascending. They are drawn after all others.
    std::span<const std::uint32_t> blended() const { return m_blended; }
    /// Tells apart the instances that were at one place of a world one after the other; 0 while none is there.
    std::uint32_t generation(std::size_t instance) const;
    /// The instances that do not blend, as culling reads them: made at the first call, and as they are since the last
    /// update().
    /// @threads Any number at once, for a scene that does not change.
    const visibility::InstanceCells& cells(platform::WorkerPool& workers) const;

  private:
    /// What cells() made, and how far it has followed.
    struct Culled {
        std::mutex mutex;
        visibility::InstanceCells cells;
        bool isMade = false;
        std::uint64_t instances = 0; ///< of the world's changes
        std::uint64_t readings = 0;  ///< m_readings
    };

    /// What instances keep of their material.
    struct SurfaceKind {
        bool unlit = false;
        bool blends = false;

        bool operator==(const SurfaceKind&) const = default;
    };
    /// How far the world's changes were followed.
    struct Followed {
        std::uint64_t instances = 0;
        std::uint64_t meshes = 0;
        std::uint64_t materials = 0;
        std::uint64_t textures = 0;
        std::uint64_t vertices = 0;

        static Followed allOf(const scene::World::Changes& c) {
            return {c.instances.end(), c.meshes.end(), c.materials.end(), c.textures.end(), c.vertices.end()};
        }
        bool operator==(const Followed&) const = default;
    };

    void updateTables();
    void followVertices();
    void followPoses();
    void updateVertices();
    void readKinds(const std::optional<std::span<const std::uint32_t>>& meshes);
    bool areTablesReplaced() const;
    bool lacksPose(std::span<const std::uint32_t> meshes) const;
    void readMaterials();
    void replaceTables();
    DrawKinds::From kindsFrom() const { return {*m_scene, m_meshes, m_textures, m_layers}; }
    void readInstance(std::size_t i);
    void readAllInstances();
    void updateInstances();

    const gpu::Device& m_device;
    const scene::Scene* m_scene;
    const scene::World* m_world = nullptr;
    Followed m_followed;
    std::uint64_t m_revision = 0;
    std::uint64_t m_tablesRevision = 0;
    std::uint64_t m_meshesRevision = 0;
    std::uint64_t m_readings = 0; ///< of all instances
    gpu::Retired m_retired;       ///< what frames in flight may still read
    SceneMeshes m_meshes;
    LastVertices m_lastVertices;
    VertexUpdates m_vertexUpdates;
    bool m_arePosesStale =
        false; ///< whether meshes that the device deforms were uploaded as the CPU has them
    bool m_isEachPoseStale = false; ///< the same of all meshes, so that what is kept is not the last frame's
    std::shared_ptr<const char> m_lastVerticesUse = std::make_shared<char>(); ///< each renderer has one more
    std::uint64_t m_verticesRevision = 0;
    SceneTextures m_textures;
    std::vector<MaterialWords> m_materials;
    bool m_hasMetallicRoughness = false;
    bool m_hasBlended = false;
    bool m_hasEmission = false;
    std::vector<SurfaceKind> m_surfaces; ///< by material
    bool m_isEachInstanceStale = false;  ///< whether a material changed what instances keep of it
    std::vector<LayerPlace> m_layers;    ///< by material
    DrawKinds m_kinds;
    std::size_t m_mostKinds = 0; ///< beyond, those that no instance has any more are dropped
    std::vector<DrawSource> m_sources;
    std::vector<std::uint32_t> m_blended;
    mutable Culled m_culled;
};

} // namespace cdr::render
