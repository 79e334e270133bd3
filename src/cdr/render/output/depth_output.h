#pragma once

#include <cdr/gpu/pipeline.h>
#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/render/host_frame.h>
#include <cdr/render/shading/shading_pass.h>

#include <utility>

namespace cdr::render {

/// The format of the depth images that hosts hand in.
inline constexpr vk::Format kHostDepthFormat = vk::Format::eD32Sfloat;

/// Turns a G-buffer into the depth of a host's own camera.
class DepthOutput {
  public:
    explicit DepthOutput(const gpu::Device& device);

    /// What one frame in flight reads.
    class Inputs {
        friend class DepthOutput;
        Inputs(vk::UniqueDescriptorPool pool, vk::DescriptorSet set) : m_pool(std::move(pool)), m_set(set) {}

        vk::UniqueDescriptorPool m_pool;
        vk::DescriptorSet m_set;
    };
    Inputs makeInputs(const gpu::Image& gbuffer, const ShadingInputs& shading) const;

    /// Reads the G-buffer in shader read layout, and leaves the host's image in the layout that it names.
    void record(vk::CommandBuffer primary, const Inputs& inputs, const HostDepth& into) const;

  private:
    const gpu::Device& m_device;
    vk::UniqueSampler m_sampler;
    gpu::SetLayout m_setLayout;
    gpu::PipelineLayout m_layout;
    gpu::Pipeline m_pipeline;
};

} // namespace cdr::render
