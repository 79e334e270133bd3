#pragma once

#include <cdr/base/export.h>
#include <cdr/gpu/device.h>
#include <cdr/scene/world/world.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace cdr::gpu {
struct SetLayout;
}
namespace cdr::platform {
class WorkerPool;
}
namespace cdr::visibility {
class InstanceCells;
struct MeshChunk;
} // namespace cdr::visibility

namespace cdr::render {

struct DrawKind;
struct DrawSource;
struct LevelRange;
class LastVertices;
struct MaterialWords;
struct MeshRange;

/// A scene's meshes, materials and textures on a device, and its instances as recording reads them. Any number of
/// renderers may share it.
/// @threads One thread at a time: renderers that share it take turns.
/// @errors None but those that a function names.
/// @lifetime References, spans and handles are valid until an update() that finds something to do, or the end of this.
class CDR_EXPORT GpuScene {
  public:
    /// For a scene that does not change. Uploads and waits. The device and the scene must outlive this.
    /// @param threads that make the smaller levels of large textures, at most; 0: as many as there are processors. What is
    ///        uploaded is the same to the bit. None of them outlives the call, or that of update().
    /// @throws base::InputError as scene::requireUsable(), and for a texture larger than the device's images, or a mesh of more
    ///         vertices than its draws can name (gpu::DeviceInfo::maxIndex).
    /// @throws base::RunError when the device's memory or its limits do not suffice, with both figures where that is known before.
    /// @throws std::system_error for Vulkan's other errors, a lost device among them.
    GpuScene(const gpu::Device& device, const scene::Scene& scene, std::size_t threads = 0);
    /// For a scene that changes. The device and the world must outlive this.
    /// @param threads as above.
    /// @errors As above, without those of scene::requireUsable(): the world checked its edits.
    GpuScene(const gpu::Device& device, const scene::World& world, std::size_t threads = 0);
    ~GpuScene();
    GpuScene(const GpuScene&) = delete;
    GpuScene& operator=(const GpuScene&) = delete;
    /// What is moved from may only be destroyed or assigned to. No renderer may use either.
    GpuScene(GpuScene&&) noexcept;
    /// As the constructor that moves.
    GpuScene& operator=(GpuScene&&) noexcept;

    /// Follows the world's edits since the last call; renderers call it at the start of a frame. Time is proportional to the
    /// number of changed instances, or of all where one that blends came or went. What is uploaded, meshes, vertices and
    /// textures, waits for all that the queue was given before. What is replaced or removed is kept until that is done.
    /// @errors base::InputError for a texture or a mesh, as the constructors: once it is gone, the next call follows.
    ///         base::RunError and std::system_error as the constructors.
    void update();

    /// What it was made of, as it is now.
    /// @lifetime That of the scene, or of the world.
    const scene::Scene& scene() const;
    /// Whether it follows a world.
    bool isLive() const;
    /// Whether update() would find nothing to do.
    bool isCurrent() const;
    /// Another number after each update() that found something to do.
    std::uint64_t revision() const;

    // What passes read, for the renderer's own use.

    /// That it is on.
    VkDevice device() const;
    /// Another number after each update() that changed what a draw kind says, or that read all instances anew.
    std::uint64_t tablesRevision() const;
    /// Another number after each update() that may have changed a mesh or a material.
    std::uint64_t meshesRevision() const;
    /// Which instances changed.
    /// @lifetime That of the world, or the program's where there is none.
    const scene::ChangeLog& instanceChanges() const;
    /// How far in that log update() has come: what was noted later, sources() do not have yet.
    std::uint64_t followedInstances() const;
    /// Tells apart the instances that were at one place of a world one after the other; 0 while none is there.
    std::uint32_t generation(std::size_t instance) const;
    /// Of all meshes, one after another.
    VkBuffer vertices() const;
    /// Of all meshes and their levels.
    VkBuffer indices() const;
    /// Of the set that DrawKind::textureSet is.
    const gpu::SetLayout& textureLayout() const;
    /// Of the set that DrawKind::detailSet is.
    const gpu::SetLayout& detailLayout() const;
    /// update() keeps the vertices that meshes had before, as long as somebody has what this returns.
    [[nodiscard]] std::shared_ptr<const void> keepLastVertices();
    /// Another number, larger by one, after each update() that gave meshes other vertices.
    std::uint64_t verticesRevision() const;
    /// The vertices before the last of these updates, of meshes that it gave others. Those after it, if the update also uploaded
    /// all meshes again.
    const LastVertices& lastVertices() const;
    /// Whether scene() has the vertices that are drawn; else the device alone has those of some meshes (World::setPose()).
    bool hasHostVertices() const;
    /// What vertices have beside vertices(), of all meshes; null where no material has detail.
    VkBuffer details() const;
    /// The part of a draw record that the material decides, by material.
    const std::vector<MaterialWords>& materials() const;
    /// Whether any material has Material::metallicRoughness; a scene without is drawn by pipelines that know matt surfaces alone.
    bool hasMetallicRoughness() const;
    /// Whether any material blends; a scene without is drawn without a pass for translucent surfaces.
    bool hasBlended() const;
    /// Whether shading must be told what opaque surfaces emit, and how much ambient light arrives there.
    bool hasEmission() const;
    /// Whether any material has a layer.
    bool hasLayers() const;
    /// The instances whose material blends, ascending. They are drawn after all others.
    std::span<const std::uint32_t> blended() const;
    /// The instances that do not blend, as culling reads them: made at the first call, and as they are since the last
    /// update().
    /// @threads Any number at once, for a scene that does not change.
    const visibility::InstanceCells& cells(platform::WorkerPool& workers) const;
    /// By instance.
    const std::vector<DrawSource>& sources() const;
    /// What draws have in common, by DrawSource::kind.
    const std::vector<DrawKind>& kinds() const;
    /// The coarser levels of all meshes, mesh by mesh.
    const std::vector<LevelRange>& levels() const;
    /// The indices of a mesh at a level of detail, at most MeshRange::levelCount.
    LevelRange indicesOf(const MeshRange& mesh, std::uint32_t level) const;
    /// The chunks of a large mesh itself; none of a small mesh, and of one that the device deforms.
    std::span<const visibility::MeshChunk> chunksOf(const MeshRange& mesh) const;

  private:
    class State;
    std::unique_ptr<State> m_state;
};

} // namespace cdr::render
