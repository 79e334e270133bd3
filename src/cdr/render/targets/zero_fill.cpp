#include <cdr/gpu/pipeline.h>
#include <cdr/render/targets/targets.h>
#include <cdr/render/targets/zero_fill.h>
#include <cdr/shaders/shading.h>
#include <cdr/shaders/targets.h>

namespace cdr::render {

ZeroFill::ZeroFill(const gpu::Device& device, const TargetsOptions& options)
    : m_extent(options.extent),
      m_layout(gpu::makePipelineLayout(device, {}, "zero fill layout")),
      m_pipeline(gpu::makeGraphicsPipeline(
          device, {.name = "zero fill",
                   .vertexSpirv = kFullscreenVert,
                   .fragmentSpirv = kZeroFillFrag,
                   .layout = m_layout,
                   .colorFormats = surfaceFormats(options),
                   .depthFormat = vk::Format(device.depthFormat(options.depthFormat)),
                   .usesDepth = false})),
      m_secondary(device, options, [this](vk::CommandBuffer commands) { record(commands); }) {}

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
