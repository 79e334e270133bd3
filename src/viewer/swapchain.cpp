#include "swapchain.h"

#include <cdr/base/error.h>

#include <algorithm>
#include <array>
#include <limits>

namespace cdr::viewer {

namespace {

/// 8 bits a channel and no conversion on writing: pictures and interface bring sRGB values of their own.
vk::SurfaceFormatKHR chooseFormat(const std::vector<vk::SurfaceFormatKHR>& offered) {
    constexpr std::array kWanted{vk::Format::eB8G8R8A8Unorm, vk::Format::eR8G8B8A8Unorm};
    for (const vk::Format wanted : kWanted) {
        for (const vk::SurfaceFormatKHR& format : offered) {
            if (format.format == wanted && format.colorSpace == vk::ColorSpaceKHR::eSrgbNonlinear) {
                return format;
            }
        }
    }
    throw base::RunError("the window system offers no 8-bit RGBA format");
}

vk::PresentModeKHR chooseMode(const std::vector<vk::PresentModeKHR>& offered, bool waitsForDisplay) {
    const auto has = [&](vk::PresentModeKHR mode) {
        return std::find(offered.begin(), offered.end(), mode) != offered.end();
    };
    if (!waitsForDisplay && has(vk::PresentModeKHR::eMailbox)) {
        return vk::PresentModeKHR::eMailbox;
    }
    return vk::PresentModeKHR::eFifo; // every surface has it
}

vk::Extent2D chooseExtent(const vk::SurfaceCapabilitiesKHR& surface, vk::Extent2D wanted) {
    if (surface.currentExtent.width != std::numeric_limits<std::uint32_t>::max()) {
        return surface.currentExtent;
    }
    return {std::clamp(wanted.width, surface.minImageExtent.width, surface.maxImageExtent.width),
            std::clamp(wanted.height, surface.minImageExtent.height, surface.maxImageExtent.height)};
}

vk::UniqueRenderPass makeRenderPass(vk::Device device, vk::Format format) {
    const vk::AttachmentDescription color{.format = format,
                                          .samples = vk::SampleCountFlagBits::e1,
                                          .loadOp = vk::AttachmentLoadOp::eLoad,
                                          .storeOp = vk::AttachmentStoreOp::eStore,
                                          .stencilLoadOp = vk::AttachmentLoadOp::eDontCare,
                                          .stencilStoreOp = vk::AttachmentStoreOp::eDontCare,
                                          .initialLayout = vk::ImageLayout::eTransferDstOptimal,
                                          .finalLayout = vk::ImageLayout::ePresentSrcKHR};
    const vk::AttachmentReference reference{0, vk::ImageLayout::eColorAttachmentOptimal};
    const vk::SubpassDescription subpass{.pipelineBindPoint = vk::PipelineBindPoint::eGraphics,
                                         .colorAttachmentCount = 1,
                                         .pColorAttachments = &reference};
    const std::array dependencies{
        vk::SubpassDependency{.srcSubpass = VK_SUBPASS_EXTERNAL,
                              .dstSubpass = 0,
                              .srcStageMask = vk::PipelineStageFlagBits::eTransfer,
                              .dstStageMask = vk::PipelineStageFlagBits::eColorAttachmentOutput,
                              .srcAccessMask = vk::AccessFlagBits::eTransferWrite,
                              .dstAccessMask = vk::AccessFlagBits::eColorAttachmentRead |
                                               vk::AccessFlagBits::eColorAttachmentWrite},
        vk::SubpassDependency{.srcSubpass = 0,
                              .dstSubpass = VK_SUBPASS_EXTERNAL,
                              .srcStageMask = vk::PipelineStageFlagBits::eColorAttachmentOutput,
                              .dstStageMask = vk::PipelineStageFlagBits::eTransfer,
                              .srcAccessMask = vk::AccessFlagBits::eColorAttachmentWrite,
                              .dstAccessMask = vk::AccessFlagBits::eTransferRead}};
    return device.createRenderPassUnique({.attachmentCount = 1,
                                          .pAttachments = &color,
                                          .subpassCount = 1,
                                          .pSubpasses = &subpass,
                                          .dependencyCount = dependencies.size(),
                                          .pDependencies = dependencies.data()});
}

} // namespace

Swapchain::Swapchain(const gpu::Device& device, vk::SurfaceKHR surface, vk::Extent2D wanted,
                     bool waitsForDisplay, const Swapchain* old)
    : m_device(device.handle()) {
    const vk::PhysicalDevice physical = device.physical();
    const vk::SurfaceCapabilitiesKHR capabilities = physical.getSurfaceCapabilitiesKHR(surface);
    const vk::SurfaceFormatKHR format = chooseFormat(physical.getSurfaceFormatsKHR(surface));
    m_format = format.format;
    m_presentMode = chooseMode(physical.getSurfacePresentModesKHR(surface), waitsForDisplay);
    m_extent = chooseExtent(capabilities, wanted);
    if (!(capabilities.supportedUsageFlags & vk::ImageUsageFlagBits::eTransferDst)) {
        throw base::RunError("the window system's images cannot be copied to");
    }
    m_isReadable = static_cast<bool>(capabilities.supportedUsageFlags & vk::ImageUsageFlagBits::eTransferSrc);
    vk::ImageUsageFlags usage =
        vk::ImageUsageFlagBits::eColorAttachment | vk::ImageUsageFlagBits::eTransferDst;
    if (m_isReadable) {
        usage |= vk::ImageUsageFlagBits::eTransferSrc;
    }
    // One more than the least, so that drawing does not wait for the display to let go of its image.
    std::uint32_t count = capabilities.minImageCount + 1;
    if (capabilities.maxImageCount > 0) {
        count = std::min(count, capabilities.maxImageCount);
    }
    const bool isOpaque =
        static_cast<bool>(capabilities.supportedCompositeAlpha & vk::CompositeAlphaFlagBitsKHR::eOpaque);
    m_swapchain = m_device.createSwapchainKHRUnique(
        {.surface = surface,
         .minImageCount = count,
         .imageFormat = format.format,
         .imageColorSpace = format.colorSpace,
         .imageExtent = m_extent,
         .imageArrayLayers = 1,
         .imageUsage = usage,
         .imageSharingMode = vk::SharingMode::eExclusive,
         .preTransform = capabilities.currentTransform,
         .compositeAlpha =
             isOpaque ? vk::CompositeAlphaFlagBitsKHR::eOpaque : vk::CompositeAlphaFlagBitsKHR::eInherit,
         .presentMode = m_presentMode,
         .clipped = VK_TRUE,
         .oldSwapchain = old != nullptr ? *old->m_swapchain : vk::SwapchainKHR()});
    m_renderPass = makeRenderPass(m_device, m_format);
    makeImages();
}

void Swapchain::makeImages() {
    for (const vk::Image image : m_device.getSwapchainImagesKHR(*m_swapchain)) {
        Image made{.image = image,
                   .view = m_device.createImageViewUnique(
                       {.image = image,
                        .viewType = vk::ImageViewType::e2D,
                        .format = m_format,
                        .subresourceRange = {vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1}}),
                   .drawn = m_device.createSemaphoreUnique({}),
                   .framebuffer = {}};
        made.framebuffer = m_device.createFramebufferUnique({.renderPass = *m_renderPass,
                                                             .attachmentCount = 1,
                                                             .pAttachments = &*made.view,
                                                             .width = m_extent.width,
                                                             .height = m_extent.height,
                                                             .layers = 1});
        m_images.push_back(std::move(made));
    }
}

std::optional<std::uint32_t> Swapchain::acquire(vk::Semaphore ready) {
    // The C call, since out of date is no error here.
    std::uint32_t index = 0;
    const auto result = static_cast<vk::Result>(vkAcquireNextImageKHR(
        m_device, *m_swapchain, std::numeric_limits<std::uint64_t>::max(), ready, VK_NULL_HANDLE, &index));
    if (result == vk::Result::eErrorOutOfDateKHR) {
        return std::nullopt;
    }
    if (result == vk::Result::eSuboptimalKHR) {
        m_isSuboptimal = true; // drawn once more, then replaced
        return index;
    }
    vk::resultCheck(result, "vkAcquireNextImageKHR");
    return index;
}

bool Swapchain::present(vk::Queue queue, std::uint32_t image) {
    const vk::PresentInfoKHR info{.waitSemaphoreCount = 1,
                                  .pWaitSemaphores = &*m_images[image].drawn,
                                  .swapchainCount = 1,
                                  .pSwapchains = &*m_swapchain,
                                  .pImageIndices = &image};
    const auto result =
        static_cast<vk::Result>(vkQueuePresentKHR(queue, &static_cast<const VkPresentInfoKHR&>(info)));
    if (result == vk::Result::eErrorOutOfDateKHR || result == vk::Result::eSuboptimalKHR) {
        return false;
    }
    vk::resultCheck(result, "vkQueuePresentKHR");
    return !m_isSuboptimal;
}

} // namespace cdr::viewer
