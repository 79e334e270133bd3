#pragma once

#include <cdr/render/targets/cascade_layers.h>

namespace cdr::render {

/// Method 3 of the thesis: several layers are in flight together and merged in depth order before they are
/// drawn again, so neighbouring cascades need not wait for each other on the device.
class PoolTargets final : public Targets {
  public:
    PoolTargets(const gpu::Device& device, const TargetsOptions& options, std::size_t layers)
        : m_layers(device, options, layers) {}

    void record(CascadeCommands& commands, const FrameView& view) override {
        m_layers.record(commands, view);
    }
    const gpu::Image& gbuffer() const override { return m_layers.accumulated(); }

  private:
    CascadeLayers m_layers;
};

} // namespace cdr::render
