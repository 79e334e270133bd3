#pragma once

#include <cdr/gpu/device.h>
#include <cdr/gpu/shared.h>
#include <cdr/gpu/vulkan_hpp.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace cdr::gpu {

class Buffer;

/// A shader in SPIR-V.
struct Spirv {
    std::vector<std::uint32_t> words;

    Spirv() = default;
    explicit Spirv(std::vector<std::uint32_t> read) : words(std::move(read)) {}
    template <std::size_t N>
    // NOLINTNEXTLINE(google-explicit-constructor): the headers that the build makes of shaders hold arrays
    Spirv(const std::uint32_t (&array)[N]) : words(array, array + N) {}

    bool operator==(const Spirv&) const = default;
};

/// What the layout of a descriptor set is made from: binding i has the i-th type, one descriptor each.
struct SetLayoutOptions {
    std::vector<vk::DescriptorType> types;
    vk::ShaderStageFlags stages;

    bool operator==(const SetLayoutOptions&) const = default;
};

/// Shared by all that were made from equal options.
struct SetLayout : Shared<vk::UniqueDescriptorSetLayout> {
    SetLayout() = default;
    SetLayout(Shared shared, std::vector<vk::DescriptorType> bound)
        : Shared(std::move(shared)),
          types(std::move(bound)) {}

    std::vector<vk::DescriptorType> types; ///< as SetLayoutOptions has them
};

/// What the layout of pipelines is made from.
struct PipelineLayoutOptions {
    std::vector<SetLayout> sets;
    std::vector<vk::PushConstantRange> constants;

    bool operator==(const PipelineLayoutOptions&) const = default;
};

/// Shared as a SetLayout is.
using PipelineLayout = Shared<vk::UniquePipelineLayout>;
/// Shared as a SetLayout is.
using Pipeline = Shared<vk::UniquePipeline>;

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
    Spirv vertexSpirv;
    Spirv fragmentSpirv{}; ///< empty: depth alone is written
    /// Specialisation constants 0, 1, ... of both stages.
    std::vector<std::uint32_t> constants{};
    PipelineLayout layout;
    std::vector<vk::VertexInputBindingDescription> bindings{};
    std::vector<vk::VertexInputAttributeDescription> attributes{};
    std::vector<vk::Format> colorFormats{};
    /// Of the depth attachment; eUndefined: there is none.
    vk::Format depthFormat = vk::Format::eUndefined;
    Stencil stencil = Stencil::none;
    bool usesDepth = true;   ///< tests, writes and clamps depth where there is an attachment
    bool writesDepth = true; ///< where it tests; else the attachment stays as it is
    vk::CompareOp depthCompare = vk::CompareOp::eLessOrEqual;
    bool hasDepthBias = false; ///< set by setDepthBias(), dynamic
    Blend blend = Blend::none; ///< of every attachment

    bool operator==(const GraphicsPipelineOptions&) const = default;
};

/// What a compute pipeline is made from.
struct ComputePipelineOptions {
    std::string name;
    Spirv spirv;
    PipelineLayout layout;

    bool operator==(const ComputePipelineOptions&) const = default;
};

/// The layouts and pipelines of one device.
struct PipelineObjects {
    SharedObjects<SetLayoutOptions, vk::UniqueDescriptorSetLayout> setLayouts;
    SharedObjects<PipelineLayoutOptions, vk::UniquePipelineLayout> layouts;
    SharedObjects<GraphicsPipelineOptions, vk::UniquePipeline> graphics;
    SharedObjects<ComputePipelineOptions, vk::UniquePipeline> compute;
};

/// Those that renderers of the device share while they are there.
PipelineObjects& pipelineObjects(const Device& device);

/// From now on each pipeline stays until releasePipelines() or the device's end, for a program that makes one renderer
/// after the other. Compiling is most of what a renderer of a small scene costs.
void keepPipelines(const Device& device);

/// Keeps none any more: those that no renderer has are destroyed.
void releasePipelines(const Device& device);

Pipeline makeGraphicsPipeline(const Device& device, const GraphicsPipelineOptions& options);

Pipeline makeComputePipeline(const Device& device, const ComputePipelineOptions& options);

/// base::RunError with both figures when a dispatch for `what` has more groups in a row than the device runs.
void requireGroups(const Device& device, std::uint64_t groups, const std::string& what);

/// Binds a pipeline whose vertex shader covers the picture with one triangle, and sets its dynamic state.
void bindFullscreenPipeline(vk::CommandBuffer commands, vk::Pipeline pipeline, vk::Extent2D extent);

/// @param name for captures and messages; that of the first where several are equal.
PipelineLayout makePipelineLayout(const Device& device, const PipelineLayoutOptions& options,
                                  const std::string& name);

/// @param name as of makePipelineLayout().
SetLayout makeSetLayout(const Device& device, const SetLayoutOptions& options, const std::string& name);

/// A pool with room for so many sets of a layout.
vk::UniqueDescriptorPool makeDescriptorPool(const Device& device, const SetLayout& layout,
                                            std::uint32_t sets);

vk::DescriptorSet allocateSet(const Device& device, vk::DescriptorPool pool, const SetLayout& layout);

/// A descriptor set in a pool of its own. Nothing is bound at first.
class DescriptorSet {
  public:
    DescriptorSet() = default;
    /// The device must outlive it.
    DescriptorSet(const Device& device, const SetLayout& layout);

    /// The null handle where there is none.
    vk::DescriptorSet operator*() const { return m_set; }

    /// Points a binding at a whole buffer, at a view of a buffer's texels, or at an image that shaders read.
    void setBuffer(std::uint32_t binding, const Buffer& buffer) const;
    void setTexels(std::uint32_t binding, vk::BufferView texels) const;
    void setImage(std::uint32_t binding, vk::ImageView view, vk::Sampler sampler) const;

  private:
    void write(std::uint32_t binding, vk::WriteDescriptorSet what) const;

    const Device* m_device = nullptr;
    std::vector<vk::DescriptorType> m_types; ///< by binding
    vk::UniqueDescriptorPool m_pool;
    vk::DescriptorSet m_set;
};

} // namespace cdr::gpu
