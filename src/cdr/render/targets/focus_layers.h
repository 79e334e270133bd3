#pragma once

#include <cdr/render/effects.h>
#include <cdr/render/shading/fullscreen_pass.h>
#include <cdr/render/shading/shading_pass.h>
#include <cdr/render/targets/targets.h>

#include <array>
#include <map>
#include <vector>

namespace cdr::render {

/// What lighting each layer reads in one frame slot.
class FocusInputs {
  private:
    friend class FocusLayers;
    std::map<const gpu::Image*, PassInputs> m_ofLayer; ///< by G-buffer
};

/// How FocusLayers light and compose.
struct FocusLayersOptions {
    Effects effects{};
    glm::vec3 background{0.0f};     ///< linear, what is seen where nothing is
    bool fades = false;             ///< lets cascades that overlap fade into each other
    bool sky = false;               ///< whether the scene has one
    bool metallicRoughness = false; ///< whether the surfaces hold it
};

/// Depth of field by per-cascade resolution (thesis chapter 3). Each cascade has a layer of the size that
/// CascadeView::extent says, drawn and lit by itself. Lit layers are laid over each other, the farthest
/// first, each filtered up to the picture. Surfaces are merged as `layers` merges them, so that what reads
/// the G-buffer later still finds every pixel's nearest.
class FocusLayers final : public Targets {
  public:
    /// @param into the linear image that light() writes.
    FocusLayers(const gpu::Device& device, const TargetsOptions& options, const gpu::Image& into,
                const FocusLayersOptions& focus);

    void record(CascadeCommands& commands, const FrameView& view) override;
    const gpu::Image& gbuffer() const override { return m_merged; }

    /// Lights what record() drew and composes the picture. Takes gbuffer() from colour attachment to shader
    /// read layout and leaves the picture in colour attachment layout.
    void light(vk::CommandBuffer primary, const ShadingInputs& shading, FocusInputs& inputs) const;

  private:
    struct Layer {
        gpu::Image gbuffer;
        gpu::Image depth;
        gpu::Image lit;    ///< colour times opacity, and transmittance
        PassInputs merged; ///< what merging reads
        PassInputs laid;   ///< what composing reads
    };
    /// A layer that record() drew.
    struct Drawn {
        const Layer* layer;
        shaders::LayerFade fade;
    };
    /// Cascade, width and height.
    using LayerKey = std::array<std::uint32_t, 3>;
    static LayerKey keyOf(const FrameView& view, std::size_t cascade);
    void provideLayers(const FrameView& view);
    Layer makeLayer(vk::Extent2D extent, const std::string& name) const;
    void mergeGBuffers(vk::CommandBuffer primary) const;
    /// What lighting a layer reads, made where the slot has none yet.
    vk::DescriptorSet setOf(const Layer& layer, const ShadingInputs& shading, FocusInputs& inputs) const;
    void lightLayers(vk::CommandBuffer primary, const ShadingInputs& shading, FocusInputs& inputs) const;

    const gpu::Device& m_device;
    TargetsOptions m_options;
    const gpu::Image& m_into;
    glm::vec3 m_background;
    bool m_fades;
    FullscreenPass m_merge;
    FullscreenPass m_light;
    FullscreenPass m_compose;
    gpu::Image m_merged;
    /// Made when first needed and kept, since frames in flight may use them. Sides halve, so all of a
    /// cascade's take a third more than its largest.
    std::map<LayerKey, Layer> m_layers;
    std::vector<Drawn> m_drawn; ///< by the last record(), farthest first
};

} // namespace cdr::render
