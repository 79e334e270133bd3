#pragma once

#include <cdr/render/targets/depth_clear.h>
#include <cdr/render/targets/targets.h>
#include <cdr/render/targets/zero_fill.h>

namespace cdr::render {

/// Method 1 of the thesis: one G-buffer and one rendering scope. Cascades are drawn back to front, with depth
/// cleared between them, so that nearer ones draw over farther ones.
class SingleTargets final : public Targets {
  public:
    SingleTargets(const gpu::Device& device, const TargetsOptions& options);

    void begin(vk::CommandBuffer primary) const override;
    void record(CascadeCommands& commands, const FrameView& view) override;
    const gpu::Image& gbuffer() const override { return m_gbuffer; }
    const gpu::Image* emission() const override { return m_emission.get(); }
    const gpu::Image* marks() const override { return marksOf(m_depth, m_gbuffer); }

  private:
    GBufferScope scope(const glm::vec4& clearColor = {}) const;

    gpu::Image m_gbuffer;
    std::unique_ptr<gpu::Image> m_emission; ///< null without
    gpu::Image m_depth;
    bool m_reversedDepth;
    std::unique_ptr<ZeroFill> m_zeroFill; ///< null where the device clears quickly
    DepthClear m_depthClear;
};

} // namespace cdr::render
