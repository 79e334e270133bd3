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

    /// Copies what was set, if anything; the slot's last frame must have finished.
    void recordUpload(vk::CommandBuffer commands, std::size_t slot);
    /// Blits columns [left, right) of the picture, as shares of its width, into an area of a transfer
    /// destination, from its top left corner. It is filtered if the sizes differ. Nothing is blitted without a picture.
    void recordBlit(vk::CommandBuffer commands, vk::Image target, const vk::Extent2D& area, double left,
                    double right) const;

    bool isEmpty() const { return !m_image.handle(); }

  private:
    const gpu::Device& m_device;
    std::shared_ptr<const image::ImageRgba8> m_pending;
    gpu::Image m_image;
    std::vector<gpu::Buffer> m_staging; ///< by slot
    std::string m_name;
};

} // namespace cdr::viewer
