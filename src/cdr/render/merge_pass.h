#pragma once

#include <cdr/gpu/device.h>
#include <cdr/render/gbuffer.h>

#include <vulkan/vulkan.hpp>

#include <span>

namespace cdr::render {

/// A fullscreen pass that lays layer G-buffers over an accumulated one: wherever a layer is not background,
/// its bits replace those below, unchanged.
class MergePass {
  public:
    explicit MergePass(const gpu::Device& device);

    /// What the pass reads one layer through; freed with it.
    struct Source {
        vk::UniqueDescriptorPool pool;
        vk::DescriptorSet set;
    };
    Source makeSource(const gpu::Image& layer) const;

    /// One rendering scope that lays the sources over `into`, in their order. The sources are in the shader
    /// read layout, `into` is in the colour attachment layout.
    /// @param load eClear to begin from background, eLoad to lay over what `into` holds.
    void record(vk::CommandBuffer primary, std::span<const vk::DescriptorSet> sources, const gpu::Image& into,
                vk::AttachmentLoadOp load) const;

  private:
    const gpu::Device& m_device;
    vk::UniqueSampler m_sampler;
    vk::UniqueDescriptorSetLayout m_setLayout;
    vk::UniquePipelineLayout m_layout;
    vk::UniquePipeline m_pipeline;
};

} // namespace cdr::render
