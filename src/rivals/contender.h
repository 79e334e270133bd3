#pragma once

#include <cdr/gpu/commands.h>
#include <cdr/gpu/vulkan_hpp.h>

#include <rivals/rival.h>
#include <rivals/visibility_pass.h>

#include <memory>
#include <variant>

namespace cdr::rivals {

/// Today's practice or a rival.
using Competing = std::variant<depth::Technique, Rival>;

/// Draws the ids and distances of a scene, and no more: without shading, so that what contenders cost is what they decide
/// visibility by. All draw the same lists on the same device.
/// @threads One thread at a time; those of a device take turns.
/// @lifetime The device, the scene and the workers must outlive it.
class Contender {
  public:
    /// base::InputError for a scene that has layer offsets or hides parts behind masks, which no contender knows; and for what
    /// the device cannot do.
    Contender(const gpu::Device& device, const render::DrawnScene& scene, const Competing& competing,
              vk::Extent2D extent, platform::WorkerPool& workers);

    /// Draws a frame, waits for it and leaves it on the device: what is timed.
    /// @throws base::InputError for an unusable camera or split.
    render::FrameStats draw(const scene::Camera& camera) { return run(camera, Copy::none); }

    /// Draws a frame and copies it.
    /// @throws base::InputError as draw().
    FramePixels render(const scene::Camera& camera);

    /// Of the last frame.
    std::size_t cascades() const { return m_draws.view().cascades.size(); }
    /// Of the last frame: draws per visible instance.
    double duplication() const { return m_draws.duplication(); }

  private:
    enum class Copy : std::uint8_t { none, surfaces };
    render::FrameStats run(const scene::Camera& camera, Copy copy);

    const gpu::Device& m_device;
    FrameDraws m_draws;
    std::unique_ptr<VisibilityPass> m_pass;
    gpu::CommandPool m_pool;
    vk::UniqueFence m_done;
};

} // namespace cdr::rivals
