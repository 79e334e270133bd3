#include "single.h"

#include <cdr/render/targets/gbuffer_rendering.h>

#include <algorithm>

namespace cdr::render {

SingleTargets::SingleTargets(const gpu::Device& device, const TargetsOptions& options)
    : m_gbuffer(makeGBuffer(device, options.extent, "G-buffer", options.format)),
      m_emission(makeEmission(device, options, "emission")),
      m_depth(makeDepthBuffer(device, options.extent, options.depthFormat, "depth", options.format)),
      m_reversedDepth(options.reversedDepth),
      m_zeroFill(makeZeroFill(device, options)),
      m_depthClear(device, options) {}

GBufferScope SingleTargets::scope(const glm::vec4& clearColor) const {
    return {.gbuffer = m_gbuffer,
            .depth = m_depth,
            .emission = m_emission.get(),
            .reversedDepth = m_reversedDepth,
            .clearColor = clearColor,
            .zeroFill = m_zeroFill.get(),
            .depthClear = &m_depthClear};
}

void SingleTargets::begin(vk::CommandBuffer primary) const {
    beginGBuffer(primary, scope());
}

void SingleTargets::record(CascadeCommands& commands, const FrameView& view) {
    std::vector<std::size_t> farthestFirst = commands.drawnCascades(view.cascades.size());
    std::reverse(farthestFirst.begin(), farthestFirst.end());
    commands.drawScope(scope(view.clearColor), farthestFirst);
}

} // namespace cdr::render
