#include <cdr/gpu/pipeline.h>
#include <cdr/render/merge_pass.h>
#include <cdr/shaders/fullscreen_vert.h>
#include <cdr/shaders/merge_frag.h>

#include <array>
#include <vector>

namespace cdr::render {

namespace {

constexpr auto kImage = vk::DescriptorType::eCombinedImageSampler;

} // namespace

MergePass::MergePass(const gpu::Device& device)
    : m_device(device),
      m_sampler(device.handle().createSamplerUnique({})),
      m_setLayout(gpu::makeSetLayout(device, std::vector(GBuffer::kAttachments, kImage),
                                     vk::ShaderStageFlagBits::eFragment, "merge set")),
      m_layout(gpu::makePipelineLayout(device, {*m_setLayout}, {}, "merge layout")),
      m_pipeline(gpu::makeGraphicsPipeline(
          device, {.name = "merge",
                   .vertexSpirv = kFullscreenVert,
                   .fragmentSpirv = kMergeFrag,
                   .constants = {},
                   .layout = *m_layout,
                   .bindings = {},
                   .attributes = {},
                   .colorFormats = std::vector(GBuffer::kAttachments, GBuffer::kBitsFormat)})) {}

MergePass::Source MergePass::makeSource(const GBuffer& layer) const {
    Source source{.pool = gpu::makeDescriptorPool(m_device, 1, GBuffer::kAttachments, {kImage}), .set = {}};
    source.set = gpu::allocateSet(m_device, *source.pool, *m_setLayout);
    for (std::uint32_t i = 0; i < GBuffer::kAttachments; ++i) {
        gpu::writeImageBinding(m_device, source.set, i, kImage, layer.images()[i].aliasView(), *m_sampler);
    }
    return source;
}

void MergePass::record(vk::CommandBuffer primary, std::span<const vk::DescriptorSet> sources,
                       const GBuffer& into, vk::AttachmentLoadOp load) const {
    std::array<vk::RenderingAttachmentInfo, GBuffer::kAttachments> colors;
    for (std::size_t i = 0; i < colors.size(); ++i) {
        colors[i] = {.imageView = into.images()[i].aliasView(),
                     .imageLayout = vk::ImageLayout::eColorAttachmentOptimal,
                     .loadOp = load,
                     .storeOp = vk::AttachmentStoreOp::eStore};
    }
    const vk::Extent2D extent = into.images()[0].options().extent;
    primary.beginRendering({.renderArea = {{0, 0}, extent},
                            .layerCount = 1,
                            .colorAttachmentCount = static_cast<std::uint32_t>(colors.size()),
                            .pColorAttachments = colors.data()});
    gpu::bindFullscreenPipeline(primary, *m_pipeline, extent);
    for (const vk::DescriptorSet source : sources) {
        primary.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *m_layout, 0, source, {});
        primary.draw(3, 1, 0, 0);
    }
    primary.endRendering();
}

} // namespace cdr::render
