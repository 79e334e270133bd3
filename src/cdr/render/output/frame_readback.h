#pragma once

#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/render/frame.h>
#include <cdr/render/output/readback.h>
#include <cdr/render/render_options.h>

#include <optional>

namespace cdr::render {

/// Copies of a frame's images in main memory.
class FrameReadback {
  public:
    /// What is copied.
    struct Images {
        const gpu::Image& color;      ///< in the transfer source layout
        const gpu::Image& gbuffer;    ///< that fragment shaders read
        const gpu::Image* linear;     ///< in the transfer source layout; null where it is not kept
        const gpu::Image* motion;     ///< in the transfer source layout; null without motion
        const gpu::Image* shadowMask; ///< that fragment shaders read; null without shadows
    };

    FrameReadback(const gpu::Device& device, vk::Extent2D extent, const RenderOptions& options);

    /// Device bytes that it takes: none where main memory is not the device's.
    static std::uint64_t predictBytes(const gpu::Device& device, vk::Extent2D extent,
                                      const RenderOptions& options);

    /// Copies the picture, or all. Afterwards the images that are copied are in the transfer source layout.
    void record(vk::CommandBuffer primary, const Images& images, FrameCopy copy) const;

    /// The images of a frame, once the device has finished: those that record() copied for it.
    void fetch(FrameCopy copy, Frame& frame) const;

  private:
    Readback m_color;
    Readback m_gbuffer;
    std::optional<Readback> m_linear;
    std::optional<Readback> m_motion;
    std::optional<Readback> m_shadowMask;
};

} // namespace cdr::render
