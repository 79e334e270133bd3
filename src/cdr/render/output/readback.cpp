#include <cdr/gpu/commands.h>
#include <cdr/render/output/readback.h>

namespace cdr::render {

Readback::Readback(const gpu::Device& device, vk::Extent2D extent, std::size_t bytesPerPixel,
                   const std::string& name)
    : m_extent(extent),
      m_buffer(device, std::size_t{extent.width} * extent.height * bytesPerPixel,
               vk::BufferUsageFlagBits::eTransferDst, gpu::MemoryUse::hostReads, name) {}

std::uint64_t Readback::predictBytes(const gpu::Device& device, vk::Extent2D extent,
                                     std::size_t bytesPerPixel) {
    return gpu::takesDeviceBytes(device, gpu::MemoryUse::hostReads)
               ? std::uint64_t{extent.width} * extent.height * bytesPerPixel
               : 0;
}

void Readback::record(vk::CommandBuffer primary, const gpu::Image& image) const {
    primary.copyImageToBuffer(image.handle(), vk::ImageLayout::eTransferSrcOptimal, m_buffer.handle(),
                              vk::BufferImageCopy{.imageSubresource = {image.options().aspect, 0, 0, 1},
                                                  .imageExtent = {m_extent.width, m_extent.height, 1}});
}

void recordHostBarrier(vk::CommandBuffer primary) {
    gpu::memoryBarrier(primary, vk::PipelineStageFlagBits2::eCopy, vk::AccessFlagBits2::eTransferWrite,
                       vk::PipelineStageFlagBits2::eHost, vk::AccessFlagBits2::eHostRead);
}

} // namespace cdr::render
