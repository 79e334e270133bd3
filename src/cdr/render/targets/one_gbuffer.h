#pragma once

#include <cdr/render/targets/scope_commands.h>
#include <cdr/render/targets/targets.h>

#include <optional>

namespace cdr::render {

/// One G-buffer, one depth buffer and one rendering scope for all cascades.
///
/// `single` is method 1 of the thesis: cascades are drawn back to front, with depth cleared between them, so that nearer
/// ones draw over farther ones.
///
/// `one-pass` has no clear in between. Each cascade owns a slice of the depth range, set by the viewport. Nearer cascades
/// own nearer slices: the lower ones, or the upper ones for reversed depth. Drawn front to back, so early depth tests
/// work across cascades. Slices share no value. A surface clamped to the far end of one never ties with one clamped to
/// the near end of the next.
///
/// What N slices cost, against a depth range of one's own:
///
/// b-bit integers: every slice has 2^b / N of the 2^b values, log2 N bits less, and 4 values of guard.
///
/// float32: even slices would cost log2 N bits at their far end. At depth 0, which reversed and anchored depth
/// use, they would cost all that the exponent gives. So slices are cut by exponent: each reaches k octaves down
/// from the one above, k = min(24, 102 / N), and the lowest to 0. A depth d of the cascade's own lies at v = m
/// + d (M - m) in the slice [m, M], where m = M 2^-k. The step of d is float32's step at v, divided by M - m.
/// With up to 5 cascades (k >= 20) nothing is lost above d = 2^-20. With 16 (k = 6) 0.02 bits are lost, and up
/// to one bit where v enters the next octave. From 52 on (k = 1) a bit is lost everywhere. Below d = 2^-k steps
/// no longer shrink with d, but in the lowest slice. That is the far cascade's for reversed depth and the near
/// one's for the rest. It keeps float's own steps down to d = 2^-24 at least.
class OneGBufferTargets final : public Targets {
  public:
    /// @param kind TargetsKind::single or TargetsKind::onePass
    OneGBufferTargets(const gpu::Device& device, TargetsKind kind, const TargetsOptions& options);

    DepthSlice depthSlice(std::size_t cascade, std::size_t cascades) const override;
    void begin(vk::CommandBuffer primary) const override;
    void record(CascadeCommands& commands, const FrameView& view) override;
    const gpu::Image& gbuffer() const override { return m_gbuffer; }
    const gpu::Image* emission() const override { return m_emission.get(); }
    const gpu::Image* marks() const override { return marksOf(m_depth, m_gbuffer); }

  private:
    GBufferScope scope(const glm::vec4& clearColor = {}) const;

    TargetsOptions m_options;
    gpu::Image m_gbuffer;
    std::unique_ptr<gpu::Image> m_emission; ///< null without
    gpu::Image m_depth;
    std::unique_ptr<ScopeCommands> m_zeroFill; ///< null where the device clears quickly
    std::optional<ScopeCommands> m_depthClear; ///< none where cascades have slices of depth
};

} // namespace cdr::render
