#include <cdr/base/format_error.h>
#include <cdr/gpu/memory.h>
#include <cdr/gpu/pipeline.h>

#include <array>

namespace cdr::gpu {

namespace {

vk::UniqueShaderModule makeModule(const Device& device, const Spirv& spirv) {
    return vk::Device(device.handle())
        .createShaderModuleUnique(
            {.codeSize = spirv.words.size() * sizeof(std::uint32_t), .pCode = spirv.words.data()});
}

/// Constants 0, 1, ... laid out one after the other.
struct Specialization {
    std::vector<vk::SpecializationMapEntry> entries;
    vk::SpecializationInfo info;

    explicit Specialization(const std::vector<std::uint32_t>& constants) {
        for (std::uint32_t i = 0; i < constants.size(); ++i) {
            entries.push_back({.constantID = i, .offset = 4 * i, .size = 4});
        }
        info = {.mapEntryCount = static_cast<std::uint32_t>(entries.size()),
                .pMapEntries = entries.data(),
                .dataSize = constants.size() * 4,
                .pData = constants.data()};
    }
};

vk::PipelineColorBlendAttachmentState blendState(Blend blend) {
    using Factor = vk::BlendFactor;
    constexpr auto kAll = vk::ColorComponentFlagBits::eR | vk::ColorComponentFlagBits::eG |
                          vk::ColorComponentFlagBits::eB | vk::ColorComponentFlagBits::eA;
    switch (blend) {
    case Blend::accumulate:
        return {.blendEnable = true,
                .srcColorBlendFactor = Factor::eOne,
                .dstColorBlendFactor = Factor::eOne,
                .srcAlphaBlendFactor = Factor::eZero,
                .dstAlphaBlendFactor = Factor::eOneMinusSrcAlpha,
                .colorWriteMask = kAll};
    case Blend::over:
        return {.blendEnable = true,
                .srcColorBlendFactor = Factor::eOne,
                .dstColorBlendFactor = Factor::eSrcAlpha,
                .srcAlphaBlendFactor = Factor::eZero,
                .dstAlphaBlendFactor = Factor::eOne,
                .colorWriteMask = kAll};
    case Blend::least:
        return {.blendEnable = true,
                .colorBlendOp = vk::BlendOp::eMin,
                .alphaBlendOp = vk::BlendOp::eMin,
                .colorWriteMask = kAll};
    case Blend::none:
        break;
    }
    return {.colorWriteMask = kAll};
}

vk::StencilOpState stencilState(Stencil stencil) {
    const bool marks = stencil == Stencil::marks;
    return {.failOp = vk::StencilOp::eKeep,
            .passOp = marks ? vk::StencilOp::eReplace : vk::StencilOp::eKeep,
            .depthFailOp = vk::StencilOp::eKeep,
            .compareOp = marks ? vk::CompareOp::eAlways : vk::CompareOp::eEqual,
            .compareMask = 0xff,
            .writeMask = marks ? 0xffu : 0u,
            .reference = 1};
}

bool attachesDepth(const GraphicsPipelineOptions& options) {
    return options.stencil != Stencil::testsMarks;
}

bool hasDepth(const GraphicsPipelineOptions& options) {
    return options.usesDepth && attachesDepth(options) && options.depthFormat != vk::Format::eUndefined;
}

vk::PipelineDepthStencilStateCreateInfo depthState(const GraphicsPipelineOptions& options) {
    return {.depthTestEnable = hasDepth(options),
            .depthWriteEnable = hasDepth(options) && options.writesDepth,
            .depthCompareOp = options.depthCompare,
            .stencilTestEnable = options.stencil != Stencil::none,
            .front = stencilState(options.stencil),
            .back = stencilState(options.stencil)};
}

std::vector<vk::DynamicState> dynamicStatesOf(const GraphicsPipelineOptions& options) {
    std::vector<vk::DynamicState> states{vk::DynamicState::eViewport, vk::DynamicState::eScissor,
                                         vk::DynamicState::eCullMode, vk::DynamicState::eFrontFace};
    if (options.hasDepthBias) {
        states.push_back(vk::DynamicState::eDepthBias);
    }
    return states;
}

/// @param options whose formats it refers to.
vk::PipelineRenderingCreateInfo renderingOf(const GraphicsPipelineOptions& options) {
    return {.colorAttachmentCount = static_cast<std::uint32_t>(options.colorFormats.size()),
            .pColorAttachmentFormats = options.colorFormats.data(),
            .depthAttachmentFormat = attachesDepth(options) ? options.depthFormat : vk::Format::eUndefined,
            .stencilAttachmentFormat =
                options.stencil != Stencil::none ? options.depthFormat : vk::Format::eUndefined};
}

vk::UniquePipeline createGraphicsPipeline(const Device& device, const GraphicsPipelineOptions& options) {
    const vk::UniqueShaderModule vertex = makeModule(device, options.vertexSpirv);
    const bool isShaded = !options.fragmentSpirv.words.empty();
    const vk::UniqueShaderModule fragment =
        isShaded ? makeModule(device, options.fragmentSpirv) : vk::UniqueShaderModule();
    const Specialization constants(options.constants);
    const std::array stages{
        vk::PipelineShaderStageCreateInfo{.stage = vk::ShaderStageFlagBits::eVertex,
                                          .module = *vertex,
                                          .pName = "main",
                                          .pSpecializationInfo = &constants.info},
        vk::PipelineShaderStageCreateInfo{.stage = vk::ShaderStageFlagBits::eFragment,
                                          .module = *fragment,
                                          .pName = "main",
                                          .pSpecializationInfo = &constants.info},
    };
    const vk::PipelineVertexInputStateCreateInfo vertexInput{
        .vertexBindingDescriptionCount = static_cast<std::uint32_t>(options.bindings.size()),
        .pVertexBindingDescriptions = options.bindings.data(),
        .vertexAttributeDescriptionCount = static_cast<std::uint32_t>(options.attributes.size()),
        .pVertexAttributeDescriptions = options.attributes.data()};
    const vk::PipelineInputAssemblyStateCreateInfo assembly{.topology = vk::PrimitiveTopology::eTriangleList};
    const vk::PipelineViewportStateCreateInfo viewport{.viewportCount = 1, .scissorCount = 1};
    const vk::PipelineRasterizationStateCreateInfo raster{
        .depthClampEnable = hasDepth(options), .depthBiasEnable = options.hasDepthBias, .lineWidth = 1.0f};
    const vk::PipelineMultisampleStateCreateInfo multisample{};
    const vk::PipelineDepthStencilStateCreateInfo depth = depthState(options);
    const std::vector<vk::PipelineColorBlendAttachmentState> blends(options.colorFormats.size(),
                                                                    blendState(options.blend));
    const vk::PipelineColorBlendStateCreateInfo blend{
        .attachmentCount = static_cast<std::uint32_t>(blends.size()), .pAttachments = blends.data()};
    const std::vector<vk::DynamicState> dynamicStates = dynamicStatesOf(options);
    const vk::PipelineDynamicStateCreateInfo dynamic{.dynamicStateCount =
                                                         static_cast<std::uint32_t>(dynamicStates.size()),
                                                     .pDynamicStates = dynamicStates.data()};
    const vk::PipelineRenderingCreateInfo rendering = renderingOf(options);
    auto [result, pipeline] =
        vk::Device(device.handle())
            .createGraphicsPipelineUnique(device.pipelineCache(), {.pNext = &rendering,
                                                                   .stageCount = isShaded ? 2u : 1u,
                                                                   .pStages = stages.data(),
                                                                   .pVertexInputState = &vertexInput,
                                                                   .pInputAssemblyState = &assembly,
                                                                   .pViewportState = &viewport,
                                                                   .pRasterizationState = &raster,
                                                                   .pMultisampleState = &multisample,
                                                                   .pDepthStencilState = &depth,
                                                                   .pColorBlendState = &blend,
                                                                   .pDynamicState = &dynamic,
                                                                   .layout = *options.layout});
    vk::resultCheck(result, "vkCreateGraphicsPipelines");
    device.setName(*pipeline, options.name);
    return std::move(pipeline);
}

vk::UniquePipeline createComputePipeline(const Device& device, const ComputePipelineOptions& options) {
    const vk::UniqueShaderModule shader = makeModule(device, options.spirv);
    auto [result, pipeline] =
        vk::Device(device.handle())
            .createComputePipelineUnique(
                device.pipelineCache(),
                {.stage = {.stage = vk::ShaderStageFlagBits::eCompute, .module = *shader, .pName = "main"},
                 .layout = *options.layout});
    vk::resultCheck(result, "vkCreateComputePipelines");
    device.setName(*pipeline, options.name);
    return std::move(pipeline);
}

vk::UniquePipelineLayout createPipelineLayout(const Device& device, const PipelineLayoutOptions& options) {
    std::vector<vk::DescriptorSetLayout> sets;
    for (const SetLayout& set : options.sets) {
        sets.push_back(*set);
    }
    return vk::Device(device.handle())
        .createPipelineLayoutUnique(
            {.setLayoutCount = static_cast<std::uint32_t>(sets.size()),
             .pSetLayouts = sets.data(),
             .pushConstantRangeCount = static_cast<std::uint32_t>(options.constants.size()),
             .pPushConstantRanges = options.constants.data()});
}

vk::UniqueDescriptorSetLayout createSetLayout(const Device& device, const SetLayoutOptions& options) {
    std::vector<vk::DescriptorSetLayoutBinding> bindings;
    for (const vk::DescriptorType type : options.types) {
        bindings.push_back({.binding = static_cast<std::uint32_t>(bindings.size()),
                            .descriptorType = type,
                            .descriptorCount = 1,
                            .stageFlags = options.stages});
    }
    return vk::Device(device.handle())
        .createDescriptorSetLayoutUnique(
            {.bindingCount = static_cast<std::uint32_t>(bindings.size()), .pBindings = bindings.data()});
}

} // namespace

void keepPipelines(const Device& device) {
    pipelineObjects(device).graphics.keep();
    pipelineObjects(device).compute.keep();
}

void releasePipelines(const Device& device) {
    pipelineObjects(device).graphics.release();
    pipelineObjects(device).compute.release();
}

Pipeline makeGraphicsPipeline(const Device& device, const GraphicsPipelineOptions& options) {
    return pipelineObjects(device).graphics.get(
        options, [&](const auto& wanted) { return createGraphicsPipeline(device, wanted); });
}

Pipeline makeComputePipeline(const Device& device, const ComputePipelineOptions& options) {
    return pipelineObjects(device).compute.get(
        options, [&](const auto& wanted) { return createComputePipeline(device, wanted); });
}

PipelineLayout makePipelineLayout(const Device& device, const PipelineLayoutOptions& options,
                                  const std::string& name) {
    return pipelineObjects(device).layouts.get(options, [&](const auto& wanted) {
        vk::UniquePipelineLayout layout = createPipelineLayout(device, wanted);
        device.setName(*layout, name);
        return layout;
    });
}

SetLayout makeSetLayout(const Device& device, const SetLayoutOptions& options, const std::string& name) {
    const auto made = pipelineObjects(device).setLayouts.get(options, [&](const auto& wanted) {
        vk::UniqueDescriptorSetLayout layout = createSetLayout(device, wanted);
        device.setName(*layout, name);
        return layout;
    });
    return {made, options.types};
}

void requireGroups(const Device& device, std::uint64_t groups, const std::string& what) {
    const std::uint32_t most =
        vk::PhysicalDevice(device.physical()).getProperties().limits.maxComputeWorkGroupCount[0];
    if (groups > most) {
        throw base::runError("{} needs {} groups of a compute shader, {} runs {}", what, groups,
                             device.info().name, most);
    }
}

void bindFullscreenPipeline(vk::CommandBuffer commands, vk::Pipeline pipeline, vk::Extent2D extent) {
    commands.bindPipeline(vk::PipelineBindPoint::eGraphics, pipeline);
    commands.setViewport(0, vk::Viewport{0.0f, 0.0f, static_cast<float>(extent.width),
                                         static_cast<float>(extent.height), 0.0f, 1.0f});
    commands.setScissor(0, vk::Rect2D{{0, 0}, extent});
    commands.setCullMode(vk::CullModeFlagBits::eNone);
    commands.setFrontFace(vk::FrontFace::eCounterClockwise);
}

vk::UniqueDescriptorPool makeDescriptorPool(const Device& device, const SetLayout& layout,
                                            std::uint32_t sets) {
    std::vector<vk::DescriptorPoolSize> sizes;
    for (const vk::DescriptorType type : layout.types) {
        sizes.push_back({.type = type, .descriptorCount = sets});
    }
    return vk::Device(device.handle())
        .createDescriptorPoolUnique({.maxSets = sets,
                                     .poolSizeCount = static_cast<std::uint32_t>(sizes.size()),
                                     .pPoolSizes = sizes.data()});
}

vk::DescriptorSet allocateSet(const Device& device, vk::DescriptorPool pool, const SetLayout& layout) {
    const vk::DescriptorSetLayout handle = *layout;
    return vk::Device(device.handle())
        .allocateDescriptorSets({.descriptorPool = pool, .descriptorSetCount = 1, .pSetLayouts = &handle})
        .front();
}

DescriptorSet::DescriptorSet(const Device& device, const SetLayout& layout)
    : m_device(&device),
      m_types(layout.types),
      m_pool(makeDescriptorPool(device, layout, 1)),
      m_set(allocateSet(device, *m_pool, layout)) {}

void DescriptorSet::write(std::uint32_t binding, vk::WriteDescriptorSet what) const {
    what.dstSet = m_set;
    what.dstBinding = binding;
    what.descriptorCount = 1;
    what.descriptorType = m_types.at(binding);
    vk::Device(m_device->handle()).updateDescriptorSets(what, {});
}

void DescriptorSet::setBuffer(std::uint32_t binding, const Buffer& buffer) const {
    const vk::DescriptorBufferInfo info{.buffer = buffer.handle(), .range = VK_WHOLE_SIZE};
    write(binding, {.pBufferInfo = &info});
}

void DescriptorSet::setTexels(std::uint32_t binding, vk::BufferView texels) const {
    write(binding, {.pTexelBufferView = &texels});
}

void DescriptorSet::setImage(std::uint32_t binding, vk::ImageView view, vk::Sampler sampler) const {
    const vk::DescriptorImageInfo info{
        .sampler = sampler, .imageView = view, .imageLayout = vk::ImageLayout::eShaderReadOnlyOptimal};
    write(binding, {.pImageInfo = &info});
}

} // namespace cdr::gpu
