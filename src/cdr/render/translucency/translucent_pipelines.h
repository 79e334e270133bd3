#pragma once

#include <cdr/render/draw_source.h>

#include <vulkan/vulkan.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace cdr::render {

/// What one method of translucency draws with.
struct TranslucentPipelinesOptions {
    std::string name;
    std::span<const std::uint32_t> fragmentSpirv;
    std::vector<vk::DescriptorSetLayout> sets; ///< from set 1 on; set 0 is the texture
    std::vector<vk::Format> colorFormats;      ///< all blended as gpu::Blend::accumulate
};

/// The pipelines that draw translucent surfaces: no depth buffer, blended.
class TranslucentPipelines {
  public:
    TranslucentPipelines(const gpu::Device& device, const GpuScene& scene,
                         const TranslucentPipelinesOptions& options);

    vk::PipelineLayout layout() const { return *m_layout; }
    vk::Pipeline pipeline(const DrawKind& kind) const {
        return *m_pipelines[(kind.variant & kTexturedVariant) != 0 ? 1 : 0];
    }

    static constexpr auto kStages = vk::ShaderStageFlagBits::eVertex | vk::ShaderStageFlagBits::eFragment;

  private:
    vk::UniquePipelineLayout m_layout;
    std::array<vk::UniquePipeline, 2> m_pipelines; ///< plain, textured
};

} // namespace cdr::render
