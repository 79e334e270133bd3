#pragma once

#include <cdr/render/targets/scope_commands.h>
#include <cdr/render/targets/targets.h>

namespace cdr::render {

/// What targets of one G-buffer, one depth buffer and one rendering scope for all cascades share.
class OneGBufferTargets : public Targets {
  public:
    OneGBufferTargets(const gpu::Device& device, const TargetsOptions& options);

    void begin(vk::CommandBuffer primary) const override;
    const gpu::Image& gbuffer() const override { return m_gbuffer; }
    const gpu::Image* emission() const override { return m_emission.get(); }
    const gpu::Image* marks() const override { return marksOf(m_depth, m_gbuffer); }

  protected:
    /// A scope of all images, without a clear of depth between cascades.
    GBufferScope scope(const glm::vec4& clearColor = {}) const;

    bool isDepthReversed() const { return m_reversedDepth; }

  private:
    gpu::Image m_gbuffer;
    std::unique_ptr<gpu::Image> m_emission; ///< null without
    gpu::Image m_depth;
    bool m_reversedDepth;
    std::unique_ptr<ScopeCommands> m_zeroFill; ///< null where the device clears quickly
};

} // namespace cdr::render
