#pragma once

#include <cdr/gpu/device.h>

#include <vulkan/vulkan.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace cdr::viewer {

/// The images a window shows in turn, and what drawing into them needs.
class Swapchain {
  public:
    /// @param wanted pixels, above 0x0; the surface may insist on others.
    /// @param waitsForDisplay shows frames one by one at the display's pace (FIFO); else the newest wins
    /// (mailbox), where the surface can.
    /// @param old the swapchain it takes the place of, or null.
    Swapchain(const gpu::Device& device, vk::SurfaceKHR surface, vk::Extent2D wanted, bool waitsForDisplay,
              const Swapchain* old);

    struct Image {
        vk::Image image;
        vk::UniqueImageView view;
        vk::UniqueSemaphore drawn; ///< signalled when it may be presented
        vk::UniqueFramebuffer framebuffer;
    };

    /// The next image to draw into, `ready` signalled once it is free. Empty when the surface has changed and
    /// a new swapchain is due. vk::DeviceLostError passes through.
    std::optional<std::uint32_t> acquire(vk::Semaphore ready);
    /// Shows an image. False when a new swapchain is due.
    bool present(vk::Queue queue, std::uint32_t image);

    /// Draws over what transfers have put into an image, and leaves it ready to present.
    vk::RenderPass renderPass() const { return *m_renderPass; }
    const Image& image(std::uint32_t index) const { return m_images[index]; }
    std::uint32_t imageCount() const { return static_cast<std::uint32_t>(m_images.size()); }
    vk::Extent2D extent() const { return m_extent; }
    vk::Format format() const { return m_format; }
    vk::PresentModeKHR presentMode() const { return m_presentMode; }
    /// Whether its images can be read back.
    bool isReadable() const { return m_isReadable; }

  private:
    void makeImages();

    vk::Device m_device;
    vk::Extent2D m_extent;
    vk::Format m_format = vk::Format::eUndefined;
    vk::PresentModeKHR m_presentMode = vk::PresentModeKHR::eFifo;
    bool m_isReadable = false;
    bool m_isSuboptimal = false;
    vk::UniqueRenderPass m_renderPass;
    vk::UniqueSwapchainKHR m_swapchain;
    std::vector<Image> m_images;
};

} // namespace cdr::viewer
