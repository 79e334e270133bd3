#include <cdr/gpu/commands.h>
#include <cdr/gpu/pipeline.h>
#include <cdr/render/gbuffer_rendering.h>
#include <cdr/render/shading_pass.h>
#include <cdr/shaders/fullscreen_vert.h>
#include <cdr/shaders/shading_frag.h>

#include <algorithm>

namespace cdr::render {

namespace {

using Stage = vk::PipelineStageFlagBits2;
using Access = vk::AccessFlagBits2;

constexpr auto kImage = vk::DescriptorType::eCombinedImageSampler;
constexpr auto kStorage = vk::DescriptorType::eStorageBuffer;
constexpr auto kFormat = vk::Format::eR8G8B8A8Srgb;

} // namespace

ShadingPass::ShadingPass(const gpu::Device& device, const gpu::Image& gbuffer, vk::Extent2D extent)
    : m_device(device),
      m_gbuffer(gbuffer),
      m_picture(device,
                {.extent = extent,
                 .format = kFormat,
                 .usage = vk::ImageUsageFlagBits::eColorAttachment | vk::ImageUsageFlagBits::eTransferSrc},
                "picture"),
      m_sampler(device.handle().createSamplerUnique({})),
      m_setLayout(
          gpu::makeSetLayout(device, {kImage, kStorage}, vk::ShaderStageFlagBits::eFragment, "shading set")),
      m_layout(gpu::makePipelineLayout(device, {*m_setLayout}, {}, "shading layout")),
      m_pipeline(gpu::makeGraphicsPipeline(device, {.name = "shading",
                                                    .vertexSpirv = kFullscreenVert,
                                                    .fragmentSpirv = kShadingFrag,
                                                    .constants = {},
                                                    .layout = *m_layout,
                                                    .bindings = {},
                                                    .attributes = {},
                                                    .colorFormats = {kFormat}})) {}

ShadingInputs ShadingPass::makeInputs(const scene::Scene& scene) const {
    ShadingInputs inputs;
    inputs.m_uniforms = gpu::Buffer(
        m_device, sizeof(shaders::ShadingHeader) + scene.lights.size() * sizeof(shaders::LightRecord),
        vk::BufferUsageFlagBits::eStorageBuffer, gpu::MemoryUse::hostWrites, "lights");
    inputs.m_pool = gpu::makeDescriptorPool(m_device, 1, 1, {kImage, kStorage});
    inputs.m_set = gpu::allocateSet(m_device, *inputs.m_pool, *m_setLayout);
    gpu::writeImageBinding(m_device, inputs.m_set, 0, kImage, m_gbuffer.view(), *m_sampler);
    gpu::writeBufferBinding(m_device, inputs.m_set, 1, kStorage, inputs.m_uniforms.handle());
    return inputs;
}

void ShadingInputs::update(const scene::Scene& scene, const scene::Camera& camera, const Lens& lens,
                           std::span<const double> anchorsView) {
    shaders::ShadingHeader& header = m_uniforms.as<shaders::ShadingHeader>(1).front();
    header.ambient = glm::vec4(scene.ambient, 0.0f);
    header.background = glm::vec4(scene.background, 0.0f);
    header.rayScale = glm::vec2(lens.tanX, lens.tanY);
    header.lightCount = static_cast<std::uint32_t>(scene.lights.size());
    std::transform(anchorsView.begin(), anchorsView.end(), header.anchors, splitDouble);
    auto* lights = reinterpret_cast<shaders::LightRecord*>(&header + 1);
    for (const scene::PointLight& light : scene.lights) {
        *lights++ = makeLightRecord(light, camera);
    }
    m_uniforms.flush();
}

void ShadingPass::record(vk::CommandBuffer primary, const ShadingInputs& inputs) const {
    m_device.beginLabel(primary, "shading");
    gpu::pipelineBarrier(
        primary,
        {readBarrier(m_gbuffer),
         gpu::imageBarrier(m_picture.handle(), vk::ImageAspectFlagBits::eColor, Stage::eCopy, Access::eNone,
                           Stage::eColorAttachmentOutput, Access::eColorAttachmentWrite,
                           vk::ImageLayout::eUndefined, vk::ImageLayout::eColorAttachmentOptimal)});
    const vk::RenderingAttachmentInfo color{.imageView = m_picture.view(),
                                            .imageLayout = vk::ImageLayout::eColorAttachmentOptimal,
                                            .loadOp = vk::AttachmentLoadOp::eDontCare,
                                            .storeOp = vk::AttachmentStoreOp::eStore};
    const vk::Rect2D area{{0, 0}, m_picture.options().extent};
    primary.beginRendering(
        {.renderArea = area, .layerCount = 1, .colorAttachmentCount = 1, .pColorAttachments = &color});
    gpu::bindFullscreenPipeline(primary, *m_pipeline, area.extent);
    primary.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *m_layout, 0, inputs.m_set, {});
    primary.draw(3, 1, 0, 0);
    primary.endRendering();
    gpu::pipelineBarrier(
        primary,
        {gpu::imageBarrier(m_picture.handle(), vk::ImageAspectFlagBits::eColor, Stage::eColorAttachmentOutput,
                           Access::eColorAttachmentWrite, Stage::eCopy, Access::eTransferRead,
                           vk::ImageLayout::eColorAttachmentOptimal, vk::ImageLayout::eTransferSrcOptimal)});
    m_device.endLabel(primary);
}

std::uint64_t ShadingPass::predictBytes(vk::Extent2D extent) {
    return std::uint64_t{extent.width} * extent.height * 4;
}

} // namespace cdr::render
