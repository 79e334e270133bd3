#pragma once

#include <cdr/depth/mapping.h>
#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/render/effects.h>
#include <cdr/render/frame_view.h>
#include <cdr/render/shading/anchor_form.h>
#include <cdr/render/shading/fullscreen_pass.h>
#include <cdr/render/shading/occlusion_pass.h>
#include <cdr/scene/scene.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <tuple>

namespace cdr::render {

/// What lighting reads besides surfaces: one frame slot's lights, anchors and effects.
class ShadingInputs {
  public:
    /// The records that a visibility buffer refers to; the last frame that used these inputs must have finished.
    void setFacets(vk::BufferView facets) { m_inputs.setTexels(kFacetsBinding, facets); }
    static constexpr std::uint32_t kFacetsBinding = 2;

    /// shaders::ShadingHeader and the lights, as shaders/shading/lighting.glsl reads them.
    const gpu::Buffer& lights() const { return m_lights; }

  private:
    friend class ShadingPass;
    std::uint32_t m_lightForm = 0; ///< lightFormOf() the scene
    std::size_t m_cascades = 0;    ///< of the frame
    glm::vec3 m_background{0.0f};  ///< linear; where no surface is, as the picture has it
    gpu::Buffer m_lights;
    PassInputs m_inputs;
    PassInputs m_occlusion; ///< where it is worked out over the whole picture
};

/// How the shading pass reads a scene's lights: their number up to shaders::kFlatLights, which cost least, or
/// shaders::kManyLights, or shaders::kShapedLights.
std::uint32_t lightFormOf(const scene::Scene& scene);

/// What a ShadingPass is made for.
struct ShadingOptions {
    Effects effects;
    bool metallicRoughness = false;       ///< whether the surfaces hold it
    depth::Mapping mapping{};             ///< which says whether there are anchor planes
    bool sky = false;                     ///< whether the scene has one
    bool air = false;                     ///< whether the scene has some; then without marks
    bool finishes = false;                ///< whether no later step does what Effects::finish says
    const gpu::Image* emission = nullptr; ///< Targets::emission()
    bool facets = false; ///< whether surfaces come from a visibility buffer; then effects hold no occlusion
    const gpu::Image* marks = nullptr;   ///< Targets::marks()
    const gpu::Image* shadows = nullptr; ///< ShadowPass::mask(); null: lights reach everything
    std::uint32_t lightForm = 0;         ///< lightFormOf() the scene at first
    std::uint32_t preparedLights = 0;    ///< PrepareFor::lights
    bool preparedShapes = false;         ///< PrepareFor::shapedLights
};

/// Deferred shading: reads the final G-buffer, sums ambient and point lights, less what occlusion and fog
/// take.
class ShadingPass {
  public:
    /// @param gbuffer or the visibility buffer. @param into what record() writes.
    ShadingPass(const gpu::Device& device, const gpu::Image& gbuffer, const gpu::Image& into,
                const ShadingOptions& options);

    /// Most lights that a buffer of a device has room for.
    static std::size_t maxLights(const gpu::Device& device);
    /// Inputs for at most so many lights. base::RunError, with both numbers, for more than maxLights().
    ShadingInputs makeInputs(std::size_t lights) const;
    /// Uploads a frame's, of a scene with no more lights than there is room for; the last frame that used them must have finished.
    void update(ShadingInputs& inputs, const scene::Scene& scene, const FrameView& view) const;

    /// Takes the G-buffer from colour attachment to shader read layout. Comes before record().
    void begin(vk::CommandBuffer primary, const ShadingInputs& inputs) const;
    /// Leaves the image that it writes in colour attachment layout.
    void record(vk::CommandBuffer primary, const ShadingInputs& inputs);

    /// Device bytes of what the effects keep between passes.
    static std::uint64_t predictBytes(vk::Extent2D extent, const Effects& effects);

  private:
    const gpu::Device& m_device;
    const gpu::Image& m_gbuffer;
    const gpu::Image& m_into;
    ShadingOptions m_options;
    std::unique_ptr<OcclusionPass> m_occlusion; ///< null unless it is for the whole picture
    /// What a pipeline is compiled for: lightFormOf(), and where anchor planes are read.
    struct Form {
        std::uint32_t lights = 0;
        AnchorForm anchors = AnchorForm::none;

        bool operator<(const Form& other) const {
            return std::tie(lights, anchors) < std::tie(other.lights, other.anchors);
        }
    };
    /// @param lightForm for a number of lights. @param cascades of the frame.
    FullscreenPass& passFor(std::uint32_t lightForm, std::size_t cascades);
    /// For a number of lights, in frames of few cascades and of many.
    void prepare(std::uint32_t lightForm);
    /// Made when first needed; the inputs of one suit all.
    std::map<Form, FullscreenPass> m_passes;
};

} // namespace cdr::render
