#include <cdr/render/octahedral.h>
#include <cdr/render/targets/gbuffer.h>

#include <glm/gtc/packing.hpp>

namespace cdr::render {

glm::vec3 GBufferPixel::normalView() const {
    if (id() == 0) {
        return glm::vec3(0.0f);
    }
    return glm::normalize(decodeOctahedral(glm::unpackSnorm2x16(normal)));
}

gpu::ImageOptions gbufferOptions(vk::Extent2D extent, vk::Format format) {
    return {.extent = extent,
            .format = format,
            .usage = vk::ImageUsageFlagBits::eColorAttachment | vk::ImageUsageFlagBits::eSampled |
                     vk::ImageUsageFlagBits::eTransferSrc};
}

gpu::Image makeGBuffer(const gpu::Device& device, vk::Extent2D extent, const std::string& name,
                       vk::Format format) {
    return {device, gbufferOptions(extent, format), name};
}

gpu::ImageOptions depthBufferOptions(const gpu::Device& device, vk::Extent2D extent,
                                     depth::DepthFormat format) {
    return {.extent = extent,
            .format = device.depthFormat(format),
            .usage = vk::ImageUsageFlagBits::eDepthStencilAttachment,
            // A stencil plane that comes along is never used, but the view must not name it.
            .aspect = vk::ImageAspectFlagBits::eDepth};
}

gpu::Image makeDepthBuffer(const gpu::Device& device, vk::Extent2D extent, depth::DepthFormat format,
                           const std::string& name) {
    return {device, depthBufferOptions(device, extent, format), name};
}

std::uint64_t predictLayerBytes(const gpu::Device& device, vk::Extent2D extent,
                                depth::DepthFormat depthFormat, vk::Format format) {
    return gpu::predictBytes(device, gbufferOptions(extent, format)) +
           gpu::predictBytes(device, depthBufferOptions(device, extent, depthFormat));
}

} // namespace cdr::render
