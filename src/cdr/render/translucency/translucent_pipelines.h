#pragma once

#include <cdr/gpu/pipeline.h>
#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/render/draw_source.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace cdr::render {

class UploadedScene;

/// How a method of translucency is made.
struct BlendOptions {
    bool countsFragments = false;
    bool receivesShadows = false;        ///< the surroundings hold TranslucentShadows then
    std::vector<std::uint32_t> variants; ///< TranslucentPipelinesOptions::variants
};

/// What one method of translucency draws with.
struct TranslucentPipelinesOptions {
    std::string name;
    bool receivesShadows = false; ///< push constants hold a TranslucentSlice too
    gpu::Spirv fragmentSpirv{};
    gpu::Spirv detailedSpirv{};             ///< the same for materials with detail
    std::vector<gpu::SetLayout> sets;       ///< from set 1 on; set 0 is the texture, the last one the detail
    std::vector<vk::Format> colorFormats{}; ///< all blended as gpu::Blend::accumulate
    std::vector<std::uint32_t> variants{};  ///< that have pipelines from the start, beside those of the scene
};

/// A method's fragment shaders, for materials without and with detail.
struct BlendShader {
    gpu::Spirv plain;
    gpu::Spirv detailed;
};

/// A method's fragment shaders by whether they receive shadows. All count fragments into the last image, if it is there.
struct BlendShaders {
    BlendShader lit;
    BlendShader shadowed;
};

/// `options` with those of `shaders` that `blend` asks for.
TranslucentPipelinesOptions withShaders(TranslucentPipelinesOptions options, const BlendOptions& blend,
                                        const BlendShaders& shaders);

/// The pipelines that draw translucent surfaces: no depth buffer, blended.
class TranslucentPipelines {
  public:
    TranslucentPipelines(const gpu::Device& device, const UploadedScene& scene,
                         const TranslucentPipelinesOptions& options);

    vk::PipelineLayout layout() const { return *m_layout; }
    /// Those of variants that were given, and of the blended instances that the scene had at first, are there. Any other is
    /// made when first asked for.
    vk::Pipeline pipeline(const DrawKind& kind) const;
    /// Which set DrawKind::detailSet is.
    std::uint32_t detailSet() const { return m_detailSet; }

    static constexpr auto kStages = vk::ShaderStageFlagBits::eVertex | vk::ShaderStageFlagBits::eFragment;

  private:
    gpu::Pipeline make(std::uint32_t key) const;
    vk::Pipeline provide(std::uint32_t key) const;

    const gpu::Device& m_device;
    const UploadedScene& m_scene;
    TranslucentPipelinesOptions m_options;
    std::uint32_t m_detailSet;
    gpu::PipelineLayout m_layout;
    mutable std::map<std::uint32_t, gpu::Pipeline> m_pipelines; ///< by key, made when first needed
};

} // namespace cdr::render
