#include "host.h"

#include <array>
#include <stdexcept>

Host::Host(vk::PhysicalDevice physical, vk::Device device, vk::Extent2D extent)
    : m_physical(physical),
      m_device(device),
      m_extent(extent) {}

vk::UniqueDeviceMemory Host::allocate(const vk::MemoryRequirements& needs,
                                      vk::MemoryPropertyFlags properties) const {
    const vk::PhysicalDeviceMemoryProperties memory = m_physical.getMemoryProperties();
    for (std::uint32_t i = 0; i < memory.memoryTypeCount; ++i) {
        if ((needs.memoryTypeBits >> i & 1u) != 0 &&
            (memory.memoryTypes[i].propertyFlags & properties) == properties) {
            return m_device.allocateMemoryUnique({.allocationSize = needs.size, .memoryTypeIndex = i});
        }
    }
    throw std::runtime_error("no memory of this type");
}

HostImage Host::makeImage(vk::Format format, vk::ImageUsageFlags usage, vk::ImageAspectFlags aspect) const {
    HostImage made;
    made.image = m_device.createImageUnique({.imageType = vk::ImageType::e2D,
                                             .format = format,
                                             .extent = {m_extent.width, m_extent.height, 1},
                                             .mipLevels = 1,
                                             .arrayLayers = 1,
                                             .usage = usage});
    made.memory = allocate(m_device.getImageMemoryRequirements(*made.image), {});
    m_device.bindImageMemory(*made.image, *made.memory, 0);
    made.view = m_device.createImageViewUnique({.image = *made.image,
                                                .viewType = vk::ImageViewType::e2D,
                                                .format = format,
                                                .subresourceRange = {aspect, 0, 1, 0, 1}});
    return made;
}

HostBuffer Host::makeReadBuffer(vk::DeviceSize bytes) const {
    HostBuffer made;
    made.buffer =
        m_device.createBufferUnique({.size = bytes, .usage = vk::BufferUsageFlagBits::eTransferDst});
    made.memory =
        allocate(m_device.getBufferMemoryRequirements(*made.buffer),
                 vk::MemoryPropertyFlagBits::eHostVisible | vk::MemoryPropertyFlagBits::eHostCoherent);
    m_device.bindBufferMemory(*made.buffer, *made.memory, 0);
    made.mapped = m_device.mapMemory(*made.memory, 0, bytes);
    return made;
}

vk::UniquePipeline Host::makePipeline(const HostPipelineOptions& options) const {
    const auto shader = [&](std::span<const std::uint32_t> spirv) {
        return m_device.createShaderModuleUnique({.codeSize = spirv.size_bytes(), .pCode = spirv.data()});
    };
    const vk::UniqueShaderModule vertex = shader(options.vertex);
    const vk::UniqueShaderModule fragment = shader(options.fragment);
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
    const vk::PipelineDepthStencilStateCreateInfo depth{
        .depthTestEnable = true, .depthWriteEnable = true, .depthCompareOp = options.compare};
    const vk::PipelineColorBlendAttachmentState all{.colorWriteMask =
                                                        vk::FlagTraits<vk::ColorComponentFlagBits>::allFlags};
    const vk::PipelineColorBlendStateCreateInfo blend{.attachmentCount = 1, .pAttachments = &all};
    const vk::PipelineRenderingCreateInfo rendering{.colorAttachmentCount = 1,
                                                    .pColorAttachmentFormats = &options.colorFormat,
                                                    .depthAttachmentFormat = options.depthFormat};
    return m_device
        .createGraphicsPipelineUnique({}, {.pNext = &rendering,
                                           .stageCount = stages.size(),
                                           .pStages = stages.data(),
                                           .pVertexInputState = &noInput,
                                           .pInputAssemblyState = &strip,
                                           .pViewportState = &one,
                                           .pRasterizationState = &raster,
                                           .pMultisampleState = &oneSample,
                                           .pDepthStencilState = &depth,
                                           .pColorBlendState = &blend,
                                           .pDynamicState = &dynamic,
                                           .layout = options.layout})
        .value;
}
