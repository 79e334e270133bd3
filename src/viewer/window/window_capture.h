#pragma once

#include "swapchain.h"

#include <cdr/gpu/memory.h>
#include <cdr/image/image.h>

namespace cdr::viewer {

/// Reads one frame of a window back.
class WindowCapture {
  public:
    /// base::RunError when the window system does not let its images be read.
    WindowCapture(const gpu::Device& device, const Swapchain& swapchain);

    /// Copies an image that is ready to present, and leaves it so.
    void record(vk::CommandBuffer commands, vk::Image image) const;
    /// The pixels, opaque, once the device has finished.
    image::ImageRgba8 fetch() const;

  private:
    vk::Extent2D m_extent;
    bool m_isBgra;
    gpu::Buffer m_buffer;
};

} // namespace cdr::viewer
