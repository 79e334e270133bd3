#include <cdr/gpu/commands.h>
#include <cdr/render/targets/gbuffer_rendering.h>
#include <cdr/render/translucency/fragment_counter.h>

#include <glm/gtc/packing.hpp>

#include <algorithm>

namespace cdr::render {

FragmentCounter::FragmentCounter(const gpu::Device& device, vk::Extent2D extent)
    : m_image(device,
              {.extent = extent,
               .format = kFormat,
               .usage = vk::ImageUsageFlagBits::eColorAttachment | vk::ImageUsageFlagBits::eTransferSrc},
              "fragment counts"),
      m_copy(device, extent, sizeof(std::uint16_t), "fragment counts copy") {}

void FragmentCounter::begin(vk::CommandBuffer primary) const {
    gpu::pipelineBarrier(primary, {attachBarrier(m_image)});
    const auto cleared = colorAttachment(m_image.view(), vk::AttachmentLoadOp::eClear);
    beginRendering(primary, m_image.options().extent, {&cleared, 1});
    primary.endRendering();
    gpu::pipelineBarrier(primary, {nextScope()});
}

vk::RenderingAttachmentInfo FragmentCounter::attachment() const {
    return colorAttachment(m_image.view(), vk::AttachmentLoadOp::eLoad);
}

vk::ImageMemoryBarrier2 FragmentCounter::nextScope() const {
    return chainBarrier(m_image);
}

void FragmentCounter::recordReadback(vk::CommandBuffer primary) const {
    gpu::pipelineBarrier(primary, {copyBarrier(m_image, kDrawnColor)});
    m_copy.record(primary, m_image);
}

image::ImageU32 FragmentCounter::fetch() const {
    const auto halves = m_copy.fetch<std::uint16_t>();
    image::ImageU32 counts(halves.width, halves.height);
    std::transform(halves.pixels.begin(), halves.pixels.end(), counts.pixels.begin(),
                   [](std::uint16_t half) { return static_cast<std::uint32_t>(glm::unpackHalf1x16(half)); });
    return counts;
}

} // namespace cdr::render
