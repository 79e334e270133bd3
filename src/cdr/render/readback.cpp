#include <cdr/gpu/commands.h>
#include <cdr/render/readback.h>

#include <string>

namespace cdr::render {

Readback::Readback(const gpu::Device& device, vk::Extent2D extent, std::size_t images) : m_extent(extent) {
    const std::size_t bytes = std::size_t{extent.width} * extent.height * 4;
    for (std::size_t i = 0; i < images; ++i) {
        m_buffers.emplace_back(device, bytes, vk::BufferUsageFlagBits::eTransferDst,
                               gpu::MemoryUse::hostReads, "read-back " + std::to_string(i));
    }
}

void Readback::recordCopy(vk::CommandBuffer primary, const gpu::Image& image, std::size_t index) const {
    primary.copyImageToBuffer(image.handle(), vk::ImageLayout::eTransferSrcOptimal, m_buffers[index].handle(),
                              vk::BufferImageCopy{.imageSubresource = {image.options().aspect, 0, 0, 1},
                                                  .imageExtent = {m_extent.width, m_extent.height, 1}});
}

void Readback::recordHostBarrier(vk::CommandBuffer primary) const {
    gpu::pipelineBarrier(primary, {},
                         {{.srcStageMask = vk::PipelineStageFlagBits2::eCopy,
                           .srcAccessMask = vk::AccessFlagBits2::eTransferWrite,
                           .dstStageMask = vk::PipelineStageFlagBits2::eHost,
                           .dstAccessMask = vk::AccessFlagBits2::eHostRead}});
}

} // namespace cdr::render
