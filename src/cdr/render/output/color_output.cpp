#include <cdr/gpu/commands.h>
#include <cdr/render/output/color_output.h>
#include <cdr/render/stages.h>

#include <array>
#include <cstdint>

namespace cdr::render {

namespace {

constexpr vk::ImageSubresourceLayers kColorLayer{vk::ImageAspectFlagBits::eColor, 0, 0, 1};

void copyPicture(vk::CommandBuffer primary, const gpu::Image& picture, const SurfaceImage& into) {
    primary.copyImage(picture.handle(), vk::ImageLayout::eTransferSrcOptimal, into.image,
                      vk::ImageLayout::eTransferDstOptimal,
                      vk::ImageCopy{.srcSubresource = kColorLayer,
                                    .dstSubresource = kColorLayer,
                                    .extent = {into.extent.width, into.extent.height, 1}});
}

void convertPicture(vk::CommandBuffer primary, const gpu::Image& picture, const SurfaceImage& into) {
    const std::array<vk::Offset3D, 2> all{vk::Offset3D{0, 0, 0},
                                          vk::Offset3D{static_cast<std::int32_t>(into.extent.width),
                                                       static_cast<std::int32_t>(into.extent.height), 1}};
    primary.blitImage(picture.handle(), vk::ImageLayout::eTransferSrcOptimal, into.image,
                      vk::ImageLayout::eTransferDstOptimal,
                      vk::ImageBlit{.srcSubresource = kColorLayer,
                                    .srcOffsets = all,
                                    .dstSubresource = kColorLayer,
                                    .dstOffsets = all},
                      vk::Filter::eNearest);
}

} // namespace

void recordColorOutput(vk::CommandBuffer primary, const gpu::Image& picture, const SurfaceImage& into) {
    constexpr gpu::ImageUse kWritten{PipelineStage::eAllTransfer, Access::eTransferWrite,
                                     vk::ImageLayout::eTransferDstOptimal};
    const auto barrier = [&](const gpu::ImageUse& before, const gpu::ImageUse& after) {
        gpu::pipelineBarrier(primary,
                             {gpu::imageBarrier(into.image, vk::ImageAspectFlagBits::eColor, before, after)});
    };
    barrier({PipelineStage::eAllCommands, Access::eMemoryWrite}, kWritten);
    if (vk::Format(into.format) == picture.options().format) {
        copyPicture(primary, picture, into);
    } else {
        convertPicture(primary, picture, into);
    }
    barrier(kWritten, {PipelineStage::eAllCommands, Access::eMemoryRead | Access::eMemoryWrite,
                       vk::ImageLayout(into.layout)});
}

} // namespace cdr::render
