#include <cdr/gpu/depth_attachments.h>
#include <cdr/render/octahedral.h>
#include <cdr/render/targets/gbuffer.h>

#include <glm/gtc/packing.hpp>

#include <algorithm>

namespace cdr::render {

glm::vec3 GBufferPixel::normalView() const {
    if (id() == 0) {
        return glm::vec3(0.0f);
    }
    return glm::normalize(decodeOctahedral(glm::unpackSnorm2x16(normal)));
}

gpu::ImageOptions colorOptions(vk::Extent2D extent, vk::Format format) {
    return {.extent = extent,
            .format = format,
            .usage = vk::ImageUsageFlagBits::eColorAttachment | vk::ImageUsageFlagBits::eSampled |
                     vk::ImageUsageFlagBits::eTransferSrc};
}

gpu::Image makeGBuffer(const gpu::Device& device, vk::Extent2D extent, const std::string& name,
                       vk::Format format) {
    return {device, colorOptions(extent, format), name};
}

bool isVisibilityBuffer(const gpu::Image& surfaces) {
    return surfaces.options().format == kVisibilityFormat;
}

vk::Format depthAttachmentFormat(const gpu::Device& device, depth::DepthFormat format, vk::Format surfaces) {
    const vk::Format marking = gpu::kDepthAttachments[static_cast<std::size_t>(format)].withStencil;
    const bool isAttachment(
        vk::PhysicalDevice(device.physical()).getFormatProperties(marking).optimalTilingFeatures &
        vk::FormatFeatureFlagBits::eDepthStencilAttachment);
    return surfaces == kVisibilityFormat && isAttachment ? marking : vk::Format(device.depthFormat(format));
}

bool hasStencil(vk::Format depthAttachment) {
    return std::any_of(
        gpu::kDepthAttachments.begin(), gpu::kDepthAttachments.end(),
        [&](const gpu::DepthAttachments& formats) { return formats.withStencil == depthAttachment; });
}

bool marksDrawn(vk::Format depthAttachment, vk::Format surfaces) {
    return surfaces == kVisibilityFormat && hasStencil(depthAttachment);
}

gpu::ImageOptions depthBufferOptions(const gpu::Device& device, vk::Extent2D extent,
                                     depth::DepthFormat format, vk::Format surfaces) {
    const vk::Format attachment = depthAttachmentFormat(device, format, surfaces);
    // A stencil plane that comes along and marks nothing is never used, and the view must not name it.
    const vk::ImageAspectFlags aspects =
        marksDrawn(attachment, surfaces) ? vk::ImageAspectFlagBits::eDepth | vk::ImageAspectFlagBits::eStencil
                                         : vk::ImageAspectFlags(vk::ImageAspectFlagBits::eDepth);
    return {.extent = extent,
            .format = attachment,
            .usage = vk::ImageUsageFlagBits::eDepthStencilAttachment,
            .aspect = aspects};
}

gpu::Image makeDepthBuffer(const gpu::Device& device, vk::Extent2D extent, depth::DepthFormat format,
                           const std::string& name, vk::Format surfaces) {
    return {device, depthBufferOptions(device, extent, format, surfaces), name};
}

std::uint64_t predictLayerBytes(const gpu::Device& device, vk::Extent2D extent,
                                depth::DepthFormat depthFormat, vk::Format format) {
    return gpu::predictBytes(device, colorOptions(extent, format)) +
           gpu::predictBytes(device, depthBufferOptions(device, extent, depthFormat, format));
}

} // namespace cdr::render
