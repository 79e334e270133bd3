#include <cdr/render/targets/gbuffer.h>

#include <vulkan/vulkan_format_traits.hpp>

namespace cdr::render {

gpu::Image makeGBuffer(const gpu::Device& device, vk::Extent2D extent, const std::string& name) {
    return {device,
            {.extent = extent,
             .format = kGBufferFormat,
             .usage = vk::ImageUsageFlagBits::eColorAttachment | vk::ImageUsageFlagBits::eSampled |
                      vk::ImageUsageFlagBits::eTransferSrc},
            name};
}

std::uint64_t predictGBufferBytes(vk::Extent2D extent) {
    return std::uint64_t{extent.width} * extent.height * sizeof(GBufferPixel);
}

gpu::Image makeDepthBuffer(const gpu::Device& device, vk::Extent2D extent, depth::DepthFormat format,
                           const std::string& name) {
    return {device,
            {.extent = extent,
             .format = device.depthFormat(format),
             .usage = vk::ImageUsageFlagBits::eDepthStencilAttachment,
             // A stencil plane that comes along is never used, but the view must not name it.
             .aspect = vk::ImageAspectFlagBits::eDepth},
            name};
}

std::uint64_t predictDepthBytes(vk::Extent2D extent, depth::DepthFormat format) {
    return std::uint64_t{extent.width} * extent.height * (traitsOf(format).bits > 16 ? 4 : 2);
}

} // namespace cdr::render
