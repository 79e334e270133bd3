#pragma once

#include <cdr/gpu/device.h>
#include <cdr/gpu/pipeline.h>
#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/render/geometry/geometry_pipelines.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace cdr::render {

/// The pipelines of one technique over facets, for any GeometryOutput.
class FacetPipelines {
  public:
    static constexpr std::uint32_t kVertexBinding = 0;
    /// Of FacetLight's values, for GeometryOutput::lit.
    static constexpr std::uint32_t kLitBinding = 1;

    /// Those of GeometryOutput::lit are made for each number of lights that there may be.
    FacetPipelines(const gpu::Device& device, const GeometryOptions& options);

    /// @param lights FacetLight::litBy(), without meaning but for GeometryOutput::lit.
    vk::Pipeline pipeline(Span span, std::size_t lights) const;
    vk::PipelineLayout layout() const { return *m_layout; }
    /// Of the scope that they draw in.
    ScopeFormats formats() const;
    const GeometryOptions& options() const { return m_options; }

  private:
    struct Spans {
        gpu::Pipeline compact;
        gpu::Pipeline wide;
    };
    /// Of the colour attachment; eUndefined where there is none.
    vk::Format surfaceFormat() const;
    /// @param lights 0 where facets are not lit.
    gpu::Pipeline make(const gpu::Device& device, Span span, std::uint32_t lights) const;
    gpu::Pipeline makeOccluder(const gpu::Device& device, Span span) const;
    std::vector<std::uint32_t> constantsOf(Span span, std::uint32_t form) const;

    GeometryOptions m_options;
    vk::Format m_depthFormat;
    gpu::PipelineLayout m_layout;
    std::vector<Spans> m_pipelines; ///< by the number of lights where facets are lit; else one
};

} // namespace cdr::render
