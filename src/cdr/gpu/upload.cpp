#include <cdr/gpu/commands.h>
#include <cdr/gpu/upload.h>

#include <algorithm>
#include <vector>

namespace cdr::gpu {

namespace {

Buffer stage(const Device& device, std::span<const std::byte> bytes) {
    Buffer staging(device, bytes.size(), vk::BufferUsageFlagBits::eTransferSrc, MemoryUse::hostWrites,
                   "staging");
    std::copy(bytes.begin(), bytes.end(), static_cast<std::byte*>(staging.mapped()));
    staging.flush();
    return staging;
}

} // namespace

Buffer uploadBuffer(const Device& device, std::span<const std::byte> bytes, vk::BufferUsageFlags usage,
                    const std::string& name) {
    Buffer buffer(device, bytes.size(), usage | vk::BufferUsageFlagBits::eTransferDst, MemoryUse::deviceOnly,
                  name);
    if (bytes.empty()) {
        return buffer;
    }
    const Buffer staging = stage(device, bytes);
    runOnce(device, [&](vk::CommandBuffer commands) {
        commands.copyBuffer(staging.handle(), buffer.handle(), vk::BufferCopy{.size = bytes.size()});
    });
    return buffer;
}

void writeBuffer(const Device& device, const Buffer& buffer, std::span<const BufferPart> parts) {
    std::vector<std::byte> bytes;
    std::vector<vk::BufferCopy> copies;
    for (const BufferPart& part : parts) {
        if (!part.bytes.empty()) {
            copies.push_back(
                {.srcOffset = bytes.size(), .dstOffset = part.offset, .size = part.bytes.size()});
            bytes.insert(bytes.end(), part.bytes.begin(), part.bytes.end());
        }
    }
    if (copies.empty()) {
        return;
    }
    const Buffer staging = stage(device, bytes);
    runOnce(device, [&](vk::CommandBuffer commands) {
        commands.copyBuffer(staging.handle(), buffer.handle(), copies);
    });
}

Image uploadImage(const Device& device, vk::Extent2D extent, vk::Format format,
                  std::span<const std::byte> pixels, const std::string& name) {
    Image image(device,
                {.extent = extent,
                 .format = format,
                 .usage = vk::ImageUsageFlagBits::eTransferDst | vk::ImageUsageFlagBits::eSampled},
                name);
    const Buffer staging = stage(device, pixels);
    using Stage = vk::PipelineStageFlagBits2;
    using Access = vk::AccessFlagBits2;
    runOnce(device, [&](vk::CommandBuffer commands) {
        pipelineBarrier(commands,
                        {imageBarrier(image.handle(), vk::ImageAspectFlagBits::eColor, Stage::eNone,
                                      Access::eNone, Stage::eCopy, Access::eTransferWrite,
                                      vk::ImageLayout::eUndefined, vk::ImageLayout::eTransferDstOptimal)});
        commands.copyBufferToImage(
            staging.handle(), image.handle(), vk::ImageLayout::eTransferDstOptimal,
            vk::BufferImageCopy{.imageSubresource = {vk::ImageAspectFlagBits::eColor, 0, 0, 1},
                                .imageExtent = {extent.width, extent.height, 1}});
        pipelineBarrier(
            commands,
            {imageBarrier(image.handle(), vk::ImageAspectFlagBits::eColor, Stage::eCopy,
                          Access::eTransferWrite, Stage::eFragmentShader, Access::eShaderSampledRead,
                          vk::ImageLayout::eTransferDstOptimal, vk::ImageLayout::eShaderReadOnlyOptimal)});
    });
    return image;
}

} // namespace cdr::gpu
