#include <cdr/gpu/commands.h>
#include <cdr/gpu/pipeline.h>
#include <cdr/render/gbuffer_rendering.h>
#include <cdr/render/sorted_blend.h>
#include <cdr/shaders/fullscreen_vert.h>
#include <cdr/shaders/translucent_sorted_counted_frag.h>
#include <cdr/shaders/translucent_sorted_frag.h>
#include <cdr/shaders/translucent_sorted_resolve_frag.h>

#include <vector>

namespace cdr::render {

namespace {

using Stage = vk::PipelineStageFlagBits2;
using Access = vk::AccessFlagBits2;

TranslucentPipelinesOptions drawOptions(vk::DescriptorSetLayout surroundings, vk::DescriptorSetLayout list,
                                        bool countsCoverage) {
    TranslucentPipelinesOptions options{.name = "translucent, sorted",
                                        .fragmentSpirv = kTranslucentSortedFrag,
                                        .sets = {surroundings, list},
                                        .colorFormats = {}};
    if (countsCoverage) {
        options.fragmentSpirv = kTranslucentSortedCountedFrag;
        options.colorFormats.push_back(Coverage::kFormat);
    }
    return options;
}

} // namespace

SortedBlend::SortedBlend(const gpu::Device& device, const GpuScene& scene,
                         vk::DescriptorSetLayout surroundings, vk::Format litFormat, bool countsCoverage)
    : m_device(device),
      m_listLayout(gpu::makeSetLayout(
          device, std::vector(FragmentList::kBindings, vk::DescriptorType::eStorageBuffer),
          vk::ShaderStageFlagBits::eFragment, "fragment list set")),
      m_pipelines(device, scene, drawOptions(surroundings, *m_listLayout, countsCoverage)),
      m_resolveLayout(gpu::makePipelineLayout(
          device, {*m_listLayout},
          {{.stageFlags = vk::ShaderStageFlagBits::eFragment, .size = sizeof(std::uint32_t)}},
          "sorted resolve layout")),
      m_resolve(gpu::makeGraphicsPipeline(device, {.name = "sorted resolve",
                                                   .vertexSpirv = kFullscreenVert,
                                                   .fragmentSpirv = kTranslucentSortedResolveFrag,
                                                   .constants = {},
                                                   .layout = *m_resolveLayout,
                                                   .bindings = {},
                                                   .attributes = {},
                                                   .colorFormats = {litFormat},
                                                   .blend = gpu::Blend::over})) {}

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
    recordResolve(primary, frame.lit, list);
    m_device.endLabel(primary);
}

void SortedBlend::recordDraws(vk::CommandBuffer primary, const TranslucentFrame& frame,
                              const FragmentList& list) const {
    std::vector<vk::RenderingAttachmentInfo> attachments;
    if (frame.coverage != nullptr) {
        attachments.push_back(frame.coverage->attachment());
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

void SortedBlend::recordResolve(vk::CommandBuffer primary, const gpu::Image& lit,
                                const FragmentList& list) const {
    const vk::RenderingAttachmentInfo color{.imageView = lit.view(),
                                            .imageLayout = vk::ImageLayout::eColorAttachmentOptimal,
                                            .loadOp = vk::AttachmentLoadOp::eLoad,
                                            .storeOp = vk::AttachmentStoreOp::eStore};
    const vk::Extent2D extent = lit.options().extent;
    primary.beginRendering({.renderArea = {{0, 0}, extent},
                            .layerCount = 1,
                            .colorAttachmentCount = 1,
                            .pColorAttachments = &color});
    gpu::bindFullscreenPipeline(primary, *m_resolve, extent);
    primary.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *m_resolveLayout, 0, list.set(), {});
    primary.pushConstants<std::uint32_t>(*m_resolveLayout, vk::ShaderStageFlagBits::eFragment, 0,
                                         extent.width);
    primary.draw(3, 1, 0, 0);
    primary.endRendering();
}

} // namespace cdr::render
