#include <cdr/gpu/commands.h>
#include <cdr/render/shadows/seen_slices.h>
#include <cdr/render/stages.h>
#include <cdr/render/targets/gbuffer_rendering.h>
#include <cdr/shaders/shading.h>

namespace cdr::render {

namespace {

constexpr vk::DeviceSize kCountBytes = 4;

vk::UniqueQueryPool makeQueries(const gpu::Device& device) {
    return vk::Device(device.handle())
        .createQueryPoolUnique({.queryType = vk::QueryType::eOcclusion, .queryCount = kMaxReceiverSlices});
}

void draw(vk::CommandBuffer primary, const SlicePixels& slice, vk::Extent2D extent) {
    // The triangle lies at depth 0, which becomes the viewport's least.
    primary.setViewport(0, vk::Viewport{0.0f, 0.0f, static_cast<float>(extent.width),
                                        static_cast<float>(extent.height), slice.depth, slice.depth});
    primary.setScissor(0, slice.area);
    primary.draw(3, 1, 0, 0);
}

} // namespace

SeenSlices::SeenSlices(const gpu::Device& device)
    : m_device(device),
      m_layout(gpu::makePipelineLayout(device, {}, "seen slices layout")),
      m_pipeline(gpu::makeGraphicsPipeline(device, {.name = "seen slices",
                                                    .vertexSpirv = kFullscreenVert,
                                                    .layout = m_layout,
                                                    .depthFormat = SliceDepth::kFormat,
                                                    .writesDepth = false,
                                                    .depthCompare = vk::CompareOp::eEqual})) {}

SeenSlices::Slot SeenSlices::makeSlot() const {
    using Usage = vk::BufferUsageFlagBits;
    return {.queries = makeQueries(m_device),
            .counts = gpu::Buffer(m_device, kCountBytes * kMaxReceiverSlices,
                                  Usage::eTransferDst | Usage::eConditionalRenderingEXT,
                                  gpu::MemoryUse::deviceOnly, "pixels of slices")};
}

void SeenSlices::record(vk::CommandBuffer primary, const Slot& slot, std::span<const SlicePixels> slices,
                        const gpu::Image& depth) const {
    const auto count = static_cast<std::uint32_t>(slices.size());
    if (count == 0) {
        return;
    }
    const vk::Extent2D extent = depth.options().extent;
    primary.resetQueryPool(*slot.queries, 0, count);
    const auto attachment =
        depthAttachment(depth.view(), vk::AttachmentLoadOp::eLoad, vk::AttachmentStoreOp::eNone);
    beginRendering(primary, extent, {}, &attachment);
    gpu::bindFullscreenPipeline(primary, *m_pipeline, extent);
    for (std::uint32_t i = 0; i < count; ++i) {
        primary.beginQuery(*slot.queries, i, {});
        draw(primary, slices[i], extent);
        primary.endQuery(*slot.queries, i);
    }
    primary.endRendering();
    primary.copyQueryPoolResults(*slot.queries, 0, count, slot.counts.handle(), 0, kCountBytes,
                                 vk::QueryResultFlagBits::eWait);
    gpu::memoryBarrier(primary, PipelineStage::eCopy, Access::eTransferWrite,
                       PipelineStage::eConditionalRenderingEXT, Access::eConditionalRenderingReadEXT);
}

void SeenSlices::begin(vk::CommandBuffer primary, const Slot& slot, std::size_t slice) {
    primary.beginConditionalRenderingEXT({.buffer = slot.counts.handle(), .offset = kCountBytes * slice});
}

void SeenSlices::end(vk::CommandBuffer primary) {
    primary.endConditionalRenderingEXT();
}

} // namespace cdr::render
