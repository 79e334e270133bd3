#include <cdr/gpu/commands.h>
#include <cdr/render/shading/resolve_pass.h>
#include <cdr/render/targets/gbuffer_rendering.h>
#include <cdr/shaders/shading.h>

namespace cdr::render {

ResolvePass::ResolvePass(const gpu::Device& device, const gpu::Image& visibility)
    : m_device(device),
      m_visibility(visibility),
      m_gbuffer(makeGBuffer(device, visibility.options().extent, "resolved G-buffer")),
      m_pass(device,
             {.name = "resolve",
              .fragmentSpirv = kResolveFrag,
              .bindings = {vk::DescriptorType::eCombinedImageSampler, vk::DescriptorType::eStorageBuffer,
                           vk::DescriptorType::eUniformTexelBuffer},
              .format = kGBufferFormat}) {}

PassInputs ResolvePass::makeInputs(const ShadingInputs& shading) const {
    PassInputs inputs = m_pass.makeInputs();
    inputs.setImage(0, m_visibility);
    inputs.setBuffer(1, shading.lights());
    return inputs;
}

void ResolvePass::record(vk::CommandBuffer primary, PassInputs& inputs, vk::BufferView facets) const {
    inputs.setTexels(ShadingInputs::kFacetsBinding, facets);
    m_device.beginLabel(primary, "resolve the G-buffer");
    gpu::pipelineBarrier(primary, {attachBarrier(m_gbuffer)});
    m_pass.record(primary, inputs, m_gbuffer);
    gpu::pipelineBarrier(primary, {readBarrier(m_gbuffer)});
    m_device.endLabel(primary);
}

} // namespace cdr::render
