#include <cdr/gpu/commands.h>
#include <cdr/gpu/pipeline.h>
#include <cdr/render/materials/packed_vertex.h>
#include <cdr/render/shadows/shadow_map.h>
#include <cdr/render/stages.h>
#include <cdr/render/targets/gbuffer_rendering.h>
#include <cdr/shaders/shadows.h>

#include <algorithm>
#include <cstddef>

namespace cdr::render {

namespace {

constexpr auto kDepthFormat = vk::Format::eD32Sfloat;
constexpr auto kSlopeFormat = vk::Format::eR16G16Sfloat;
constexpr auto kPushStages = vk::ShaderStageFlagBits::eVertex | vk::ShaderStageFlagBits::eFragment;

gpu::ImageOptions depthOptions(std::uint32_t side) {
    return {.extent = {side, side},
            .format = kDepthFormat,
            .usage = vk::ImageUsageFlagBits::eDepthStencilAttachment | vk::ImageUsageFlagBits::eSampled,
            .aspect = vk::ImageAspectFlagBits::eDepth};
}

gpu::ImageOptions slopeOptions(std::uint32_t side) {
    return {.extent = {side, side},
            .format = kSlopeFormat,
            .usage = vk::ImageUsageFlagBits::eColorAttachment | vk::ImageUsageFlagBits::eSampled};
}

enum class CasterKind : std::uint8_t { solid, masked };

std::vector<vk::VertexInputAttributeDescription> casterAttributes(CasterKind kind) {
    using shaders::CasterRecord;
    constexpr auto kRow = vk::Format::eR32G32B32A32Sfloat;
    constexpr std::uint32_t kRecord = CasterDraws::kRecordBinding;
    const std::vector<vk::VertexInputAttributeDescription> vertex = vertexAttributes();
    std::vector<vk::VertexInputAttributeDescription> attributes{
        vertex[0],
        {1, kRecord, kRow, offsetof(CasterRecord, right)},
        {2, kRecord, kRow, offsetof(CasterRecord, up)},
        {3, kRecord, kRow, offsetof(CasterRecord, ahead)},
        {4, kRecord, vk::Format::eR32Sfloat, offsetof(CasterRecord, rounding)}};
    if (kind == CasterKind::masked) {
        attributes.insert(attributes.end(),
                          {{5, vertex[2].binding, vertex[2].format, vertex[2].offset}, // place in the texture
                           {6, vertex[3].binding, vertex[3].format, vertex[3].offset}, // colour
                           {7, kRecord, vk::Format::eR32Sfloat, offsetof(CasterRecord, leastAlpha)}});
    }
    return attributes;
}

gpu::Pipeline makeCasterPipeline(const gpu::Device& device, const gpu::PipelineLayout& layout,
                                 CasterKind kind) {
    const bool isMasked = kind == CasterKind::masked;
    return gpu::makeGraphicsPipeline(
        device, {.name = isMasked ? "masked shadow casters" : "shadow casters",
                 .vertexSpirv = isMasked ? gpu::Spirv(kCasterMaskedVert) : gpu::Spirv(kCasterVert),
                 .fragmentSpirv = isMasked ? gpu::Spirv(kCasterMaskedFrag) : gpu::Spirv(kCasterFrag),
                 .layout = layout,
                 .bindings = {vertexBinding(),
                              {.binding = CasterDraws::kRecordBinding,
                               .stride = sizeof(shaders::CasterRecord),
                               .inputRate = vk::VertexInputRate::eInstance}},
                 .attributes = casterAttributes(kind),
                 .colorFormats = {kSlopeFormat},
                 .depthFormat = kDepthFormat,
                 .depthCompare = vk::CompareOp::eGreaterOrEqual});
}

shaders::CasterPush pushOf(const LightView& view) {
    const glm::dvec2 size(view.size.width, view.size.height);
    const glm::dvec2 scale = 2.0 / (view.texel * size);
    return {.scale = scale, .shift = -view.low * scale - 1.0, .lens = view.lens()};
}

/// Of the part of the map that is drawn.
vk::Extent2D extentOf(std::span<const ShadowMapPart> parts) {
    vk::Extent2D extent;
    for (const ShadowMapPart& part : parts) {
        extent.width =
            std::max(extent.width, static_cast<std::uint32_t>(part.corner.x) + part.view.size.width);
        extent.height =
            std::max(extent.height, static_cast<std::uint32_t>(part.corner.y) + part.view.size.height);
    }
    return extent;
}

} // namespace

ShadowMap::ShadowMap(const gpu::Device& device, const gpu::SetLayout& textures, std::uint32_t side)
    : m_depth(device, depthOptions(side), "shadow map depth"),
      m_slope(device, slopeOptions(side), "shadow map slope"),
      m_layout(gpu::makePipelineLayout(
          device, {{textures}, {{.stageFlags = kPushStages, .size = sizeof(shaders::CasterPush)}}},
          "shadow caster layout")),
      m_solid(makeCasterPipeline(device, m_layout, CasterKind::solid)),
      m_masked(makeCasterPipeline(device, m_layout, CasterKind::masked)) {}

void ShadowMap::record(vk::CommandBuffer primary, std::span<const ShadowMapPart> parts,
                       const CasterDraws& draws) const {
    constexpr gpu::ImageUse kBefore{PipelineStage::eFragmentShader, Access::eNone,
                                    vk::ImageLayout::eUndefined};
    constexpr gpu::ImageUse kDepthUse{kDepthStages, kDepthAccess, vk::ImageLayout::eAttachmentOptimal};
    gpu::pipelineBarrier(
        primary,
        {gpu::imageBarrier(m_depth.handle(), vk::ImageAspectFlagBits::eDepth, kBefore, kDepthUse),
         gpu::imageBarrier(m_slope.handle(), vk::ImageAspectFlagBits::eColor, kBefore, kDrawnColor)});
    if (!parts.empty()) { // a scope must cover some texels
        draw(primary, parts, draws);
    }
    gpu::pipelineBarrier(primary, {gpu::imageBarrier(m_depth.handle(), vk::ImageAspectFlagBits::eDepth,
                                                     kDrawnDepth, kShaderRead),
                                   readBarrier(m_slope)});
}

void ShadowMap::draw(vk::CommandBuffer primary, std::span<const ShadowMapPart> parts,
                     const CasterDraws& draws) const {
    const auto slope = colorAttachment(m_slope.view(), vk::AttachmentLoadOp::eClear);
    const auto depth = depthAttachment(m_depth.view(), vk::AttachmentLoadOp::eClear);
    beginRendering(primary, extentOf(parts), {&slope, 1}, &depth);
    for (const ShadowMapPart& part : parts) {
        const vk::Extent2D size = part.view.size;
        primary.setViewport(0, vk::Viewport{static_cast<float>(part.corner.x),
                                            static_cast<float>(part.corner.y), static_cast<float>(size.width),
                                            static_cast<float>(size.height), 0.0f, 1.0f});
        primary.setScissor(0, vk::Rect2D{part.corner, size});
        primary.pushConstants<shaders::CasterPush>(*m_layout, kPushStages, 0, pushOf(part.view));
        draws.record(primary, part.index, {.solid = *m_solid, .masked = *m_masked, .layout = *m_layout});
    }
    primary.endRendering();
}

std::uint64_t ShadowMap::predictBytes(const gpu::Device& device, std::uint32_t side) {
    return gpu::predictBytes(device, depthOptions(side)) + gpu::predictBytes(device, slopeOptions(side));
}

} // namespace cdr::render
