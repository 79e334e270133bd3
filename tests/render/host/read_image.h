#pragma once

#include <cdr/gpu/commands.h>
#include <cdr/gpu/memory.h>
#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/image/image.h>
#include <cdr/render/frame.h>
#include <cdr/render/output/readback.h>
#include <cdr/render/surfaces.h>

#include <cstring>

namespace cdr::render_test {

/// Pixels of an image on the device as all that was submitted before left it; afterwards in transfer source layout.
template <typename Pixel>
image::Raster<Pixel> readImage(const gpu::Device& device, VkImage image, VkExtent2D extent,
                               VkImageLayout layout,
                               vk::ImageAspectFlags aspect = vk::ImageAspectFlagBits::eColor) {
    image::Raster<Pixel> raster(extent.width, extent.height);
    const std::size_t bytes = raster.pixels.size() * sizeof(Pixel);
    const gpu::Buffer copy(device, bytes, vk::BufferUsageFlagBits::eTransferDst, gpu::MemoryUse::hostReads,
                           "read image");
    gpu::runOnce(device, [&](vk::CommandBuffer commands) {
        gpu::pipelineBarrier(
            commands,
            {gpu::imageBarrier(image, aspect,
                               {vk::PipelineStageFlagBits2::eAllCommands, vk::AccessFlagBits2::eMemoryWrite,
                                vk::ImageLayout(layout)},
                               {vk::PipelineStageFlagBits2::eCopy, vk::AccessFlagBits2::eTransferRead,
                                vk::ImageLayout::eTransferSrcOptimal})});
        commands.copyImageToBuffer(image, vk::ImageLayout::eTransferSrcOptimal, copy.handle(),
                                   vk::BufferImageCopy{.imageSubresource = {aspect, 0, 0, 1},
                                                       .imageExtent = {extent.width, extent.height, 1}});
        render::recordHostBarrier(commands);
    });
    copy.invalidate();
    std::memcpy(raster.pixels.data(), copy.mapped(), bytes);
    return raster;
}

inline image::Raster<render::GBufferPixel> readGBuffer(const gpu::Device& device,
                                                       const render::SurfaceImage& gbuffer) {
    return readImage<render::GBufferPixel>(device, gbuffer.image, gbuffer.extent, gbuffer.layout);
}

} // namespace cdr::render_test
