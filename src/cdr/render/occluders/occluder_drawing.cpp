#include <cdr/gpu/commands.h>
#include <cdr/render/geometry/geometry_pipelines.h>
#include <cdr/render/occluders/occluder_drawing.h>
#include <cdr/render/stages.h>
#include <cdr/render/targets/gbuffer_rendering.h>

namespace cdr::render {

FrameView occluderView(const FrameView& view) {
    FrameView occluders = view;
    for (CascadeView& cascade : occluders.cascades) {
        // Clip z is the offset, and clip w the view distance.
        cascade.terms.scale = 0.0;
        cascade.terms.offset = view.camera.nearView;
        cascade.slice = {};
    }
    return occluders;
}

gpu::ImageOptions occluderDepthOptions(vk::Extent2D extent) {
    return {.extent = extent,
            .format = GeometryPipelines::kOccluderFormat,
            .usage = vk::ImageUsageFlagBits::eDepthStencilAttachment | vk::ImageUsageFlagBits::eTransferSrc,
            .aspect = vk::ImageAspectFlagBits::eDepth};
}

std::size_t occluderCopyBytes(vk::Extent2D extent) {
    return std::size_t{extent.width} * extent.height * sizeof(float);
}

void beginOccluders(vk::CommandBuffer primary, const gpu::Image& depth, vk::RenderingFlags flags) {
    gpu::pipelineBarrier(
        primary, {gpu::imageBarrier(depth.handle(), vk::ImageAspectFlagBits::eDepth,
                                    {PipelineStage::eCopy, Access::eNone, vk::ImageLayout::eUndefined},
                                    {kDepthStages, kDepthAccess, vk::ImageLayout::eAttachmentOptimal})});
    const auto attachment = depthAttachment(depth.view(), vk::AttachmentLoadOp::eClear);
    beginRendering(primary, depth.options().extent, {}, &attachment, nullptr, flags);
}

void copyOccluders(vk::CommandBuffer primary, const gpu::Image& depth, vk::Buffer copy) {
    gpu::pipelineBarrier(primary,
                         {gpu::imageBarrier(depth.handle(), vk::ImageAspectFlagBits::eDepth, kDrawnDepth,
                                            {PipelineStage::eCopy, Access::eTransferRead,
                                             vk::ImageLayout::eTransferSrcOptimal})});
    const auto& [width, height] = depth.options().extent;
    primary.copyImageToBuffer(
        depth.handle(), vk::ImageLayout::eTransferSrcOptimal, copy,
        vk::BufferImageCopy{.imageSubresource = {vk::ImageAspectFlagBits::eDepth, 0, 0, 1},
                            .imageExtent = {width, height, 1}});
}

} // namespace cdr::render
