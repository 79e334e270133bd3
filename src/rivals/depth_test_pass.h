#pragma once

#include <cdr/gpu/memory.h>
#include <cdr/gpu/pipeline.h>
#include <cdr/render/geometry/geometry_pipelines.h>
#include <cdr/render/output/readback.h>

#include <rivals/visibility_pass.h>

namespace cdr::rivals {

/// Today's practice: a depth buffer that the device tests, cleared between cascades, and one colour of 8 bytes.
class DepthTestPass final : public VisibilityPass {
  public:
    /// base::InputError for a depth format that the device lacks.
    DepthTestPass(const gpu::Device& device, const depth::Technique& technique, vk::Extent2D extent);

    void record(vk::CommandBuffer commands, const FrameDraws& draws) override;
    void recordReadback(vk::CommandBuffer commands) override;
    FramePixels fetch(const render::FrameView& view) const override;

  private:
    gpu::Pipeline makePipeline(const gpu::Device& device, render::Span span) const;

    depth::Mapping m_mapping;
    gpu::Image m_surfaces;
    gpu::Image m_depth;
    render::Readback m_readback;
    gpu::PipelineLayout m_layout;
    gpu::Pipeline m_compact;
    gpu::Pipeline m_wide;
};

} // namespace cdr::rivals
