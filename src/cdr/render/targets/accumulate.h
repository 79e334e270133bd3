#pragma once

#include <cdr/render/targets/cascade_layers.h>

namespace cdr::render {

/// Method 2 of the thesis: every cascade draws the same layer in turn, and each is merged into the
/// accumulated G-buffer before the next. Between the two a screen-space effect may run on the layer alone.
class AccumulateTargets final : public Targets {
  public:
    AccumulateTargets(const gpu::Device& device, const TargetsOptions& options)
        : m_layers(device, options, 1) {}

    void record(CascadeCommands& commands, const FrameView& view) override {
        m_layers.record(commands, view);
    }
    const gpu::Image& gbuffer() const override { return m_layers.accumulated(); }

  private:
    CascadeLayers m_layers;
};

} // namespace cdr::render
