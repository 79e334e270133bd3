#pragma once

#include <cdr/depth/mapping.h>
#include <cdr/gpu/memory.h>
#include <cdr/render/gbuffer.h>
#include <cdr/render/view_transform.h>
#include <cdr/scene/scene.h>

#include <vulkan/vulkan.hpp>

#include <span>

namespace cdr::render {

/// The final pass: reads the G-buffer, sums ambient and point lights, writes an sRGB picture.
class ShadingPass {
  public:
    ShadingPass(const gpu::Device& device, const scene::Scene& scene, const gpu::Image& gbuffer,
                vk::Extent2D extent);

    /// Uploads this frame's lights and anchors; the last frame that used them must have finished.
    void update(const scene::Scene& scene, const scene::Camera& camera, const Lens& lens,
                std::span<const double> anchorsView);

    /// Takes the G-buffer from colour attachment to shader read layout and leaves picture() in transfer
    /// source layout.
    void record(vk::CommandBuffer primary) const;

    const gpu::Image& picture() const { return m_picture; }

    static std::uint64_t predictBytes(vk::Extent2D extent);

  private:
    const gpu::Device& m_device;
    const gpu::Image& m_gbuffer;
    gpu::Image m_picture;
    gpu::Buffer m_uniforms;
    vk::UniqueSampler m_sampler;
    vk::UniqueDescriptorSetLayout m_setLayout;
    vk::UniqueDescriptorPool m_pool;
    vk::DescriptorSet m_set;
    vk::UniquePipelineLayout m_layout;
    vk::UniquePipeline m_pipeline;
};

} // namespace cdr::render
