#include "targets_single.h"

#include <cdr/render/gbuffer_rendering.h>

#include <string>

namespace cdr::render {

SingleTargets::SingleTargets(const gpu::Device& device, const TargetsOptions& options)
    : m_device(device),
      m_gbuffer(makeGBuffer(device, options.extent, "G-buffer")),
      m_depth(makeDepthBuffer(device, options.extent, options.depthFormat, "depth")),
      m_reversedDepth(options.reversedDepth) {}

void SingleTargets::record(vk::CommandBuffer primary, const CascadeRecorder& recorder, std::size_t cascades) {
    GBufferScope scope{
        .gbuffer = m_gbuffer, .depth = m_depth, .clearColor = true, .reversedDepth = m_reversedDepth};
    beginGBuffer(primary, scope);
    for (std::size_t cascade = cascades; cascade-- > 0;) {
        if (!scope.clearColor) {
            chainGBufferScopes(primary, scope);
        }
        m_device.beginLabel(primary, ("cascade " + std::to_string(cascade)).c_str());
        runGBufferScope(primary, scope, recorder.commands(cascade));
        m_device.endLabel(primary);
        scope.clearColor = false;
    }
}

} // namespace cdr::render
