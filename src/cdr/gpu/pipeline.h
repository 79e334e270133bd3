#pragma once

#include <cdr/gpu/device.h>
#include <cdr/gpu/vulkan_hpp.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace cdr::gpu {

/// How a pipeline's colour is combined with the attachment's.
enum class Blend : std::uint8_t {
    none,       ///< replaces it
    accumulate, ///< colour is added; the attachment's alpha is multiplied by 1 - alpha
    over,       ///< the attachment times alpha, plus colour; alpha is transmittance
    least,      ///< the lesser of both stays, in each channel
};

/// What a pipeline does with the stencil plane of its depth attachment.
enum class Stencil : std::uint8_t {
    none,       ///< there is none, or it is not attached
    marks,      ///< sets it to 1 where a fragment passes the depth test
    testsMarks, ///< shades only where it is 1; then the attachment's depth is not attached
};

/// What a graphics pipeline is made from; viewport, scissor, cull mode and front face stay dynamic.
struct GraphicsPipelineOptions {
    std::string name;
    std::span<const std::uint32_t> vertexSpirv;
    std::span<const std::uint32_t> fragmentSpirv; ///< empty: depth alone is written
    /// Specialisation constants 0, 1, ... of both stages.
    std::vector<std::uint32_t> constants;
    vk::PipelineLayout layout;
    std::vector<vk::VertexInputBindingDescription> bindings;
    std::vector<vk::VertexInputAttributeDescription> attributes;
    std::vector<vk::Format> colorFormats;
    /// Of the depth attachment; eUndefined: there is none.
    vk::Format depthFormat = vk::Format::eUndefined;
    Stencil stencil = Stencil::none;
    bool usesDepth = true; ///< tests, writes and clamps depth where there is an attachment
    vk::CompareOp depthCompare = vk::CompareOp::eLessOrEqual;
    bool hasDepthBias = false; ///< set by setDepthBias(), dynamic
    Blend blend = Blend::none; ///< of every attachment
};

vk::UniquePipeline makeGraphicsPipeline(const Device& device, const GraphicsPipelineOptions& options);

vk::UniquePipeline makeComputePipeline(const Device& device, std::span<const std::uint32_t> spirv,
                                       vk::PipelineLayout layout, const std::string& name);

/// Binds a pipeline whose vertex shader covers the picture with one triangle, and sets its dynamic state.
void bindFullscreenPipeline(vk::CommandBuffer commands, vk::Pipeline pipeline, vk::Extent2D extent);

vk::UniquePipelineLayout makePipelineLayout(const Device& device,
                                            const std::vector<vk::DescriptorSetLayout>& sets,
                                            const std::vector<vk::PushConstantRange>& constants,
                                            const std::string& name);

/// A descriptor set layout whose binding i has the i-th type, one descriptor each.
vk::UniqueDescriptorSetLayout makeSetLayout(const Device& device,
                                            const std::vector<vk::DescriptorType>& types,
                                            vk::ShaderStageFlags stages, const std::string& name);

/// A pool with room for `sets` descriptor sets that hold `perSet` of each descriptor type named.
vk::UniqueDescriptorPool makeDescriptorPool(const Device& device, std::uint32_t sets, std::uint32_t perSet,
                                            const std::vector<vk::DescriptorType>& types);

vk::DescriptorSet allocateSet(const Device& device, vk::DescriptorPool pool, vk::DescriptorSetLayout layout);

/// Points a binding at a whole buffer, at a view of a buffer's texels, or at an image that shaders read.
void writeBufferBinding(const Device& device, vk::DescriptorSet set, std::uint32_t binding,
                        vk::DescriptorType type, vk::Buffer buffer);
void writeTexelBinding(const Device& device, vk::DescriptorSet set, std::uint32_t binding,
                       vk::DescriptorType type, vk::BufferView texels);
void writeImageBinding(const Device& device, vk::DescriptorSet set, std::uint32_t binding,
                       vk::DescriptorType type, vk::ImageView view, vk::Sampler sampler);

} // namespace cdr::gpu
