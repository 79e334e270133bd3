#pragma once

#include <cdr/gpu/memory.h>
#include <cdr/image/image.h>

#include <vulkan/vulkan.hpp>

#include <cstring>
#include <vector>

namespace cdr::render {

/// Copies of device images on the host, 4 bytes a pixel, reused from frame to frame.
class Readback {
  public:
    Readback(const gpu::Device& device, vk::Extent2D extent, std::size_t images);

    /// Copies an image that is in the transfer source layout into place `index`.
    void recordCopy(vk::CommandBuffer primary, const gpu::Image& image, std::size_t index) const;
    /// Lets the host see the copies; the last command of a frame.
    void recordHostBarrier(vk::CommandBuffer primary) const;

    /// The pixels of place `index` once the device has finished.
    template <typename Pixel>
    image::Raster<Pixel> fetch(std::size_t index) const {
        static_assert(sizeof(Pixel) == 4);
        image::Raster<Pixel> raster(m_extent.width, m_extent.height);
        m_buffers[index].invalidate();
        std::memcpy(raster.pixels.data(), m_buffers[index].mapped(), raster.pixels.size() * sizeof(Pixel));
        return raster;
    }

  private:
    vk::Extent2D m_extent;
    std::vector<gpu::Buffer> m_buffers;
};

} // namespace cdr::render
