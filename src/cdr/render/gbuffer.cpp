#include <cdr/render/gbuffer.h>

#include <vulkan/vulkan_format_traits.hpp>

namespace cdr::render {

namespace {

constexpr std::array kFormats{vk::Format::eR8G8B8A8Srgb, vk::Format::eR32Uint, vk::Format::eR32Sfloat,
                              vk::Format::eR32Uint};
constexpr std::array kNames{"albedo", "normal", "ahead", "id"};

} // namespace

GBuffer::GBuffer(const gpu::Device& device, vk::Extent2D extent, const std::string& name, Views views) {
    constexpr auto kUsage = vk::ImageUsageFlagBits::eColorAttachment | vk::ImageUsageFlagBits::eSampled |
                            vk::ImageUsageFlagBits::eTransferSrc;
    for (std::size_t i = 0; i < kAttachments; ++i) {
        m_images[i] =
            gpu::Image(device,
                       {.extent = extent,
                        .format = kFormats[i],
                        .usage = kUsage,
                        .aliasFormat = views == Views::typedAndBits ? kBitsFormat : vk::Format::eUndefined},
                       name + " " + kNames[i]);
    }
}

std::vector<vk::Format> GBuffer::formats() {
    return {kFormats.begin(), kFormats.end()};
}

std::uint64_t GBuffer::predictBytes(vk::Extent2D extent) {
    return std::uint64_t{extent.width} * extent.height * 4 * kAttachments;
}

gpu::Image makeDepthBuffer(const gpu::Device& device, vk::Extent2D extent, vk::Format format,
                           const std::string& name) {
    return {device,
            {.extent = extent,
             .format = format,
             .usage = vk::ImageUsageFlagBits::eDepthStencilAttachment,
             // A stencil plane that comes along is never used, but the view must not name it.
             .aspect = vk::ImageAspectFlagBits::eDepth},
            name};
}

std::uint64_t predictDepthBytes(vk::Extent2D extent, vk::Format format) {
    return std::uint64_t{extent.width} * extent.height * vk::blockSize(format);
}

} // namespace cdr::render
