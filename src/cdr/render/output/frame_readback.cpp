#include <cdr/gpu/commands.h>
#include <cdr/render/output/frame_readback.h>
#include <cdr/render/targets/gbuffer_rendering.h>

#include <glm/gtc/packing.hpp>

#include <algorithm>

namespace cdr::render {

namespace {

/// Four half floats.
using LinearPixel = std::uint64_t;

image::Raster<glm::vec3> lightOf(const image::Raster<LinearPixel>& copied) {
    image::Raster<glm::vec3> light(copied.width, copied.height);
    std::transform(copied.pixels.begin(), copied.pixels.end(), light.pixels.begin(),
                   [](LinearPixel pixel) { return glm::vec3(glm::unpackHalf4x16(pixel)); });
    return light;
}

} // namespace

FrameReadback::FrameReadback(const gpu::Device& device, vk::Extent2D extent, const RenderOptions& options)
    : m_color(device, extent, sizeof(image::Rgba8), "color copy"),
      m_gbuffer(device, extent, sizeof(GBufferPixel), "G-buffer copy") {
    if (options.linear) {
        m_linear.emplace(device, extent, sizeof(LinearPixel), "linear copy");
    }
    if (options.motion) {
        m_motion.emplace(device, extent, sizeof(glm::vec2), "motion copy");
    }
    if (options.shadows.isOn()) {
        m_shadowMask.emplace(device, extent, sizeof(image::Rgba8), "shadow mask copy");
    }
}

std::uint64_t FrameReadback::predictBytes(const gpu::Device& device, vk::Extent2D extent,
                                          const RenderOptions& options) {
    const std::size_t bytesPerPixel =
        sizeof(image::Rgba8) + sizeof(GBufferPixel) + (options.linear ? sizeof(LinearPixel) : 0) +
        (options.motion ? sizeof(glm::vec2) : 0) + (options.shadows.isOn() ? sizeof(image::Rgba8) : 0);
    return Readback::predictBytes(device, extent, bytesPerPixel);
}

void FrameReadback::record(vk::CommandBuffer primary, const Images& images, FrameCopy copy) const {
    m_color.record(primary, images.color);
    if (copy == FrameCopy::color) {
        return;
    }
    gpu::pipelineBarrier(primary, {copyBarrier(images.gbuffer)});
    m_gbuffer.record(primary, images.gbuffer);
    if (m_linear) {
        m_linear->record(primary, *images.linear);
    }
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
    if (m_linear) {
        frame.linear = lightOf(m_linear->fetch<LinearPixel>());
    }
    if (m_motion) {
        frame.motion = m_motion->fetch<glm::vec2>();
    }
    if (m_shadowMask) {
        frame.litMask = m_shadowMask->fetch<image::Rgba8>();
    }
}

} // namespace cdr::render
