#include <cdr/gpu/commands.h>
#include <cdr/render/shading/picture.h>
#include <cdr/render/stages.h>
#include <cdr/render/targets/gbuffer_rendering.h>
#include <cdr/render/translucency/sorted_blend.h>
#include <cdr/render/uploaded_scene.h>
#include <cdr/shaders/translucency.h>

#include <vector>

namespace cdr::render {

namespace {

TranslucentPipelinesOptions drawOptions(const gpu::SetLayout& surroundings, const gpu::SetLayout& list,
                                        const BlendOptions& blend) {
    return withShaders(
        {.name = "translucent, sorted", .sets = {surroundings, list}}, blend,
        {.lit = {kTranslucentSortedFrag, kTranslucentSortedDetailedFrag},
         .shadowed = {kTranslucentSortedShadowedFrag, kTranslucentSortedShadowedDetailedFrag}});
}

} // namespace

SortedBlend::SortedBlend(const gpu::Device& device, const UploadedScene& scene,
                         const gpu::SetLayout& surroundings, const BlendOptions& options)
    : m_device(device),
      m_resolve(device, {.name = "sorted resolve",
                         .fragmentSpirv = kTranslucentSortedResolveFrag,
                         .bindings = std::vector(FragmentList::kBindings, vk::DescriptorType::eStorageBuffer),
                         .format = kLitFormat,
                         .pushBytes = sizeof(vk::Extent2D),
                         .blend = gpu::Blend::over}),
      m_pipelines(device, scene, drawOptions(surroundings, listLayout(), options)) {}

void SortedBlend::record(vk::CommandBuffer primary, const TranslucentFrame& frame,
                         const FragmentList& list) const {
    m_device.beginLabel(primary, "translucent, sorted");
    list.recordClear(primary);
    if (frame.shadows == nullptr) {
        recordDraws(primary, frame, list, nullptr);
    } else {
        for (const shaders::TranslucentSlice& slice : frame.shadows->slices()) {
            frame.shadows->recordMaps(primary, slice);
            recordDraws(primary, frame, list, &slice);
            recordNext(primary, frame);
        }
    }
    gpu::pipelineBarrier(primary, {chainBarrier(frame.lit)},
                         {{.srcStageMask = PipelineStage::eFragmentShader,
                           .srcAccessMask = Access::eShaderStorageWrite,
                           .dstStageMask = PipelineStage::eFragmentShader | PipelineStage::eTransfer,
                           .dstAccessMask = Access::eShaderStorageRead | Access::eShaderStorageWrite |
                                            Access::eTransferRead}});
    list.recordCount(primary);
    const vk::Extent2D extent = frame.lit.options().extent;
    const FullscreenPass::Draw lists{.set = list.set(), .push = std::as_bytes(std::span(&extent, 1))};
    m_resolve.record(primary, {&lists, 1}, {.into = frame.lit, .load = vk::AttachmentLoadOp::eLoad});
    m_device.endLabel(primary);
}

void SortedBlend::recordNext(vk::CommandBuffer primary, const TranslucentFrame& frame) {
    if (frame.counter != nullptr) {
        gpu::pipelineBarrier(primary, {frame.counter->nextScope()});
    }
    constexpr auto kLists = Access::eShaderStorageRead | Access::eShaderStorageWrite;
    gpu::memoryBarrier(primary, PipelineStage::eFragmentShader, kLists, PipelineStage::eFragmentShader,
                       kLists);
}

void SortedBlend::recordDraws(vk::CommandBuffer primary, const TranslucentFrame& frame,
                              const FragmentList& list, const shaders::TranslucentSlice* slice) const {
    std::vector<vk::RenderingAttachmentInfo> attachments;
    if (frame.counter != nullptr) {
        attachments.push_back(frame.counter->attachment());
    }
    const vk::Extent2D extent = frame.lit.options().extent;
    beginRendering(primary, extent, attachments);
    primary.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, m_pipelines.layout(), 1,
                               {frame.surroundings, list.set()}, {});
    for (std::size_t range = 0; range < frame.draws.ranges(); ++range) {
        const bool isMet = slice == nullptr || frame.draws.meets(range, *slice);
        if (isMet && !frame.draws.isEmpty(range)) {
            frame.draws.record(primary, range, m_pipelines, extent, list.capacity(), slice);
        }
    }
    primary.endRendering();
}

} // namespace cdr::render
