#pragma once

#include <cdr/gpu/vulkan_hpp.h>

#include <cstdint>
#include <optional>
#include <span>

namespace cdr::viewer {

/// 8 bits a channel and no conversion on writing, since pictures and interface bring sRGB values of their
/// own. 10 bits where there is nothing else. base::RunError when none is offered.
vk::SurfaceFormatKHR chooseSurfaceFormat(std::span<const vk::SurfaceFormatKHR> offered);

/// Whether a pixel of such a format is four bytes, blue or red first.
bool holdsBytes(vk::Format format);

/// When frames are shown.
enum class Pace : std::uint8_t {
    newest,  ///< as they come: the newest picture wins (mailbox), where the surface has that
    display, ///< at the display's pace (FIFO)
};

/// Mailbox or FIFO, which every surface has.
vk::PresentModeKHR choosePresentMode(std::span<const vk::PresentModeKHR> offered, Pace pace);

/// What a swapchain's images must measure: what the surface insists on, or `wanted` within its limits where
/// it leaves the choice (Wayland does). Empty while it can have none, as some systems have it of a minimised
/// window.
std::optional<vk::Extent2D> chooseSurfaceExtent(const vk::SurfaceCapabilitiesKHR& surface,
                                                vk::Extent2D wanted);

/// One more than the least, so that drawing does not wait for the display to let go of its image, within the
/// surface's limit.
std::uint32_t chooseImageCount(const vk::SurfaceCapabilitiesKHR& surface);

/// Opaque where the surface can; else the first thing it can.
vk::CompositeAlphaFlagBitsKHR chooseCompositeAlpha(const vk::SurfaceCapabilitiesKHR& surface);

} // namespace cdr::viewer
