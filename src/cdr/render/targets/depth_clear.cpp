#include <cdr/render/targets/depth_clear.h>
#include <cdr/render/targets/targets.h>

namespace cdr::render {

DepthClear::DepthClear(const gpu::Device& device, const TargetsOptions& options)
    : m_extent(options.extent),
      m_zNdc(options.reversedDepth ? 0.0f : 1.0f),
      m_secondary(device, options, [this](vk::CommandBuffer commands) { record(commands); }) {}

void DepthClear::record(vk::CommandBuffer commands) const {
    commands.clearAttachments(vk::ClearAttachment{.aspectMask = vk::ImageAspectFlagBits::eDepth,
                                                  .clearValue = vk::ClearDepthStencilValue{.depth = m_zNdc}},
                              vk::ClearRect{.rect = {{0, 0}, m_extent}, .layerCount = 1});
}

} // namespace cdr::render
