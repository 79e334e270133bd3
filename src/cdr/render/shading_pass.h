#pragma once

#include <cdr/depth/mapping.h>
#include <cdr/gpu/memory.h>
#include <cdr/render/gbuffer.h>
#include <cdr/render/view_transform.h>
#include <cdr/scene/scene.h>

#include <vulkan/vulkan.hpp>

#include <span>

namespace cdr::render {

/// What the final pass reads besides the G-buffer: one frame slot's lights and anchors.
class ShadingInputs {
  public:
    /// Uploads a frame's; the last frame that used them must have finished.
    void update(const scene::Scene& scene, const scene::Camera& camera, const Lens& lens,
                std::span<const double> anchorsView);

  private:
    friend class ShadingPass;
    gpu::Buffer m_uniforms;
    vk::UniqueDescriptorPool m_pool;
    vk::DescriptorSet m_set;
};

/// The final pass: reads the G-buffer, sums ambient and point lights, writes an sRGB picture.
class ShadingPass {
  public:
    ShadingPass(const gpu::Device& device, const gpu::Image& gbuffer, vk::Extent2D extent);

    /// Inputs for as many lights as the scene has.
    ShadingInputs makeInputs(const scene::Scene& scene) const;

    /// Takes the G-buffer from colour attachment to shader read layout and leaves picture() in transfer
    /// source layout.
    void record(vk::CommandBuffer primary, const ShadingInputs& inputs) const;

    const gpu::Image& picture() const { return m_picture; }

    static std::uint64_t predictBytes(vk::Extent2D extent);

  private:
    const gpu::Device& m_device;
    const gpu::Image& m_gbuffer;
    gpu::Image m_picture;
    vk::UniqueSampler m_sampler;
    vk::UniqueDescriptorSetLayout m_setLayout;
    vk::UniquePipelineLayout m_layout;
    vk::UniquePipeline m_pipeline;
};

} // namespace cdr::render
