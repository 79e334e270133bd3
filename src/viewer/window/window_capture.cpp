#include "window_capture.h"

#include <cdr/base/error.h>
#include <cdr/gpu/commands.h>

#include <cstring>

namespace cdr::viewer {

WindowCapture::WindowCapture(const gpu::Device& device, const Swapchain& swapchain)
    : m_extent(swapchain.extent()),
      m_isBgra(swapchain.format() == vk::Format::eB8G8R8A8Unorm) {
    if (!swapchain.isReadable()) {
        throw base::RunError("this window system does not let a window's pixels be read");
    }
    m_buffer = gpu::Buffer(device, std::size_t{m_extent.width} * m_extent.height * sizeof(image::Rgba8),
                           vk::BufferUsageFlagBits::eTransferDst, gpu::MemoryUse::hostReads, "capture");
}

void WindowCapture::record(vk::CommandBuffer commands, vk::Image image) const {
    using PipelineStage = vk::PipelineStageFlagBits2;
    using Access = vk::AccessFlagBits2;
    const auto turn = [&](const gpu::ImageUse& before, const gpu::ImageUse& after) {
        gpu::pipelineBarrier(commands,
                             {gpu::imageBarrier(image, vk::ImageAspectFlagBits::eColor, before, after)});
    };
    constexpr gpu::ImageUse kCopied{PipelineStage::eCopy, Access::eTransferRead,
                                    vk::ImageLayout::eTransferSrcOptimal};
    turn({PipelineStage::eColorAttachmentOutput, Access::eColorAttachmentWrite,
          vk::ImageLayout::ePresentSrcKHR},
         kCopied);
    commands.copyImageToBuffer(
        image, vk::ImageLayout::eTransferSrcOptimal, m_buffer.handle(),
        vk::BufferImageCopy{.imageSubresource = {vk::ImageAspectFlagBits::eColor, 0, 0, 1},
                            .imageExtent = {m_extent.width, m_extent.height, 1}});
    turn(kCopied, {PipelineStage::eCopy, Access::eNone, vk::ImageLayout::ePresentSrcKHR});
    gpu::memoryBarrier(commands, PipelineStage::eCopy, Access::eTransferWrite, PipelineStage::eHost,
                       Access::eHostRead);
}

image::ImageRgba8 WindowCapture::fetch() const {
    image::ImageRgba8 picture(m_extent.width, m_extent.height);
    m_buffer.invalidate();
    std::memcpy(picture.pixels.data(), m_buffer.mapped(), m_buffer.size());
    for (image::Rgba8& pixel : picture.pixels) {
        if (m_isBgra) {
            std::swap(pixel[0], pixel[2]);
        }
        pixel[3] = 255;
    }
    return picture;
}

} // namespace cdr::viewer
