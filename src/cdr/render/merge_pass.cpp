#include <cdr/gpu/pipeline.h>
#include <cdr/render/merge_pass.h>
#include <cdr/shaders/fullscreen_vert.h>
#include <cdr/shaders/merge_frag.h>

namespace cdr::render {

namespace {

constexpr auto kImage = vk::DescriptorType::eCombinedImageSampler;

} // namespace

MergePass::MergePass(const gpu::Device& device)
    : m_device(device),
      m_sampler(device.handle().createSamplerUnique({})),
      m_setLayout(gpu::makeSetLayout(device, {kImage}, vk::ShaderStageFlagBits::eFragment, "merge set")),
      m_layout(gpu::makePipelineLayout(device, {*m_setLayout}, {}, "merge layout")),
      m_pipeline(gpu::makeGraphicsPipeline(device, {.name = "merge",
                                                    .vertexSpirv = kFullscreenVert,
                                                    .fragmentSpirv = kMergeFrag,
                                                    .constants = {},
                                                    .layout = *m_layout,
                                                    .bindings = {},
                                                    .attributes = {},
                                                    .colorFormats = {kGBufferFormat}})) {}

MergePass::Source MergePass::makeSource(const gpu::Image& layer) const {
    Source source{.pool = gpu::makeDescriptorPool(m_device, 1, 1, {kImage}), .set = {}};
    source.set = gpu::allocateSet(m_device, *source.pool, *m_setLayout);
    gpu::writeImageBinding(m_device, source.set, 0, kImage, layer.view(), *m_sampler);
    return source;
}

void MergePass::record(vk::CommandBuffer primary, std::span<const vk::DescriptorSet> sources,
                       const gpu::Image& into, vk::AttachmentLoadOp load) const {
    const vk::RenderingAttachmentInfo color{.imageView = into.view(),
                                            .imageLayout = vk::ImageLayout::eColorAttachmentOptimal,
                                            .loadOp = load,
                                            .storeOp = vk::AttachmentStoreOp::eStore};
    const vk::Extent2D extent = into.options().extent;
    primary.beginRendering({.renderArea = {{0, 0}, extent},
                            .layerCount = 1,
                            .colorAttachmentCount = 1,
                            .pColorAttachments = &color});
    gpu::bindFullscreenPipeline(primary, *m_pipeline, extent);
    for (const vk::DescriptorSet source : sources) {
        primary.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *m_layout, 0, source, {});
        primary.draw(3, 1, 0, 0);
    }
    primary.endRendering();
}

} // namespace cdr::render
