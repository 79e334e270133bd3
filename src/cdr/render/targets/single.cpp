#include "single.h"

#include <cdr/render/targets/gbuffer_rendering.h>

#include <algorithm>

namespace cdr::render {

SingleTargets::SingleTargets(const gpu::Device& device, const TargetsOptions& options)
    : OneGBufferTargets(device, options),
      m_depthClear(makeDepthClear(device, options)) {}

void SingleTargets::record(CascadeCommands& commands, const FrameView& view) {
    std::vector<std::size_t> farthestFirst = commands.drawnCascades(view.cascades.size());
    std::reverse(farthestFirst.begin(), farthestFirst.end());
    GBufferScope cleared = scope(view.clearColor);
    cleared.depthClear = &m_depthClear;
    commands.drawScope(cleared, farthestFirst);
}

} // namespace cdr::render
