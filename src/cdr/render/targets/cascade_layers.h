#pragma once

#include <cdr/render/shading/fullscreen_pass.h>
#include <cdr/render/targets/scope_commands.h>
#include <cdr/render/targets/targets.h>

#include <span>
#include <vector>

namespace cdr::render {

/// How many layers there are.
struct LayerCount {
    std::size_t first = 1;   ///< to begin with
    bool perCascade = false; ///< and as many as a frame has cascades, once a frame has more
};

/// Layer G-buffers, each with a depth buffer and drawn by one cascade at a time, and the accumulated G-buffer
/// they are merged into. As many cascades as there are layers are drawn with no barrier in between, then
/// merged, and so on. The farthest go first, so that what is merged later lies on top: the nearest surface
/// wins, as in `single`, bit for bit. These are three methods of the thesis:
/// - 2, `accumulate`: one layer.
/// - 3, `pool`: a few, so neighbouring cascades need not wait for each other on the device.
/// - 4, `layers`: one per cascade.
class CascadeLayers final : public Targets {
  public:
    CascadeLayers(const gpu::Device& device, const TargetsOptions& options, const LayerCount& count);

    void record(CascadeCommands& commands, const FrameView& view) override;
    const gpu::Image& gbuffer() const override { return m_accumulated; }
    const gpu::Image* emission() const override { return m_accumulatedEmission.get(); }

  private:
    /// Adds layers until there are `layers`; those that are there stay. So commands that use them may still
    /// run. base::RunError, with both figures and before anything is allocated, when memory does not suffice.
    void grow(std::size_t layers);
    struct Layer {
        gpu::Image gbuffer;
        std::unique_ptr<gpu::Image> emission; ///< null without
        gpu::Image depth;
        PassInputs source;
    };
    Layer makeLayer(std::size_t number) const;
    void drawLayers(CascadeCommands& commands, std::span<const std::size_t> cascades) const;
    /// @param layers what each layer holds.
    void mergeLayers(vk::CommandBuffer primary, std::span<const shaders::LayerPush> layers,
                     vk::AttachmentLoadOp load) const;

    const gpu::Device& m_device;
    TargetsOptions m_options;
    bool m_perCascade;
    FullscreenPass m_merge; ///< lays a layer over the accumulated G-buffer, unchanged
    gpu::Image m_accumulated;
    std::unique_ptr<gpu::Image> m_accumulatedEmission; ///< null without
    std::unique_ptr<ScopeCommands> m_zeroFill;         ///< of layers; null where the device clears quickly
    std::vector<Layer> m_layers;
};

} // namespace cdr::render
