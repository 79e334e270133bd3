#include "swapchain.h"

#include <cdr/base/error.h>
#include <cdr/gpu/functions.h>
#include <viewer/state/surface_choice.h>

#include <algorithm>
#include <array>
#include <limits>

namespace cdr::viewer {

Swapchain::Swapchain(const gpu::Device& device, const SwapchainOptions& options, const Swapchain* old)
    : m_device(device.handle()),
      m_format(options.format.format) {
    const vk::PhysicalDevice physical = device.physical();
    const vk::SurfaceCapabilitiesKHR surface = physical.getSurfaceCapabilitiesKHR(options.surface);
    const auto extent = chooseSurfaceExtent(surface, options.wanted);
    if (!extent) {
        throw vk::OutOfDateKHRError("the window has no pixels");
    }
    m_extent = *extent;
    m_transform = surface.currentTransform;
    using Usage = vk::ImageUsageFlagBits;
    if (!(surface.supportedUsageFlags & Usage::eTransferDst)) {
        throw base::RunError("the window system's images cannot be copied to");
    }
    m_isReadable = holdsBytes(m_format) && (surface.supportedUsageFlags & Usage::eTransferSrc);
    m_swapchain = m_device.createSwapchainKHRUnique(
        {.surface = options.surface,
         .minImageCount = chooseImageCount(surface),
         .imageFormat = options.format.format,
         .imageColorSpace = options.format.colorSpace,
         .imageExtent = m_extent,
         .imageArrayLayers = 1,
         .imageUsage = Usage::eColorAttachment | Usage::eTransferDst |
                       (m_isReadable ? Usage::eTransferSrc : vk::ImageUsageFlags()),
         .imageSharingMode = vk::SharingMode::eExclusive,
         .preTransform = m_transform,
         .compositeAlpha = chooseCompositeAlpha(surface),
         .presentMode = choosePresentMode(physical.getSurfacePresentModesKHR(options.surface), options.pace),
         .clipped = VK_TRUE,
         .oldSwapchain = old != nullptr ? *old->m_swapchain : vk::SwapchainKHR()});
    makeImages(options.renderPass);
}

void Swapchain::makeImages(vk::RenderPass renderPass) {
    for (const vk::Image image : m_device.getSwapchainImagesKHR(*m_swapchain)) {
        Image made{.image = image,
                   .view = m_device.createImageViewUnique(
                       {.image = image,
                        .viewType = vk::ImageViewType::e2D,
                        .format = m_format,
                        .subresourceRange = {vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1}}),
                   .drawn = m_device.createSemaphoreUnique({}),
                   .framebuffer = {}};
        made.framebuffer = m_device.createFramebufferUnique({.renderPass = renderPass,
                                                             .attachmentCount = 1,
                                                             .pAttachments = &*made.view,
                                                             .width = m_extent.width,
                                                             .height = m_extent.height,
                                                             .layers = 1});
        m_images.push_back(std::move(made));
    }
}

void Swapchain::note(vk::Result result, const char* call) {
    switch (result) {
    case vk::Result::eSuccess:
        break;
    case vk::Result::eSuboptimalKHR:
        m_state = std::max(m_state, SwapchainState::suboptimal);
        break;
    case vk::Result::eErrorOutOfDateKHR:
        m_state = std::max(m_state, SwapchainState::outOfDate);
        break;
    case vk::Result::eErrorSurfaceLostKHR:
        m_state = SwapchainState::lost;
        break;
    default:
        vk::resultCheck(result, call);
    }
}

std::optional<std::uint32_t> Swapchain::acquire(vk::Semaphore ready) {
    // The C call, since out of date is no error here.
    std::uint32_t index = 0;
    const auto result = static_cast<vk::Result>(gpu::functions().vkAcquireNextImageKHR(
        m_device, *m_swapchain, std::numeric_limits<std::uint64_t>::max(), ready, VK_NULL_HANDLE, &index));
    note(result, "vkAcquireNextImageKHR");
    const bool hasImage = result == vk::Result::eSuccess || result == vk::Result::eSuboptimalKHR;
    return hasImage ? std::optional(index) : std::nullopt;
}

void Swapchain::present(vk::Queue queue, std::uint32_t image) {
    const vk::PresentInfoKHR info{.waitSemaphoreCount = 1,
                                  .pWaitSemaphores = &*m_images[image].drawn,
                                  .swapchainCount = 1,
                                  .pSwapchains = &*m_swapchain,
                                  .pImageIndices = &image};
    note(static_cast<vk::Result>(
             gpu::functions().vkQueuePresentKHR(queue, &static_cast<const VkPresentInfoKHR&>(info))),
         "vkQueuePresentKHR");
}

bool Swapchain::isOutgrown(const gpu::Device& device, vk::SurfaceKHR surface, vk::Extent2D wanted) const {
    try {
        const vk::SurfaceCapabilitiesKHR now =
            vk::PhysicalDevice(device.physical()).getSurfaceCapabilitiesKHR(surface);
        return chooseSurfaceExtent(now, wanted) != m_extent || now.currentTransform != m_transform;
    } catch (const vk::SurfaceLostKHRError&) {
        return true; // making the next one reports it
    }
}

vk::UniqueRenderPass makeWindowPass(vk::Device device, vk::Format format) {
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

} // namespace cdr::viewer
