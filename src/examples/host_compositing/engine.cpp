#include "engine.h"

#include <array>
#include <cstdint>
#include <stdexcept>

// clang-format off: what glslangValidator writes needs <cstdint>
#include "surface_frag.h"
#include "surface_vert.h"
// clang-format on

namespace gpu = cdr::gpu;

vk::UniqueDeviceMemory allocate(const gpu::Device& device, const vk::MemoryRequirements& needs,
                                vk::MemoryPropertyFlags wanted) {
    const vk::PhysicalDeviceMemoryProperties memory =
        vk::PhysicalDevice(device.physical()).getMemoryProperties();
    for (std::uint32_t i = 0; i < memory.memoryTypeCount; ++i) {
        if ((needs.memoryTypeBits >> i & 1u) != 0 &&
            (memory.memoryTypes[i].propertyFlags & wanted) == wanted) {
            return vk::Device(device.handle())
                .allocateMemoryUnique({.allocationSize = needs.size, .memoryTypeIndex = i});
        }
    }
    throw std::runtime_error("no memory of this type");
}

HostImage makeImage(const gpu::Device& device, vk::Extent2D extent, vk::Format format,
                    vk::ImageUsageFlags usage, vk::ImageAspectFlags aspect) {
    HostImage made;
    made.image = vk::Device(device.handle())
                     .createImageUnique({.imageType = vk::ImageType::e2D,
                                         .format = format,
                                         .extent = {extent.width, extent.height, 1},
                                         .mipLevels = 1,
                                         .arrayLayers = 1,
                                         .usage = usage});
    made.memory = allocate(device, vk::Device(device.handle()).getImageMemoryRequirements(*made.image), {});
    vk::Device(device.handle()).bindImageMemory(*made.image, *made.memory, 0);
    made.view = vk::Device(device.handle())
                    .createImageViewUnique({.image = *made.image,
                                            .viewType = vk::ImageViewType::e2D,
                                            .format = format,
                                            .subresourceRange = {aspect, 0, 1, 0, 1}});
    return made;
}

vk::UniquePipeline makePipeline(vk::Device device, vk::PipelineLayout layout) {
    const vk::UniqueShaderModule vertex =
        device.createShaderModuleUnique({.codeSize = sizeof(surface_vert), .pCode = surface_vert});
    const vk::UniqueShaderModule fragment =
        device.createShaderModuleUnique({.codeSize = sizeof(surface_frag), .pCode = surface_frag});
    const std::array stages{
        vk::PipelineShaderStageCreateInfo{
            .stage = vk::ShaderStageFlagBits::eVertex, .module = *vertex, .pName = "main"},
        vk::PipelineShaderStageCreateInfo{
            .stage = vk::ShaderStageFlagBits::eFragment, .module = *fragment, .pName = "main"}};
    const vk::PipelineVertexInputStateCreateInfo noInput{};
    const vk::PipelineInputAssemblyStateCreateInfo strip{.topology = vk::PrimitiveTopology::eTriangleStrip};
    const vk::PipelineViewportStateCreateInfo one{.viewportCount = 1, .scissorCount = 1};
    constexpr std::array kDynamic{vk::DynamicState::eViewport, vk::DynamicState::eScissor};
    const vk::PipelineDynamicStateCreateInfo dynamic{.dynamicStateCount = kDynamic.size(),
                                                     .pDynamicStates = kDynamic.data()};
    const vk::PipelineRasterizationStateCreateInfo raster{.depthClampEnable = true, .lineWidth = 1.0f};
    const vk::PipelineMultisampleStateCreateInfo oneSample{};
    const vk::PipelineDepthStencilStateCreateInfo tested{
        .depthTestEnable = true, .depthWriteEnable = true, .depthCompareOp = vk::CompareOp::eLessOrEqual};
    const vk::PipelineColorBlendAttachmentState all{.colorWriteMask =
                                                        vk::FlagTraits<vk::ColorComponentFlagBits>::allFlags};
    const vk::PipelineColorBlendStateCreateInfo blend{.attachmentCount = 1, .pAttachments = &all};
    constexpr auto kGBufferFormat = vk::Format::eR32G32B32A32Uint;
    const vk::PipelineRenderingCreateInfo rendering{.colorAttachmentCount = 1,
                                                    .pColorAttachmentFormats = &kGBufferFormat,
                                                    .depthAttachmentFormat = vk::Format::eD32Sfloat};
    const vk::GraphicsPipelineCreateInfo info{.pNext = &rendering,
                                              .stageCount = stages.size(),
                                              .pStages = stages.data(),
                                              .pVertexInputState = &noInput,
                                              .pInputAssemblyState = &strip,
                                              .pViewportState = &one,
                                              .pRasterizationState = &raster,
                                              .pMultisampleState = &oneSample,
                                              .pDepthStencilState = &tested,
                                              .pColorBlendState = &blend,
                                              .pDynamicState = &dynamic,
                                              .layout = layout};
    return device.createGraphicsPipelineUnique({}, info).value;
}
