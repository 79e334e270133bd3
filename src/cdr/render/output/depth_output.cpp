#include <cdr/gpu/commands.h>
#include <cdr/render/output/depth_output.h>
#include <cdr/render/stages.h>
#include <cdr/shaders/output.h>

#include <span>

namespace cdr::render {

namespace {

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
      m_pass(device,
             {.name = "host depth",
              .fragmentSpirv = kOutputDepthFrag,
              .bindings = {vk::DescriptorType::eCombinedImageSampler, vk::DescriptorType::eStorageBuffer},
              .pushBytes = sizeof(shaders::HostDepthPush),
              .writtenDepth = kHostDepthFormat}) {}

PassInputs DepthOutput::makeInputs(const gpu::Image& gbuffer, const ShadingInputs& shading) const {
    return m_pass.makeInputs(gbuffer, shading.lights());
}

void DepthOutput::record(vk::CommandBuffer primary, const PassInputs& inputs, const HostDepth& into) const {
    m_device.beginLabel(primary, "host depth");
    gpu::pipelineBarrier(primary, {gpu::imageBarrier(into.image.image, vk::ImageAspectFlagBits::eDepth,
                                                     {PipelineStage::eAllCommands, Access::eMemoryWrite,
                                                      vk::ImageLayout::eUndefined},
                                                     kDrawnDepth)});
    const shaders::HostDepthPush push = termsOf(into);
    m_pass.recordDepth(primary, {.set = *inputs, .push = std::as_bytes(std::span(&push, 1))}, into.image.view,
                       {into.image.extent.width, into.image.extent.height});
    gpu::pipelineBarrier(
        primary, {gpu::imageBarrier(into.image.image, vk::ImageAspectFlagBits::eDepth, kDrawnDepth,
                                    {PipelineStage::eAllCommands, Access::eMemoryRead | Access::eMemoryWrite,
                                     vk::ImageLayout(into.image.layout)})});
    m_device.endLabel(primary);
}

} // namespace cdr::render
