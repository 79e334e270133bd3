#pragma once

#include <cdr/gpu/memory.h>
#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/image/image.h>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace cdr::viewer {

/// A picture on the interface's device, replaced now and then by one from main memory.
class PictureTexture {
  public:
    /// @param slots frames in flight.
    PictureTexture(const gpu::Device& device, std::size_t slots, std::string name)
        : m_device(device),
          m_staging(slots),
          m_name(std::move(name)) {}

    /// Shown from the next frame on.
    void set(std::shared_ptr<const image::ImageRgba8> picture) { m_pending = std::move(picture); }

    /// Gives its memory back, once the device is idle.
    void forget();

    /// Makes room for what was set, if anything, and hands it over; the slot's last frame must have finished.
    /// @throws base::RunError when memory runs out. It stays set then, and nothing is shown until it fits.
    void stage(std::size_t slot);
    /// Copies what stage() handed over, if anything.
    void recordUpload(vk::CommandBuffer commands);
    /// Blits columns [left, right) of the picture, as shares of its width, into an area of a transfer
    /// destination, from its top left corner. It is filtered if the sizes differ. Nothing is blitted without a picture.
    void recordBlit(vk::CommandBuffer commands, vk::Image target, const vk::Extent2D& area, double left,
                    double right) const;

    bool isEmpty() const { return !m_image.handle(); }

  private:
    void release();

    const gpu::Device& m_device;
    std::shared_ptr<const image::ImageRgba8> m_pending;
    gpu::Image m_image;
    std::vector<gpu::Buffer> m_staging;    ///< by slot
    const gpu::Buffer* m_staged = nullptr; ///< what the next recordUpload() copies
    std::string m_name;
};

} // namespace cdr::viewer
