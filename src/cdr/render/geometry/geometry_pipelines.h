#pragma once

#include <cdr/depth/technique.h>
#include <cdr/gpu/pipeline.h>
#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/render/draw_source.h>
#include <cdr/render/effects.h>
#include <cdr/render/geometry/batching.h>
#include <cdr/render/layer_options.h>
#include <cdr/render/targets/gbuffer_rendering.h>

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace cdr::render {

class UploadedScene;

/// What draws write.
enum class GeometryOutput : std::uint8_t {
    surfaces, ///< what shading needs, and depth by the technique
    depth,    ///< near / view distance alone, at the same pixels: render::occluderView()
    lit,      ///< the picture, and depth by the technique; of facets alone
};

/// How surfaces are drawn.
struct GeometryOptions {
    GeometryOutput output = GeometryOutput::surfaces;
    depth::Technique technique;
    Batching batching = Batching::instanced;
    bool metallicRoughness = false; ///< whether surfaces keep it; else all are matt
    bool emission = false;          ///< whether surfaces keep what they emit, in an emission buffer
    /// Vertices in front of the camera are rounded to multiples of 1 / snapSteps of half a picture; 0: not.
    glm::vec2 snapSteps{0.0f};
    glm::vec2 subPixels{0.0f};      ///< in half a picture, of Snapping::inPlane; 0: by the device
    std::uint32_t subPixelBits = 8; ///< to which vertices are rounded, by the device or by snapSteps
    LayerOptions layers{};
    Finish finish{};                       ///< of GeometryOutput::lit
    std::vector<std::uint32_t> variants{}; ///< that have pipelines from the start, beside those of the scene
};

/// Instances that span more than this share of their distance are drawn wide: cut, and for log given their
/// depth, per fragment. Infinity for none.
double wideSpan(depth::Mapping mapping, std::size_t cascades);

/// How an instance is drawn: wide beyond wideSpan().
enum class Span : std::uint8_t { compact, wide };

/// How pipelines of a mapping form depth: shaders::kDepthFormLinear and its siblings.
std::uint32_t depthFormOf(depth::Mapping mapping, Span span);

/// The clear value fails this comparison by nothing but equality.
vk::CompareOp depthCompareOf(depth::Mapping mapping);

/// The pipelines of one technique over one scene.
class GeometryPipelines {
  public:
    GeometryPipelines(const gpu::Device& device, const UploadedScene& scene, const GeometryOptions& options);

    /// Makes those of draw kinds that came to the scene; those that are there stay.
    void follow(const gpu::Device& device, const UploadedScene& scene);

    vk::PipelineLayout layout() const { return *m_layout; }
    depth::Mapping mapping() const { return m_options.technique.mapping; }
    const LayerOptions& layers() const { return m_options.layers; }
    /// Of a variant that some kind of the scene has.
    vk::Pipeline pipeline(std::uint32_t variant, Span span) const {
        return *(span == Span::wide ? m_wide : m_compact)[told(variant)];
    }

    /// Of the scope that they draw in.
    ScopeFormats formats() const;

    /// Of the depth attachment of GeometryOutput::depth.
    static constexpr auto kOccluderFormat = vk::Format::eD32Sfloat;
    /// The vertex buffer of draw records, one per instance.
    static constexpr std::uint32_t kRecordBinding = 1;
    static constexpr auto kStages = vk::ShaderStageFlagBits::eVertex | vk::ShaderStageFlagBits::eFragment;

  private:
    using Pipelines = std::array<gpu::Pipeline, kPipelineVariants>; ///< empty where no kind needs one
    /// Without kPlanesVariant where the device rounds vertices.
    std::uint32_t told(std::uint32_t variant) const {
        return m_options.subPixels.x > 0.0f ? variant : variant & ~kPlanesVariant;
    }
    void provide(const gpu::Device& device, std::uint32_t ofKind);
    gpu::Pipeline makeSurfaces(const gpu::Device& device, std::uint32_t variant, Span span) const;
    gpu::Pipeline makeOccluder(const gpu::Device& device, Span span) const;

    GeometryOptions m_options;
    vk::Format m_depthFormat;
    gpu::PipelineLayout m_layout;
    Pipelines m_compact;
    Pipelines m_wide;
};

} // namespace cdr::render
