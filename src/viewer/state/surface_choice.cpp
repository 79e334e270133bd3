#include "surface_choice.h"

#include <cdr/base/error.h>

#include <algorithm>
#include <array>
#include <limits>

namespace cdr::viewer {

vk::SurfaceFormatKHR chooseSurfaceFormat(std::span<const vk::SurfaceFormatKHR> offered) {
    constexpr std::array kWanted{vk::Format::eB8G8R8A8Unorm, vk::Format::eR8G8B8A8Unorm,
                                 vk::Format::eA8B8G8R8UnormPack32, vk::Format::eA2R10G10B10UnormPack32,
                                 vk::Format::eA2B10G10R10UnormPack32};
    constexpr auto kSpace = vk::ColorSpaceKHR::eSrgbNonlinear;
    for (const vk::Format wanted : kWanted) {
        if (std::ranges::find(offered, vk::SurfaceFormatKHR{wanted, kSpace}) != offered.end()) {
            return {wanted, kSpace};
        }
    }
    // Older drivers say so of a surface that takes any.
    if (offered.size() == 1 && offered.front().format == vk::Format::eUndefined) {
        return {kWanted.front(), kSpace};
    }
    throw base::RunError("the window system offers no RGBA format of 8 or 10 bits");
}

bool holdsBytes(vk::Format format) {
    return format == vk::Format::eB8G8R8A8Unorm || format == vk::Format::eR8G8B8A8Unorm ||
           format == vk::Format::eA8B8G8R8UnormPack32;
}

vk::PresentModeKHR choosePresentMode(std::span<const vk::PresentModeKHR> offered, Pace pace) {
    constexpr auto kMailbox = vk::PresentModeKHR::eMailbox;
    const bool hasMailbox = std::find(offered.begin(), offered.end(), kMailbox) != offered.end();
    return hasMailbox && pace == Pace::newest ? kMailbox : vk::PresentModeKHR::eFifo;
}

std::optional<vk::Extent2D> chooseSurfaceExtent(const vk::SurfaceCapabilitiesKHR& surface,
                                                vk::Extent2D wanted) {
    vk::Extent2D extent = surface.currentExtent;
    if (extent.width == std::numeric_limits<std::uint32_t>::max()) {
        const vk::Extent2D& least = surface.minImageExtent;
        const vk::Extent2D& most = surface.maxImageExtent;
        extent = vk::Extent2D{std::min(std::max(wanted.width, least.width), most.width),
                              std::min(std::max(wanted.height, least.height), most.height)};
    }
    return extent.width > 0 && extent.height > 0 ? std::optional(extent) : std::nullopt;
}

std::uint32_t chooseImageCount(const vk::SurfaceCapabilitiesKHR& surface) {
    const std::uint32_t count = surface.minImageCount + 1;
    return surface.maxImageCount > 0 ? std::min(count, surface.maxImageCount) : count;
}

vk::CompositeAlphaFlagBitsKHR chooseCompositeAlpha(const vk::SurfaceCapabilitiesKHR& surface) {
    using Alpha = vk::CompositeAlphaFlagBitsKHR;
    for (const Alpha alpha : {Alpha::eOpaque, Alpha::eInherit, Alpha::ePreMultiplied}) {
        if (surface.supportedCompositeAlpha & alpha) {
            return alpha;
        }
    }
    return Alpha::ePostMultiplied;
}

} // namespace cdr::viewer
