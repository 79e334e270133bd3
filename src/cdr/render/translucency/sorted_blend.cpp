#include <cdr/gpu/commands.h>
#include <cdr/render/shading/picture.h>
#include <cdr/render/targets/gbuffer_rendering.h>
#include <cdr/render/translucency/sorted_blend.h>
#include <cdr/shaders/translucent_sorted_counted_detailed_frag.h>
#include <cdr/shaders/translucent_sorted_counted_frag.h>
#include <cdr/shaders/translucent_sorted_detailed_frag.h>
#include <cdr/shaders/translucent_sorted_frag.h>
#include <cdr/shaders/translucent_sorted_resolve_frag.h>

#include <vector>

namespace cdr::render {

namespace {

using Stage = vk::PipelineStageFlagBits2;
using Access = vk::AccessFlagBits2;

TranslucentPipelinesOptions drawOptions(const gpu::SetLayout& surroundings, const gpu::SetLayout& list,
                                        const BlendOptions& blend) {
    TranslucentPipelinesOptions options{.name = "translucent, sorted",
                                        .fragmentSpirv = kTranslucentSortedFrag,
                                        .detailedSpirv = kTranslucentSortedDetailedFrag,
                                        .sets = {surroundings, list},
                                        .colorFormats = {},
                                        .variants = blend.variants};
    if (blend.countsFragments) {
        options.fragmentSpirv = kTranslucentSortedCountedFrag;
        options.detailedSpirv = kTranslucentSortedCountedDetailedFrag;
        options.colorFormats.push_back(FragmentCounter::kFormat);
    }
    return options;
}

} // namespace

SortedBlend::SortedBlend(const gpu::Device& device, const GpuScene& scene, const gpu::SetLayout& surroundings,
                         const BlendOptions& options)
    : m_device(device),
      m_resolve(device, {.name = "sorted resolve",
                         .fragmentSpirv = kTranslucentSortedResolveFrag,
                         .bindings = std::vector(FragmentList::kBindings, vk::DescriptorType::eStorageBuffer),
                         .format = kLitFormat,
                         .constants = {},
                         .pushBytes = sizeof(vk::Extent2D),
                         .blend = gpu::Blend::over}),
      m_pipelines(device, scene, drawOptions(surroundings, listLayout(), options)) {}

void SortedBlend::record(vk::CommandBuffer primary, const TranslucentFrame& frame,
                         const FragmentList& list) const {
    m_device.beginLabel(primary, "translucent, sorted");
    list.recordClear(primary);
    recordDraws(primary, frame, list);
    gpu::pipelineBarrier(
        primary, {chainBarrier(frame.lit)},
        {{.srcStageMask = Stage::eFragmentShader,
          .srcAccessMask = Access::eShaderStorageWrite,
          .dstStageMask = Stage::eFragmentShader | Stage::eHost,
          .dstAccessMask = Access::eShaderStorageRead | Access::eShaderStorageWrite | Access::eHostRead}});
    const vk::Extent2D extent = frame.lit.options().extent;
    const FullscreenPass::Draw lists{.set = list.set(), .push = std::as_bytes(std::span(&extent, 1))};
    m_resolve.record(primary, {&lists, 1}, frame.lit, vk::AttachmentLoadOp::eLoad);
    m_device.endLabel(primary);
}

void SortedBlend::recordDraws(vk::CommandBuffer primary, const TranslucentFrame& frame,
                              const FragmentList& list) const {
    std::vector<vk::RenderingAttachmentInfo> attachments;
    if (frame.counter != nullptr) {
        attachments.push_back(frame.counter->attachment());
    }
    const vk::Extent2D extent = frame.lit.options().extent;
    primary.beginRendering({.renderArea = {{0, 0}, extent},
                            .layerCount = 1,
                            .colorAttachmentCount = static_cast<std::uint32_t>(attachments.size()),
                            .pColorAttachments = attachments.data()});
    primary.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, m_pipelines.layout(), 1,
                               {frame.surroundings, list.set()}, {});
    for (std::size_t range = 0; range < frame.draws.ranges(); ++range) {
        if (!frame.draws.isEmpty(range)) {
            frame.draws.record(primary, range, m_pipelines, extent, list.capacity());
        }
    }
    primary.endRendering();
}

} // namespace cdr::render
