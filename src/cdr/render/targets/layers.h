#pragma once

#include <cdr/render/targets/cascade_layers.h>

namespace cdr::render {

/// Method 4 of the thesis: each cascade keeps a layer of its own, and all are merged at the end. Costs a
/// G-buffer and a depth buffer per cascade, made when a frame first has that many.
class LayersTargets final : public Targets {
  public:
    LayersTargets(const gpu::Device& device, const TargetsOptions& options) : m_layers(device, options, 1) {}

    void record(CascadeCommands& commands, const FrameView& view) override {
        m_layers.grow(view.cascades.size());
        m_layers.record(commands, view);
    }
    const gpu::Image& gbuffer() const override { return m_layers.accumulated(); }

  private:
    CascadeLayers m_layers;
};

} // namespace cdr::render
