#pragma once

#include <cdr/gpu/memory.h>
#include <cdr/gpu/pipeline.h>
#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/render/shadows/caster_draws.h>

namespace cdr::render {

/// What a light sees of one view: the depth of the nearest surfaces, and how they slope. One map serves all views in turn.
class ShadowMap {
  public:
    /// @param side most texels of a view's sides.
    ShadowMap(const gpu::Device& device, std::uint32_t side);

    /// Draws a view, waiting for whoever read the map before. Leaves both images in the shader read layout.
    /// @param index of the view in `draws`.
    void record(vk::CommandBuffer primary, const LightView& view, const CasterDraws& draws,
                std::size_t index) const;

    const gpu::Image& depth() const { return m_depth; }
    const gpu::Image& slope() const { return m_slope; }

    static std::uint64_t predictBytes(const gpu::Device& device, std::uint32_t side);

  private:
    gpu::Image m_depth;
    gpu::Image m_slope;
    gpu::PipelineLayout m_layout;
    gpu::Pipeline m_pipeline;
};

} // namespace cdr::render
