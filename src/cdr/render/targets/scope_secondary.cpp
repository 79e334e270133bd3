#include <cdr/render/targets/scope_secondary.h>
#include <cdr/render/targets/targets.h>

#include <utility>

namespace cdr::render {

ScopeSecondary::ScopeSecondary(const gpu::Device& device, const TargetsOptions& options,
                               const std::function<void(vk::CommandBuffer)>& record)
    : m_pool(
          vk::Device(device.handle()).createCommandPoolUnique({.queueFamilyIndex = device.queueFamily()})) {
    m_commands = std::move(vk::Device(device.handle())
                               .allocateCommandBuffersUnique({.commandPool = *m_pool,
                                                              .level = vk::CommandBufferLevel::eSecondary,
                                                              .commandBufferCount = 1})
                               .front());
    const std::vector<vk::Format> colors = surfaceFormats(options);
    const vk::Format depth = depthAttachmentFormat(device, options.depthFormat, options.format);
    const vk::CommandBufferInheritanceRenderingInfo rendering{
        .colorAttachmentCount = static_cast<std::uint32_t>(colors.size()),
        .pColorAttachmentFormats = colors.data(),
        .depthAttachmentFormat = depth,
        .stencilAttachmentFormat = marksDrawn(depth, options.format) ? depth : vk::Format::eUndefined,
        .rasterizationSamples = vk::SampleCountFlagBits::e1};
    const vk::CommandBufferInheritanceInfo inheritance{.pNext = &rendering};
    m_commands->begin({.flags = vk::CommandBufferUsageFlagBits::eRenderPassContinue |
                                vk::CommandBufferUsageFlagBits::eSimultaneousUse,
                       .pInheritanceInfo = &inheritance});
    record(*m_commands);
    m_commands->end();
}

} // namespace cdr::render
