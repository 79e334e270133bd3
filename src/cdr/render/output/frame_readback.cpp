#include <cdr/gpu/commands.h>
#include <cdr/render/output/frame_readback.h>

namespace cdr::render {

namespace {

/// Hands an image that fragment shaders read to copies.
vk::ImageMemoryBarrier2 copyBarrier(const gpu::Image& image) {
    return gpu::imageBarrier(image.handle(), vk::ImageAspectFlagBits::eColor,
                             vk::PipelineStageFlagBits2::eFragmentShader,
                             vk::AccessFlagBits2::eShaderSampledRead, vk::PipelineStageFlagBits2::eCopy,
                             vk::AccessFlagBits2::eTransferRead, vk::ImageLayout::eShaderReadOnlyOptimal,
                             vk::ImageLayout::eTransferSrcOptimal);
}

} // namespace

FrameReadback::FrameReadback(const gpu::Device& device, vk::Extent2D extent, const RenderOptions& options)
    : m_color(device, extent, sizeof(image::Rgba8), "color copy"),
      m_gbuffer(device, extent, sizeof(GBufferPixel), "G-buffer copy") {
    if (options.motion) {
        m_motion.emplace(device, extent, sizeof(glm::vec2), "motion copy");
    }
    if (options.shadows.isOn()) {
        m_shadowMask.emplace(device, extent, sizeof(image::Rgba8), "shadow mask copy");
    }
}

std::uint64_t FrameReadback::predictBytes(const gpu::Device& device, vk::Extent2D extent,
                                          const RenderOptions& options) {
    const std::size_t bytesPerPixel = sizeof(image::Rgba8) + sizeof(GBufferPixel) +
                                      (options.motion ? sizeof(glm::vec2) : 0) +
                                      (options.shadows.isOn() ? sizeof(image::Rgba8) : 0);
    return Readback::predictBytes(device, extent, bytesPerPixel);
}

void FrameReadback::record(vk::CommandBuffer primary, const Images& images, FrameCopy copy) const {
    m_color.record(primary, images.color);
    if (copy == FrameCopy::color) {
        return;
    }
    gpu::pipelineBarrier(primary, {copyBarrier(images.gbuffer)});
    m_gbuffer.record(primary, images.gbuffer);
    if (m_motion) {
        m_motion->record(primary, *images.motion);
    }
    if (m_shadowMask) {
        gpu::pipelineBarrier(primary, {copyBarrier(*images.shadowMask)});
        m_shadowMask->record(primary, *images.shadowMask);
    }
}

void FrameReadback::fetch(FrameCopy copy, Frame& frame) const {
    frame.color = m_color.fetch<image::Rgba8>();
    if (copy == FrameCopy::color) {
        return;
    }
    frame.gbuffer = m_gbuffer.fetch<GBufferPixel>();
    if (m_motion) {
        frame.motion = m_motion->fetch<glm::vec2>();
    }
    if (m_shadowMask) {
        frame.litMask = m_shadowMask->fetch<image::Rgba8>();
    }
}

} // namespace cdr::render
