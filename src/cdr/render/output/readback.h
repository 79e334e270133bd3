#pragma once

#include <cdr/gpu/memory.h>
#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/image/image.h>

#include <cstring>
#include <string>

namespace cdr::render {

/// A copy of a device image in main memory, reused from frame to frame.
class Readback {
  public:
    Readback(const gpu::Device& device, vk::Extent2D extent, std::size_t bytesPerPixel,
             const std::string& name);

    /// Device bytes that it takes: none where main memory is not the device's.
    static std::uint64_t predictBytes(const gpu::Device& device, vk::Extent2D extent,
                                      std::size_t bytesPerPixel);

    /// Copies an image that is in the transfer source layout.
    void record(vk::CommandBuffer primary, const gpu::Image& image) const;

    /// The pixels once the device has finished. Pixel must have the size given at construction.
    template <typename Pixel>
    image::Raster<Pixel> fetch() const {
        image::Raster<Pixel> raster(m_extent.width, m_extent.height);
        m_buffer.invalidate();
        std::memcpy(raster.pixels.data(), m_buffer.mapped(), raster.pixels.size() * sizeof(Pixel));
        return raster;
    }

  private:
    vk::Extent2D m_extent;
    gpu::Buffer m_buffer;
};

/// Lets the host see copies; the last command of a frame.
void recordHostBarrier(vk::CommandBuffer primary);

} // namespace cdr::render
