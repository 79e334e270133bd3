#include <cdr/render/output/deformed_motion.h>
#include <cdr/render/targets/gbuffer_rendering.h>
#include <cdr/render/upload/last_vertices.h>
#include <cdr/shaders/output.h>

#include <bit>
#include <cmath>

namespace cdr::render {

namespace {

constexpr auto kDeformedStages = vk::ShaderStageFlagBits::eVertex | vk::ShaderStageFlagBits::eFragment;
constexpr std::uint32_t kBeforeBinding = 1;

/// Of this frame, and of the last one.
std::vector<vk::VertexInputBindingDescription> bindingsOfBoth() {
    vk::VertexInputBindingDescription before = vertexBinding();
    before.binding = kBeforeBinding;
    return {vertexBinding(), before};
}

std::vector<vk::VertexInputAttributeDescription> positionsOfBoth() {
    vk::VertexInputAttributeDescription before = vertexAttributes().front();
    before.location = 1;
    before.binding = kBeforeBinding;
    return {vertexAttributes().front(), before};
}

/// A sub-pixel in pixels, as a constant of shaders.
std::uint32_t subPixelWord(std::uint32_t bits) {
    return std::bit_cast<std::uint32_t>(std::ldexp(1.0f, -static_cast<int>(bits)));
}

} // namespace

DeformedDraws deformedDraws(const DrawnScene& drawn, const FrameMotion& motion, const MotionMaker& maker) {
    DeformedDraws made;
    if (motion.deformed.empty()) {
        return made;
    }
    const LastVertices& last = drawn.uploaded.lastVertices();
    made.vertices = drawn.uploaded.vertices();
    made.verticesBefore = last.buffer().handle();
    made.indices = drawn.uploaded.indices();
    for (const DeformedInstance& deformed : motion.deformed) {
        const DrawSource& source = drawn.uploaded.sources()[deformed.instance];
        const DrawKind& kind = drawn.uploaded.kinds()[source.kind];
        if (kind.mesh.indexCount == 0) {
            continue; // no vertices may be kept at all
        }
        made.draws.push_back({.mesh = kind.mesh,
                              .firstBefore = last.firstOf(kind.meshIndex).value(),
                              .push = maker.push(source, deformed.before)});
    }
    return made;
}

DeformedMotion::DeformedMotion(const gpu::Device& device, const gpu::SetLayout& set, vk::Format format,
                               std::uint32_t subPixelBits)
    : m_layout(gpu::makePipelineLayout(
          device, {{set}, {{.stageFlags = kDeformedStages, .size = sizeof(shaders::DeformedPush)}}},
          "deformed motion layout")),
      m_pipeline(gpu::makeGraphicsPipeline(device, {.name = "deformed motion",
                                                    .vertexSpirv = kOutputDeformedMotionVert,
                                                    .fragmentSpirv = kOutputDeformedMotionFrag,
                                                    .constants = {subPixelWord(subPixelBits)},
                                                    .layout = m_layout,
                                                    .bindings = bindingsOfBoth(),
                                                    .attributes = positionsOfBoth(),
                                                    .colorFormats = {format}})) {}

void DeformedMotion::record(vk::CommandBuffer primary, const DeformedDraws& draws, vk::DescriptorSet set,
                            const gpu::Image& into) const {
    const auto color = colorAttachment(into.view(), vk::AttachmentLoadOp::eLoad);
    const vk::Extent2D extent = into.options().extent;
    beginRendering(primary, extent, {&color, 1});
    gpu::bindFullscreenPipeline(primary, *m_pipeline, extent);
    primary.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *m_layout, 0, set, {});
    primary.bindIndexBuffer(draws.indices, 0, vk::IndexType::eUint32);
    for (const DeformedDraws::Draw& draw : draws.draws) {
        const auto first = static_cast<std::size_t>(draw.mesh.vertexOffset);
        primary.bindVertexBuffers(0, {draws.vertices, draws.verticesBefore},
                                  {first * sizeof(PackedVertex), draw.firstBefore * sizeof(PackedVertex)});
        primary.pushConstants<shaders::DeformedPush>(*m_layout, kDeformedStages, 0, draw.push);
        primary.drawIndexed(draw.mesh.indexCount, 1, draw.mesh.firstIndex, 0, 0);
    }
    primary.endRendering();
}

} // namespace cdr::render
