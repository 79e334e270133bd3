#include <cdr/gpu/commands.h>
#include <cdr/render/occluders/depth_reduction.h>
#include <cdr/render/occluders/occluder_drawing.h>
#include <cdr/render/occluders/occlusion_culling.h>
#include <cdr/render/output/readback.h>
#include <cdr/visibility/hidden_cells.h>

#include <utility>

namespace cdr::render {

OcclusionCulling::OcclusionCulling(const gpu::Device& device, const DrawnScene& drawn,
                                   const depth::Technique& technique, vk::Extent2D extent,
                                   std::unique_ptr<HostDraws> draws)
    : m_device(device),
      m_drawn(drawn),
      m_technique(technique),
      m_extent(extent),
      m_path(device, std::move(draws), "occluders"),
      m_depth(device, occluderDepthOptions(extent), "occluder depth"),
      m_copy(device, occluderCopyBytes(extent), vk::BufferUsageFlagBits::eTransferDst,
             gpu::MemoryUse::hostReads, "occluder depth copy"),
      m_done(vk::Device(device.handle()).createFenceUnique({})),
      m_tiles(extent.width, extent.height) {}

std::uint64_t OcclusionCulling::predictBytes(const gpu::Device& device, vk::Extent2D extent) {
    return gpu::predictBytes(device, occluderDepthOptions(extent)) + occluderCopyBytes(extent);
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
    beginOccluders(primary, m_depth, vk::RenderingFlagBits::eContentsSecondaryCommandBuffers);
    m_path.drawInside({0, view.cascades.size()});
    primary.endRendering();
    m_device.endLabel(primary);
    copyOccluders(primary, m_depth, m_copy.handle());
    recordHostBarrier(primary);
    vk::Device(m_device.handle()).resetFences(*m_done); // a wait that failed has left it signalled
    gpu::submit(m_device, m_path.end(view), *m_done);
    gpu::waitAndReset(m_device, *m_done);
    m_copy.invalidate();
}

OccluderStats OcclusionCulling::drop(const FrameView& view, platform::WorkerPool& workers,
                                     visibility::VisibleCells& visible) {
    OccluderStats stats;
    const visibility::VisibleCells& occluders = m_occluders.choose(m_drawn.scene, view.frustum, visible);
    // Layer offsets draw faces nearer than they are, by what a technique decides.
    if (!occluders.parts.empty() && !m_drawn.uploaded.hasLayers()) {
        drawDepth(occluderView(view), occluders, stats);
        reduceDepth(m_copy.as<const float>(occluderCopyBytes(m_extent) / sizeof(float)), m_extent.width,
                    view.camera.nearView, OrderMargin(m_technique, view), workers, m_tiles);
        const std::size_t before = visible.count();
        visibility::dropHidden(view.frustum, m_tiles, workers, visible);
        stats.hidden = before - visible.count();
    }
    m_occluders.remember(visible);
    return stats;
}

} // namespace cdr::render
