#pragma once

#include <cdr/base/export.h>
#include <cdr/gpu/device.h>
#include <cdr/scene/world/world.h>

#include <cstddef>
#include <cstdint>
#include <memory>

namespace cdr::render {

class UploadedScene;

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
    /// number of changed instances on average, or of all where one that blends came or went. What is uploaded, meshes, vertices and
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

    /// What passes read, for the renderer's own use.
    const UploadedScene& uploaded() const { return *m_uploaded; }

  private:
    std::unique_ptr<UploadedScene> m_uploaded;
};

} // namespace cdr::render
