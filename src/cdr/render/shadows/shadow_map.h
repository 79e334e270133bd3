#pragma once

#include <cdr/gpu/memory.h>
#include <cdr/gpu/pipeline.h>
#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/render/shadows/caster_draws.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace cdr::render {

/// A view as a part of a map.
struct ShadowMapPart {
    const LightView& view;
    std::size_t index = 0; ///< of the view in the draws
    vk::Offset2D corner{}; ///< of its first texel; parts do not overlap
};

/// What lights see of some views: the depth of the nearest surfaces, and how they slope. One map serves all views in turn.
class ShadowMap {
  public:
    /// @param textures UploadedScene::textureLayout() of the casters. @param side texels of the map's sides.
    ShadowMap(const gpu::Device& device, const gpu::SetLayout& textures, std::uint32_t side);

    /// Draws views, if any, waiting for whoever read the map before. Leaves both images in the shader read layout.
    void record(vk::CommandBuffer primary, std::span<const ShadowMapPart> parts,
                const CasterDraws& draws) const;

    const gpu::Image& depth() const { return m_depth; }
    const gpu::Image& slope() const { return m_slope; }

    std::uint32_t side() const { return m_depth.options().extent.width; }
    static std::uint64_t predictBytes(const gpu::Device& device, std::uint32_t side);

  private:
    void draw(vk::CommandBuffer primary, std::span<const ShadowMapPart> parts,
              const CasterDraws& draws) const;

    gpu::Image m_depth;
    gpu::Image m_slope;
    gpu::PipelineLayout m_layout;
    gpu::Pipeline m_solid;
    gpu::Pipeline m_masked;
};

} // namespace cdr::render
