#include <cdr/gpu/commands.h>
#include <cdr/render/gbuffer_rendering.h>
#include <cdr/render/shading_pass.h>
#include <cdr/shaders/shading_frag.h>

#include <algorithm>

namespace cdr::render {

ShadingPass::ShadingPass(const gpu::Device& device, const gpu::Image& gbuffer, const gpu::Image& into)
    : m_device(device),
      m_gbuffer(gbuffer),
      m_into(into),
      m_pass(device,
             {.name = "shading",
              .fragmentSpirv = kShadingFrag,
              .bindings = {vk::DescriptorType::eCombinedImageSampler, vk::DescriptorType::eStorageBuffer},
              .format = into.options().format,
              .constants = {}}) {}

ShadingInputs ShadingPass::makeInputs(const scene::Scene& scene) const {
    ShadingInputs inputs;
    inputs.m_lights = gpu::Buffer(
        m_device, sizeof(shaders::ShadingHeader) + scene.lights.size() * sizeof(shaders::LightRecord),
        vk::BufferUsageFlagBits::eStorageBuffer, gpu::MemoryUse::hostWrites, "lights");
    inputs.m_inputs = m_pass.makeInputs();
    inputs.m_inputs.setImage(0, m_gbuffer);
    inputs.m_inputs.setBuffer(1, inputs.m_lights);
    return inputs;
}

void ShadingInputs::update(const scene::Scene& scene, const scene::Camera& camera, const Lens& lens,
                           std::span<const double> anchorsView) {
    shaders::ShadingHeader& header = m_lights.as<shaders::ShadingHeader>(1).front();
    header.ambient = glm::vec4(scene.ambient, 0.0f);
    header.background = glm::vec4(scene.background, 0.0f);
    header.rayScale = glm::vec2(lens.tanX, lens.tanY);
    header.lightCount = static_cast<std::uint32_t>(scene.lights.size());
    std::transform(anchorsView.begin(), anchorsView.end(), header.anchors, splitDouble);
    auto* lights = reinterpret_cast<shaders::LightRecord*>(&header + 1);
    for (const scene::PointLight& light : scene.lights) {
        *lights++ = makeLightRecord(light, camera);
    }
    m_lights.flush();
}

void ShadingPass::record(vk::CommandBuffer primary, const ShadingInputs& inputs) const {
    m_device.beginLabel(primary, "shading");
    gpu::pipelineBarrier(primary, {readBarrier(m_gbuffer), attachBarrier(m_into)});
    const vk::DescriptorSet set = inputs.m_inputs.set();
    m_pass.record(primary, {&set, 1}, m_into);
    m_device.endLabel(primary);
}

} // namespace cdr::render
