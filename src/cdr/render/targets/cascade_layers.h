#pragma once

#include <cdr/render/shading/fullscreen_pass.h>
#include <cdr/render/targets/targets.h>

#include <span>
#include <vector>

namespace cdr::render {

/// Layer G-buffers, each with a depth buffer and drawn by one cascade at a time, and the accumulated G-buffer
/// they are merged into: what methods 2 to 4 of the thesis share.
class CascadeLayers {
  public:
    /// @param layers to begin with. base::RunError, with both figures, when memory does not suffice.
    CascadeLayers(const gpu::Device& device, const TargetsOptions& options, std::size_t layers);

    /// Adds layers until there are `layers`; those that are there stay, so commands that use them may still
    /// run. base::RunError, with both figures and before anything is allocated, when memory does not suffice.
    void grow(std::size_t layers);

    /// Draws as many cascades as there are layers with no barrier in between, merges them, and so on. The
    /// farthest go first, so that what is merged later lies on top: the nearest surface wins, as in `single`,
    /// bit for bit.
    void record(CascadeCommands& commands, const FrameView& view) const;

    const gpu::Image& accumulated() const { return m_accumulated; }

  private:
    struct Layer {
        gpu::Image gbuffer;
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
    FullscreenPass m_merge; ///< lays a layer over the accumulated G-buffer, unchanged
    gpu::Image m_accumulated;
    std::vector<Layer> m_layers;
};

} // namespace cdr::render
