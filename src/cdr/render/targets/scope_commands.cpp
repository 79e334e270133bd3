#include <cdr/gpu/pipeline.h>
#include <cdr/render/targets/gbuffer_rendering.h>
#include <cdr/render/targets/scope_commands.h>
#include <cdr/render/targets/targets.h>
#include <cdr/shaders/shading.h>
#include <cdr/shaders/targets.h>

#include <utility>

namespace cdr::render {

ScopeCommands::ScopeCommands(const gpu::Device& device, const TargetsOptions& options, Record record)
    : m_record(std::move(record)),
      m_pool(
          vk::Device(device.handle()).createCommandPoolUnique({.queueFamilyIndex = device.queueFamily()})) {
    m_secondary = std::move(vk::Device(device.handle())
                                .allocateCommandBuffersUnique({.commandPool = *m_pool,
                                                               .level = vk::CommandBufferLevel::eSecondary,
                                                               .commandBufferCount = 1})
                                .front());
    beginSecondary(*m_secondary,
                   {.colors = surfaceFormats(options),
                    .depth = depthAttachmentFormat(device, options.depthFormat, options.format)},
                   vk::CommandBufferUsageFlagBits::eSimultaneousUse);
    m_record(*m_secondary);
    m_secondary->end();
}

void ScopeCommands::putInto(vk::CommandBuffer commands, vk::RenderingFlags flags) const {
    if (flags & vk::RenderingFlagBits::eContentsSecondaryCommandBuffers) {
        commands.executeCommands(*m_secondary);
    } else {
        m_record(commands);
    }
}

ScopeCommands makeDepthClear(const gpu::Device& device, const TargetsOptions& options) {
    const vk::ClearAttachment farthest{
        .aspectMask = vk::ImageAspectFlagBits::eDepth,
        .clearValue = vk::ClearDepthStencilValue{.depth = options.reversedDepth ? 0.0f : 1.0f}};
    const vk::ClearRect all{.rect = {{0, 0}, options.extent}, .layerCount = 1};
    return {device, options,
            [farthest, all](vk::CommandBuffer commands) { commands.clearAttachments(farthest, all); }};
}

std::unique_ptr<ScopeCommands> makeZeroFill(const gpu::Device& device, const TargetsOptions& options) {
    if (device.info().kind != gpu::DeviceKind::cpu || options.format != kGBufferFormat) {
        return nullptr;
    }
    const gpu::Pipeline pipeline =
        gpu::makeGraphicsPipeline(device, {.name = "zero fill",
                                           .vertexSpirv = kFullscreenVert,
                                           .fragmentSpirv = kZeroFillFrag,
                                           .layout = gpu::makePipelineLayout(device, {}, "zero fill layout"),
                                           .colorFormats = surfaceFormats(options),
                                           .depthFormat = vk::Format(device.depthFormat(options.depthFormat)),
                                           .usesDepth = false});
    return std::make_unique<ScopeCommands>(device, options,
                                           [pipeline, extent = options.extent](vk::CommandBuffer commands) {
                                               gpu::bindFullscreenPipeline(commands, *pipeline, extent);
                                               commands.draw(3, 1, 0, 0);
                                           });
}

} // namespace cdr::render
