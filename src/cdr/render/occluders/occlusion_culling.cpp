#include <cdr/gpu/commands.h>
#include <cdr/render/occluders/depth_reduction.h>
#include <cdr/render/occluders/occluder_view.h>
#include <cdr/render/occluders/occlusion_culling.h>
#include <cdr/render/readback.h>
#include <cdr/visibility/hidden_cells.h>

#include <utility>

namespace cdr::render {

namespace {

using Stage = vk::PipelineStageFlagBits2;
using Access = vk::AccessFlagBits2;

constexpr auto kDepthStages = Stage::eEarlyFragmentTests | Stage::eLateFragmentTests;
constexpr auto kDepthAccess = Access::eDepthStencilAttachmentRead | Access::eDepthStencilAttachmentWrite;

gpu::ImageOptions depthOptions(vk::Extent2D extent) {
    return {.extent = extent,
            .format = GeometryPipelines::kOccluderFormat,
            .usage = vk::ImageUsageFlagBits::eDepthStencilAttachment | vk::ImageUsageFlagBits::eTransferSrc,
            .aspect = vk::ImageAspectFlagBits::eDepth};
}

std::size_t pixelsOf(vk::Extent2D extent) {
    return std::size_t{extent.width} * extent.height;
}

/// Begins a rendering scope that clears depth to what is infinitely far.
void beginDepth(vk::CommandBuffer primary, const gpu::Image& depth) {
    gpu::pipelineBarrier(
        primary, {gpu::imageBarrier(depth.handle(), vk::ImageAspectFlagBits::eDepth, Stage::eCopy,
                                    Access::eNone, kDepthStages, kDepthAccess, vk::ImageLayout::eUndefined,
                                    vk::ImageLayout::eDepthAttachmentOptimal)});
    const vk::RenderingAttachmentInfo attachment{.imageView = depth.view(),
                                                 .imageLayout = vk::ImageLayout::eDepthAttachmentOptimal,
                                                 .loadOp = vk::AttachmentLoadOp::eClear,
                                                 .storeOp = vk::AttachmentStoreOp::eStore,
                                                 .clearValue = vk::ClearDepthStencilValue{.depth = 0.0f}};
    primary.beginRendering({.flags = vk::RenderingFlagBits::eContentsSecondaryCommandBuffers,
                            .renderArea = {{0, 0}, depth.options().extent},
                            .layerCount = 1,
                            .pDepthAttachment = &attachment});
}

/// Copies depth to where the host reads it.
void recordCopy(vk::CommandBuffer primary, const gpu::Image& depth, vk::Buffer copy) {
    gpu::pipelineBarrier(
        primary,
        {gpu::imageBarrier(depth.handle(), vk::ImageAspectFlagBits::eDepth, kDepthStages,
                           Access::eDepthStencilAttachmentWrite, Stage::eCopy, Access::eTransferRead,
                           vk::ImageLayout::eDepthAttachmentOptimal, vk::ImageLayout::eTransferSrcOptimal)});
    const auto& [width, height] = depth.options().extent;
    primary.copyImageToBuffer(
        depth.handle(), vk::ImageLayout::eTransferSrcOptimal, copy,
        vk::BufferImageCopy{.imageSubresource = {vk::ImageAspectFlagBits::eDepth, 0, 0, 1},
                            .imageExtent = {width, height, 1}});
    recordHostBarrier(primary);
}

} // namespace

OcclusionCulling::OcclusionCulling(const gpu::Device& device, const DrawnScene& drawn,
                                   const depth::Technique& technique, vk::Extent2D extent,
                                   std::unique_ptr<HostDraws> draws)
    : m_device(device),
      m_drawn(drawn),
      m_technique(technique),
      m_extent(extent),
      m_path(device, std::move(draws), "occluders"),
      m_depth(device, depthOptions(extent), "occluder depth"),
      m_copy(device, pixelsOf(extent) * sizeof(float), vk::BufferUsageFlagBits::eTransferDst,
             gpu::MemoryUse::hostReads, "occluder depth copy"),
      m_done(device.handle().createFenceUnique({})),
      m_tiles(extent.width, extent.height) {}

std::uint64_t OcclusionCulling::predictBytes(const gpu::Device& device, vk::Extent2D extent) {
    return gpu::predictBytes(device, depthOptions(extent)) + pixelsOf(extent) * sizeof(float);
}

void OcclusionCulling::drawDepth(const FrameView& view, const visibility::VisibleCells& occluders,
                                 OccluderStats& stats) {
    FrameStats frame;
    m_path.bin(view, occluders, frame);
    stats.draws = frame.draws;
    const HostCommands none{};
    m_path.begin(view, none);
    const vk::CommandBuffer primary = m_path.primary();
    m_device.beginLabel(primary, "occluders");
    beginDepth(primary, m_depth);
    m_path.drawInside({0, view.cascades.size()});
    primary.endRendering();
    m_device.endLabel(primary);
    recordCopy(primary, m_depth, m_copy.handle());
    gpu::submit(m_device, m_path.end(view), *m_done);
    gpu::waitAndReset(m_device, *m_done);
    m_copy.invalidate();
}

OccluderStats OcclusionCulling::drop(const FrameView& view, host::WorkerPool& workers,
                                     visibility::VisibleCells& visible) {
    OccluderStats stats;
    const visibility::VisibleCells& occluders = m_occluders.choose(m_drawn.scene, view.frustum, visible);
    // Layers are drawn nearer than they are, by what a technique decides.
    if (!occluders.parts.empty() && !m_drawn.uploaded.hasLayers()) {
        drawDepth(occluderView(view), occluders, stats);
        reduceDepth(m_copy.as<const float>(pixelsOf(m_extent)), m_extent.width, view.camera.nearView,
                    OrderMargin(m_technique, view), workers, m_tiles);
        const std::size_t before = visible.count();
        visibility::dropHidden(view.frustum, m_tiles, workers, visible);
        stats.hidden = before - visible.count();
    }
    m_occluders.remember(visible);
    return stats;
}

} // namespace cdr::render
