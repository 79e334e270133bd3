#pragma once

#include <cdr/render/upload/device_deformer.h>
#include <cdr/render/upload/last_vertices.h>
#include <cdr/render/upload/scene_meshes.h>
#include <cdr/scene/world/world.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

namespace cdr::render {

/// Brings the vertices on the device to those of a world: uploads what the CPU deformed, and has the device deform the rest.
class VertexUpdates {
  public:
    explicit VertexUpdates(const gpu::Device& device) : m_device(device) {}

    /// What is brought up to date.
    struct Into {
        SceneMeshes& meshes;
        gpu::Retired& retired;        ///< gets the deformers of meshes that have no pose any more
        LastVertices* last = nullptr; ///< gets the vertices before this; null: nobody reads them
    };
    /// Follows meshes that have other vertices, as many as before. Waits where some are uploaded.
    /// @param changed meshes, repeats allowed; their draw kinds are to be read again, as for SceneMeshes::followVertices()
    /// base::InputError and base::RunError where the device cannot deform a mesh that has a pose.
    void follow(const scene::World& world, std::span<const std::uint32_t> changed, const Into& into);
    /// Meshes that were added, replaced or removed; nothing: any may have been.
    void forget(const std::optional<std::span<const std::uint32_t>>& meshes, gpu::Retired& retired);

  private:
    const gpu::Device& m_device;
    std::unique_ptr<DeviceDeformer> m_deformer; ///< once a mesh has a pose
};

} // namespace cdr::render
