#pragma once

#include <cdr/gpu/memory.h>
#include <cdr/gpu/retired.h>
#include <cdr/render/draw_source.h>
#include <cdr/scene/scene.h>
#include <cdr/visibility/mesh_chunks.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <vector>

namespace cdr::render {

/// Whether triangles of vertices are facets: of one colour, and of one normal, which is their own.
/// @param indices three per triangle
bool areFaceted(std::span<const scene::Vertex> vertices, std::span<const std::uint32_t> indices);

/// A scene's meshes on a device: all vertices in one buffer, all indices in another.
class SceneMeshes {
  public:
    explicit SceneMeshes(const gpu::Device& device) : m_device(device) {}

    /// Uploads all, and waits.
    /// @throws base::InputError for a mesh of more vertices than the device's draws can name.
    /// @throws base::RunError, with both figures, for more vertices or indices than a buffer of the device holds.
    void upload(const scene::Scene& scene);

    /// Follows meshes that came, went or are others now, and waits for what it uploads. Takes time by the size of those that
    /// changed: they go behind those that are there, where nothing that was submitted reads. Where they find no room, all
    /// are uploaded again into twice the room that they need, as far as the device has it.
    /// @param changed places, repeats allowed; nothing where all may have changed.
    /// @return whether all were uploaded again: each mesh has the scene's vertices then.
    /// Errors as of upload(), and base::RunError when the device's memory does not suffice.
    bool follow(const scene::Scene& scene, std::optional<std::span<const std::uint32_t>> changed,
                gpu::Retired& retired);

    /// Follows meshes that have other vertices, as many as before, and waits. Nothing that was submitted may still read
    /// the vertices. Draw kinds may say something else of these meshes then: whether they are faceted, which takes another
    /// pipeline, or closed.
    /// @param changed meshes, repeats allowed
    void followVertices(const scene::Scene& scene, std::span<const std::uint32_t> changed);

    /// The device gives a mesh its vertices. Draw kinds may say something else of it, as for followVertices(), and that it has no
    /// chunks now.
    void followPose(std::uint32_t mesh, bool isFaceted);

    /// Uploads what vertices have beside themselves, or drops it, where materials now need it or do so no more; then waits.
    void followDetails(const scene::Scene& scene, gpu::Retired& retired);

    const gpu::Buffer& vertices() const { return m_vertices; }
    /// PackedDetails, one per vertex; empty where no material has detail.
    const gpu::Buffer& details() const { return m_details; }
    const gpu::Buffer& indices() const { return m_indices; }
    /// By mesh of the scene.
    const std::vector<MeshRange>& ranges() const { return m_ranges; }
    /// The coarser levels of each mesh, one after another.
    const std::vector<LevelRange>& levels() const { return m_levels; }
    /// The chunks of each large mesh, one after another.
    const std::vector<visibility::MeshChunk>& chunks() const { return m_chunks; }

    /// Device memory that upload() takes.
    static std::uint64_t predictBytes(const scene::Scene& scene);

  private:
    /// Those of coarser levels and of clusters among them.
    struct Counts {
        std::size_t vertices = 0;
        std::size_t indices = 0;
    };
    struct Packed;
    /// The most for which the device has buffers, and draws have numbers.
    Counts most() const;
    /// base::RunError, with both figures, where the scene has more.
    void requireRoom(const scene::Scene& scene) const;
    /// base::InputError for a mesh of more vertices than draws can name.
    void requireIndices(const scene::Scene& scene, std::uint32_t mesh) const;
    void requireIndices(const scene::Scene& scene) const;
    static Counts countsOf(const scene::Mesh& mesh);
    static Counts countsOf(const scene::Scene& scene);
    void upload(const scene::Scene& scene, const Counts& room);
    /// Whether there was room.
    bool append(const scene::Scene& scene, const std::set<std::uint32_t>& changed);
    /// Puts a mesh behind what is used.
    MeshRange place(const scene::Mesh& mesh, Packed& into);
    /// @param room vertices that they are for
    void uploadDetails(const scene::Scene& scene, std::size_t room);

    const gpu::Device& m_device;
    gpu::Buffer m_vertices;
    gpu::Buffer m_details;
    gpu::Buffer m_indices;
    std::optional<Counts> m_room; ///< none where an upload ended early
    Counts m_used;                ///< of it, from the start on; what meshes that went have left is among it
    std::vector<MeshRange> m_ranges;
    std::vector<LevelRange> m_levels;
    std::vector<visibility::MeshChunk> m_chunks;
};

} // namespace cdr::render
