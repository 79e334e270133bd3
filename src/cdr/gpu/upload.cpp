#include <cdr/gpu/commands.h>
#include <cdr/gpu/upload.h>

#include <algorithm>
#include <vector>

namespace cdr::gpu {

namespace {

/// @param parts go one after the other.
Buffer stagingBuffer(const Device& device, std::span<const std::span<const std::byte>> parts) {
    std::size_t bytes = 0;
    for (const std::span<const std::byte> part : parts) {
        bytes += part.size();
    }
    Buffer staging(device, bytes, vk::BufferUsageFlagBits::eTransferSrc, MemoryUse::hostWrites, "staging");
    auto* end = static_cast<std::byte*>(staging.mapped());
    for (const std::span<const std::byte> part : parts) {
        end = std::copy(part.begin(), part.end(), end);
    }
    staging.flush();
    return staging;
}

/// Where each level lies in a buffer that has all of them, one after the other.
std::vector<vk::BufferImageCopy> copiesOf(vk::Extent2D extent,
                                          std::span<const std::span<const std::byte>> levels) {
    std::vector<vk::BufferImageCopy> copies;
    vk::DeviceSize offset = 0;
    for (std::uint32_t level = 0; level < levels.size(); ++level) {
        copies.push_back({.bufferOffset = offset,
                          .imageSubresource = {vk::ImageAspectFlagBits::eColor, level, 0, 1},
                          .imageExtent = {extent.width, extent.height, 1}});
        offset += levels[level].size();
        extent = smallerLevel(extent);
    }
    return copies;
}

} // namespace

Buffer uploadBuffer(const Device& device, std::span<const std::byte> bytes, vk::BufferUsageFlags usage,
                    const std::string& name) {
    Buffer buffer(device, bytes.size(), usage | vk::BufferUsageFlagBits::eTransferDst, MemoryUse::deviceOnly,
                  name);
    BufferFill fill(device, buffer);
    fill.add(bytes);
    fill.finish();
    return buffer;
}

void BufferFill::add(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        if (m_staging.size() == 0) {
            m_staging = Buffer(m_device, std::min<std::size_t>(kMaxBytes, m_buffer.size() - m_written),
                               vk::BufferUsageFlagBits::eTransferSrc, MemoryUse::hostWrites, "staging");
        }
        const std::size_t count = std::min<std::size_t>(bytes.size(), m_staging.size() - m_staged);
        std::copy_n(bytes.begin(), count, static_cast<std::byte*>(m_staging.mapped()) + m_staged);
        m_staged += count;
        bytes = bytes.subspan(count);
        if (m_staged == m_staging.size()) {
            finish();
        }
    }
}

void BufferFill::finish() {
    if (m_staged == 0) {
        return;
    }
    m_staging.flush();
    runOnce(m_device, [&](vk::CommandBuffer commands) {
        commands.copyBuffer(m_staging.handle(), m_buffer.handle(),
                            vk::BufferCopy{.dstOffset = m_written, .size = m_staged});
    });
    m_written += m_staged;
    m_staged = 0;
    m_staging = {};
}

void writeBuffer(const Device& device, const Buffer& buffer, std::span<const BufferPart> parts) {
    std::vector<std::span<const std::byte>> staged;
    std::vector<vk::BufferCopy> copies;
    vk::DeviceSize offset = 0;
    for (const BufferPart& part : parts) {
        if (!part.bytes.empty()) {
            copies.push_back({.srcOffset = offset, .dstOffset = part.offset, .size = part.bytes.size()});
            staged.emplace_back(part.bytes);
            offset += part.bytes.size();
        }
    }
    if (copies.empty()) {
        return;
    }
    const Buffer staging = stagingBuffer(device, staged);
    runOnce(device, [&](vk::CommandBuffer commands) {
        commands.copyBuffer(staging.handle(), buffer.handle(), copies);
    });
}

Image uploadImage(const Device& device, vk::Extent2D extent, vk::Format format,
                  std::span<const std::span<const std::byte>> levels, const std::string& name) {
    Image image(device,
                {.extent = extent,
                 .format = format,
                 .usage = vk::ImageUsageFlagBits::eTransferDst | vk::ImageUsageFlagBits::eSampled,
                 .levels = static_cast<std::uint32_t>(levels.size())},
                name);
    const Buffer staging = stagingBuffer(device, levels);
    const std::vector<vk::BufferImageCopy> copies = copiesOf(extent, levels);
    using PipelineStage = vk::PipelineStageFlagBits2;
    using Access = vk::AccessFlagBits2;
    runOnce(device, [&](vk::CommandBuffer commands) {
        pipelineBarrier(commands,
                        {imageBarrier(image.handle(), vk::ImageAspectFlagBits::eColor,
                                      {PipelineStage::eNone, Access::eNone, vk::ImageLayout::eUndefined},
                                      {PipelineStage::eCopy, Access::eTransferWrite,
                                       vk::ImageLayout::eTransferDstOptimal})});
        commands.copyBufferToImage(staging.handle(), image.handle(), vk::ImageLayout::eTransferDstOptimal,
                                   copies);
        pipelineBarrier(commands, {imageBarrier(image.handle(), vk::ImageAspectFlagBits::eColor,
                                                {PipelineStage::eCopy, Access::eTransferWrite,
                                                 vk::ImageLayout::eTransferDstOptimal},
                                                {PipelineStage::eFragmentShader, Access::eShaderSampledRead,
                                                 vk::ImageLayout::eShaderReadOnlyOptimal})});
    });
    return image;
}

} // namespace cdr::gpu
