#pragma once

#include <cdr/gpu/device.h>
#include <cdr/gpu/vulkan_hpp.h>
#include <viewer/state/surface_choice.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace cdr::viewer {

/// What a window system said last of the surface that a swapchain was made for.
enum class SwapchainState : std::uint8_t {
    fits,
    suboptimal, ///< shows what is drawn, but perhaps scaled
    outOfDate,  ///< a new swapchain is due
    lost,       ///< a new surface is due too
};

/// What a swapchain is made for.
struct SwapchainOptions {
    vk::SurfaceKHR surface;
    vk::SurfaceFormatKHR format;
    vk::RenderPass renderPass; ///< framebuffers are for
    vk::Extent2D wanted;       ///< pixels; the surface may insist on others
    Pace pace = Pace::newest;
};

/// The images a window shows in turn.
class Swapchain {
  public:
    /// @param old the swapchain it takes the place of, or null. It is of no use afterwards, even if this
    /// fails. vk::OutOfDateKHRError when the surface has no pixels or changes meanwhile.
    Swapchain(const gpu::Device& device, const SwapchainOptions& options, const Swapchain* old);

    struct Image {
        vk::Image image;
        vk::UniqueImageView view;
        vk::UniqueSemaphore drawn; ///< signalled when it may be presented
        vk::UniqueFramebuffer framebuffer;
    };

    /// The next image to draw into, `ready` signalled once it is free. Empty when the surface is out of date
    /// or lost. vk::DeviceLostError passes through.
    std::optional<std::uint32_t> acquire(vk::Semaphore ready);
    /// Shows an image, if the surface is still what it was.
    void present(vk::Queue queue, std::uint32_t image);
    SwapchainState state() const { return m_state; }
    /// Whether a swapchain made now would be another one.
    bool isOutgrown(const gpu::Device& device, vk::SurfaceKHR surface, vk::Extent2D wanted) const;

    const Image& image(std::uint32_t index) const { return m_images[index]; }
    vk::Extent2D extent() const { return m_extent; }
    vk::Format format() const { return m_format; }
    /// Whether its images can be read back.
    bool isReadable() const { return m_isReadable; }

  private:
    void makeImages(vk::RenderPass renderPass);
    /// Keeps the worst news; what is no news is thrown.
    void note(vk::Result result, const char* call);

    vk::Device m_device;
    vk::Extent2D m_extent;
    vk::Format m_format;
    vk::SurfaceTransformFlagBitsKHR m_transform{};
    bool m_isReadable = false;
    SwapchainState m_state = SwapchainState::fits;
    vk::UniqueSwapchainKHR m_swapchain;
    std::vector<Image> m_images;
};

/// Draws over what transfers have put into a swapchain's image, and leaves it ready to present.
vk::UniqueRenderPass makeWindowPass(vk::Device device, vk::Format format);

} // namespace cdr::viewer
