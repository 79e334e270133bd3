#include <cdr/gpu/commands.h>
#include <cdr/render/shading/picture.h>
#include <cdr/render/targets/gbuffer_rendering.h>
#include <cdr/render/translucency/weighted_blend.h>
#include <cdr/render/uploaded_scene.h>
#include <cdr/shaders/translucency.h>

#include <fmt/format.h>

#include <array>
#include <vector>

namespace cdr::render {

namespace {

/// Vulkan requires every device to blend these.
constexpr auto kSumFormat = vk::Format::eR16G16B16A16Sfloat;
constexpr auto kWeightFormat = vk::Format::eR16Sfloat;

gpu::Image makeImage(const gpu::Device& device, vk::Extent2D extent, vk::Format format, const char* name) {
    return {device,
            {.extent = extent,
             .format = format,
             .usage = vk::ImageUsageFlagBits::eColorAttachment | vk::ImageUsageFlagBits::eSampled},
            name};
}

TranslucentPipelinesOptions drawOptions(const gpu::SetLayout& surroundings, const BlendOptions& blend) {
    return withShaders(
        {.name = "translucent, weighted",
         .sets = {surroundings},
         .colorFormats = {kSumFormat, kWeightFormat}},
        blend,
        {.lit = {kTranslucentWeightedFrag, kTranslucentWeightedDetailedFrag},
         .shadowed = {kTranslucentWeightedShadowedFrag, kTranslucentWeightedShadowedDetailedFrag}});
}

vk::RenderingAttachmentInfo cleared(const gpu::Image& image, float alpha) {
    return colorAttachment(image.view(), vk::AttachmentLoadOp::eClear,
                           vk::ClearColorValue{std::array{0.0f, 0.0f, 0.0f, alpha}});
}

} // namespace

WeightedBlend::WeightedBlend(const gpu::Device& device, const UploadedScene& scene,
                             const gpu::SetLayout& surroundings, vk::Extent2D extent,
                             const BlendOptions& options)
    : m_device(device),
      m_sum(makeImage(device, extent, kSumFormat, "weighted sum")),
      m_weight(makeImage(device, extent, kWeightFormat, "weights")),
      m_pipelines(device, scene, drawOptions(surroundings, options)),
      m_resolve(device, {.name = "weighted resolve",
                         .fragmentSpirv = kTranslucentWeightedResolveFrag,
                         .bindings = {vk::DescriptorType::eCombinedImageSampler,
                                      vk::DescriptorType::eCombinedImageSampler},
                         .format = kLitFormat,
                         .blend = gpu::Blend::over}),
      m_sums(m_resolve.makeInputs()) {
    m_sums.setImage(0, m_sum);
    m_sums.setImage(1, m_weight);
}

void WeightedBlend::record(vk::CommandBuffer primary, const TranslucentFrame& frame) const {
    for (std::size_t range = frame.draws.ranges(); range-- > 0;) {
        if (frame.draws.isEmpty(range)) {
            continue;
        }
        m_device.beginLabel(primary, fmt::format("translucent, cascade {}", range).c_str());
        recordSums(primary, frame, range);
        gpu::pipelineBarrier(primary, {readBarrier(m_sum), readBarrier(m_weight), chainBarrier(frame.lit)});
        const FullscreenPass::Draw sums{.set = *m_sums};
        m_resolve.record(primary, {&sums, 1}, {.into = frame.lit, .load = vk::AttachmentLoadOp::eLoad});
        m_device.endLabel(primary);
    }
}

void WeightedBlend::recordSums(vk::CommandBuffer primary, const TranslucentFrame& frame,
                               std::size_t range) const {
    if (frame.shadows == nullptr) {
        recordSum(primary, frame, {.range = range});
        return;
    }
    Sum sum{.range = range};
    for (const shaders::TranslucentSlice& slice : frame.shadows->slices()) {
        if (frame.draws.meets(range, slice)) {
            sum.slice = &slice;
            frame.shadows->recordMaps(primary, slice);
            recordSum(primary, frame, sum);
            sum.isFirst = false;
        }
    }
}

void WeightedBlend::recordSum(vk::CommandBuffer primary, const TranslucentFrame& frame,
                              const Sum& sum) const {
    std::vector<vk::ImageMemoryBarrier2> before{attachBarrier(m_sum), attachBarrier(m_weight)};
    std::vector<vk::RenderingAttachmentInfo> attachments{cleared(m_sum, 1.0f), cleared(m_weight, 0.0f)};
    if (!sum.isFirst) {
        before = {chainBarrier(m_sum), chainBarrier(m_weight)};
        for (vk::RenderingAttachmentInfo& attachment : attachments) {
            attachment.loadOp = vk::AttachmentLoadOp::eLoad;
        }
    }
    if (frame.counter != nullptr) {
        before.push_back(frame.counter->nextScope());
        attachments.push_back(frame.counter->attachment());
    }
    const vk::Extent2D extent = m_sum.options().extent;
    gpu::pipelineBarrier(primary, before);
    beginRendering(primary, extent, attachments);
    primary.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, m_pipelines.layout(), 1, frame.surroundings,
                               {});
    frame.draws.record(primary, sum.range, m_pipelines, extent, 0, sum.slice);
    primary.endRendering();
}

std::uint64_t WeightedBlend::predictBytes(vk::Extent2D extent) {
    return std::uint64_t{extent.width} * extent.height * (8 + 2);
}

} // namespace cdr::render
