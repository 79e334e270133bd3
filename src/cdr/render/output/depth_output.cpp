#include <cdr/gpu/commands.h>
#include <cdr/render/output/depth_output.h>
#include <cdr/render/stages.h>
#include <cdr/shaders/fullscreen_vert.h>
#include <cdr/shaders/output_depth_frag.h>

#include <utility>
#include <vector>

namespace cdr::render {

namespace {

constexpr auto kDepthStage = vk::ShaderStageFlagBits::eFragment;

std::vector<vk::DescriptorType> depthBindings() {
    return {vk::DescriptorType::eCombinedImageSampler, vk::DescriptorType::eStorageBuffer};
}

shaders::HostDepthPush termsOf(const HostDepth& host) {
    const depth::ClipTerms terms =
        depth::clipTerms({.mapping = host.mapping, .nearView = host.nearView, .farView = host.farView});
    return {.scale = static_cast<float>(terms.scale),
            .offset = static_cast<float>(terms.offset),
            .background = depth::isReversed(host.mapping) ? 0.0f : 1.0f};
}

} // namespace

DepthOutput::DepthOutput(const gpu::Device& device)
    : m_device(device),
      m_sampler(vk::Device(device.handle()).createSamplerUnique({})),
      m_setLayout(gpu::makeSetLayout(device, {depthBindings(), kDepthStage}, "host depth set")),
      m_layout(gpu::makePipelineLayout(
          device, {{m_setLayout}, {{.stageFlags = kDepthStage, .size = sizeof(shaders::HostDepthPush)}}},
          "host depth layout")),
      m_pipeline(gpu::makeGraphicsPipeline(device, {.name = "host depth",
                                                    .vertexSpirv = kFullscreenVert,
                                                    .fragmentSpirv = kOutputDepthFrag,
                                                    .layout = m_layout,
                                                    .depthFormat = kHostDepthFormat,
                                                    .depthCompare = vk::CompareOp::eAlways})) {}

DepthOutput::Inputs DepthOutput::makeInputs(const gpu::Image& gbuffer, const ShadingInputs& shading) const {
    vk::UniqueDescriptorPool pool = gpu::makeDescriptorPool(m_device, 1, 1, depthBindings());
    const vk::DescriptorSet set = gpu::allocateSet(m_device, *pool, *m_setLayout);
    gpu::writeImageBinding(m_device, set, 0, vk::DescriptorType::eCombinedImageSampler, gbuffer.view(),
                           *m_sampler);
    gpu::writeBufferBinding(m_device, set, 1, vk::DescriptorType::eStorageBuffer, shading.lights().handle());
    return {std::move(pool), set};
}

void DepthOutput::record(vk::CommandBuffer primary, const Inputs& inputs, const HostDepth& into) const {
    m_device.beginLabel(primary, "host depth");
    gpu::pipelineBarrier(primary, {gpu::imageBarrier(into.image.image, vk::ImageAspectFlagBits::eDepth,
                                                     {PipelineStage::eAllCommands, Access::eMemoryWrite,
                                                      vk::ImageLayout::eUndefined},
                                                     kDrawnDepth)});
    const vk::RenderingAttachmentInfo depth{.imageView = into.image.view,
                                            .imageLayout = vk::ImageLayout::eDepthAttachmentOptimal,
                                            .loadOp = vk::AttachmentLoadOp::eDontCare,
                                            .storeOp = vk::AttachmentStoreOp::eStore};
    const vk::Extent2D extent{into.image.extent.width, into.image.extent.height};
    primary.beginRendering({.renderArea = {{0, 0}, extent}, .layerCount = 1, .pDepthAttachment = &depth});
    gpu::bindFullscreenPipeline(primary, *m_pipeline, extent);
    primary.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *m_layout, 0, inputs.m_set, {});
    primary.pushConstants<shaders::HostDepthPush>(*m_layout, kDepthStage, 0, termsOf(into));
    primary.draw(3, 1, 0, 0);
    primary.endRendering();
    gpu::pipelineBarrier(
        primary, {gpu::imageBarrier(into.image.image, vk::ImageAspectFlagBits::eDepth, kDrawnDepth,
                                    {PipelineStage::eAllCommands, Access::eMemoryRead | Access::eMemoryWrite,
                                     vk::ImageLayout(into.image.layout)})});
    m_device.endLabel(primary);
}

} // namespace cdr::render
