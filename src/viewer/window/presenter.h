#pragma once

#include "picture_texture.h"
#include "swapchain.h"
#include "ui_device.h"

#include <cdr/gpu/commands.h>
#include <cdr/image/image.h>

#include <array>
#include <memory>

struct ImDrawData;

namespace cdr::viewer {

/// Where pictures go in the window.
struct PictureLayout {
    vk::Extent2D extent;      ///< pixels of the window, from its top left corner
    double divider = 1.0;     ///< share of this width that the left picture has
    std::size_t pictures = 1; ///< 1: the left one alone
};

/// Puts pictures and interface on the window's screen, two frames in flight.
class Presenter {
  public:
    static constexpr std::size_t kFramesInFlight = 2;

    Presenter(UiDevice& ui, const Window& window, Pace pace);
    ~Presenter();
    Presenter(const Presenter&) = delete;
    Presenter& operator=(const Presenter&) = delete;

    /// The left (0) or right (1) picture.
    PictureTexture& picture(std::size_t side) { return *m_pictures[side]; }

    /// Draws a frame and shows it. False when it does not show: the window has no pixels, or changed.
    /// @param capture receives the window's pixels when not null; base::RunError where they cannot be read.
    bool draw(const PictureLayout& layout, ImDrawData* interface, image::ImageRgba8* capture);

    /// Whether the window's pixels can be read.
    bool isReadable() const { return m_swapchain == nullptr || m_swapchain->isReadable(); }
    /// What the interface is drawn in.
    vk::RenderPass renderPass() const { return *m_renderPass; }

  private:
    struct Slot {
        std::unique_ptr<gpu::CommandPool> pool;
        vk::UniqueFence done;
        vk::UniqueSemaphore imageReady;
    };
    /// Whether the swapchain is no longer the window's.
    bool isStale() const;
    /// Makes a swapchain; false when the window cannot have one now.
    bool renew();
    /// base::RunError when it happens again and again.
    void loseSurface();
    void waitFor(const Slot& slot) const;
    void record(vk::CommandBuffer commands, const Swapchain::Image& target, const PictureLayout& layout,
                ImDrawData* interface);
    void submit(vk::CommandBuffer commands, const Slot& slot, const Swapchain::Image& target) const;

    UiDevice& m_ui;
    const gpu::Device& m_device;
    const Window& m_window;
    Pace m_pace;
    std::array<std::unique_ptr<PictureTexture>, 2> m_pictures;
    std::array<Slot, kFramesInFlight> m_slots;
    std::size_t m_frames = 0;
    vk::SurfaceFormatKHR m_format;
    vk::UniqueRenderPass m_renderPass;
    std::unique_ptr<Swapchain> m_swapchain; ///< none while the window can have none
    vk::Extent2D m_wanted;                  ///< that the swapchain was made for
    bool m_isSurfaceLost = false;
    int m_surfacesLost = 0; ///< since a frame was shown
};

} // namespace cdr::viewer
