#include <cdr/render/shading/occlusion_pass.h>
#include <cdr/shaders/shading.h>

namespace cdr::render {

namespace {

constexpr auto kFormat = vk::Format::eR8Unorm;

FullscreenPassOptions occlusionPassOptions(AnchorForm anchors) {
    return {.name = "occlusion",
            .vertexSpirv = kFlatAnchorsVert,
            .fragmentSpirv = kOcclusionFrag,
            .bindings = {vk::DescriptorType::eCombinedImageSampler, vk::DescriptorType::eStorageBuffer},
            .format = kFormat,
            .constants = {static_cast<std::uint32_t>(anchors)}};
}

} // namespace

OcclusionPass::OcclusionPass(const gpu::Device& device, const gpu::Image& gbuffer, depth::Mapping mapping)
    : m_gbuffer(gbuffer),
      m_image(device,
              {.extent = gbuffer.options().extent,
               .format = kFormat,
               .usage = vk::ImageUsageFlagBits::eColorAttachment | vk::ImageUsageFlagBits::eSampled},
              "occlusion"),
      m_passes(ByCascades<FullscreenPass>::make(depth::isAnchored(mapping), [&](AnchorForm anchors) {
          return FullscreenPass(device, occlusionPassOptions(anchors));
      })) {}

PassInputs OcclusionPass::makeInputs(const gpu::Buffer& lights) const {
    return m_passes.few.makeInputs(m_gbuffer, lights);
}

void OcclusionPass::record(vk::CommandBuffer primary, const PassInputs& inputs, std::size_t cascades) const {
    m_passes.of(cascades).recordInto(primary, "ambient occlusion", inputs, m_image);
}

std::uint64_t OcclusionPass::predictBytes(vk::Extent2D extent) {
    return std::uint64_t{extent.width} * extent.height;
}

} // namespace cdr::render
