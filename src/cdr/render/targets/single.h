#pragma once

#include <cdr/render/targets/one_gbuffer.h>

namespace cdr::render {

/// Method 1 of the thesis: one G-buffer and one rendering scope. Cascades are drawn back to front, with depth
/// cleared between them, so that nearer ones draw over farther ones.
class SingleTargets final : public OneGBufferTargets {
  public:
    SingleTargets(const gpu::Device& device, const TargetsOptions& options);

    void record(CascadeCommands& commands, const FrameView& view) override;

  private:
    ScopeCommands m_depthClear;
};

} // namespace cdr::render
