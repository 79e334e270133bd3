#include "one_gbuffer.h"

#include <cdr/render/targets/gbuffer_rendering.h>

namespace cdr::render {

OneGBufferTargets::OneGBufferTargets(const gpu::Device& device, const TargetsOptions& options)
    : m_gbuffer(makeGBuffer(device, options.extent, "G-buffer", options.format)),
      m_emission(makeEmission(device, options, "emission")),
      m_depth(makeDepthBuffer(device, options.extent, options.depthFormat, "depth", options.format)),
      m_reversedDepth(options.reversedDepth),
      m_zeroFill(makeZeroFill(device, options)) {}

GBufferScope OneGBufferTargets::scope(const glm::vec4& clearColor) const {
    return {.gbuffer = m_gbuffer,
            .depth = m_depth,
            .emission = m_emission.get(),
            .reversedDepth = m_reversedDepth,
            .clearColor = clearColor,
            .zeroFill = m_zeroFill.get()};
}

void OneGBufferTargets::begin(vk::CommandBuffer primary) const {
    beginGBuffer(primary, scope());
}

} // namespace cdr::render
