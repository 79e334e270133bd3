#include <cdr/gpu/pipeline.h>
#include <cdr/render/targets/targets.h>
#include <cdr/render/targets/zero_fill.h>
#include <cdr/shaders/fullscreen_vert.h>
#include <cdr/shaders/zero_fill_frag.h>

#include <utility>

namespace cdr::render {

namespace {

/// Of the colour attachments of a scope over a G-buffer.
std::vector<vk::Format> surfaceFormats(const TargetsOptions& options) {
    return options.emission ? std::vector{options.format, kEmissionFormat} : std::vector{options.format};
}

} // namespace

ZeroFill::ZeroFill(const gpu::Device& device, const TargetsOptions& options)
    : m_extent(options.extent),
      m_layout(gpu::makePipelineLayout(device, {}, "zero fill layout")),
      m_pipeline(gpu::makeGraphicsPipeline(
          device, {.name = "zero fill",
                   .vertexSpirv = kFullscreenVert,
                   .fragmentSpirv = kZeroFillFrag,
                   .constants = {},
                   .layout = m_layout,
                   .bindings = {},
                   .attributes = {},
                   .colorFormats = surfaceFormats(options),
                   .depthFormat = vk::Format(device.depthFormat(options.depthFormat)),
                   .usesDepth = false})),
      m_pool(
          vk::Device(device.handle()).createCommandPoolUnique({.queueFamilyIndex = device.queueFamily()})) {
    m_secondary = std::move(vk::Device(device.handle())
                                .allocateCommandBuffersUnique({.commandPool = *m_pool,
                                                               .level = vk::CommandBufferLevel::eSecondary,
                                                               .commandBufferCount = 1})
                                .front());
    const std::vector<vk::Format> formats = surfaceFormats(options);
    const vk::CommandBufferInheritanceRenderingInfo rendering{
        .colorAttachmentCount = static_cast<std::uint32_t>(formats.size()),
        .pColorAttachmentFormats = formats.data(),
        .depthAttachmentFormat = vk::Format(device.depthFormat(options.depthFormat)),
        .rasterizationSamples = vk::SampleCountFlagBits::e1};
    const vk::CommandBufferInheritanceInfo inheritance{.pNext = &rendering};
    // Frames in flight, and the layers of one frame, execute it again.
    m_secondary->begin({.flags = vk::CommandBufferUsageFlagBits::eRenderPassContinue |
                                 vk::CommandBufferUsageFlagBits::eSimultaneousUse,
                        .pInheritanceInfo = &inheritance});
    record(*m_secondary);
    m_secondary->end();
}

void ZeroFill::record(vk::CommandBuffer commands) const {
    gpu::bindFullscreenPipeline(commands, *m_pipeline, m_extent);
    commands.draw(3, 1, 0, 0);
}

std::unique_ptr<ZeroFill> makeZeroFill(const gpu::Device& device, const TargetsOptions& options) {
    const bool isClearedSlowly =
        device.info().kind == gpu::DeviceKind::cpu && options.format == kGBufferFormat;
    return isClearedSlowly ? std::make_unique<ZeroFill>(device, options) : nullptr;
}

} // namespace cdr::render
