#include "host_side.h"

#include "read_spirv.h"

#include <cdr/render/targets/gbuffer.h>

#include <algorithm>

namespace cdr::render_test {

namespace {

struct RectanglePush {
    depth::CascadeConstants cascade;
    std::array<float, 4> place;
    std::uint32_t names[2];
};

constexpr auto kRectangleStages = vk::ShaderStageFlagBits::eVertex | vk::ShaderStageFlagBits::eFragment;

vk::UniqueSemaphore makeTimeline(const gpu::Device& device) {
    const vk::SemaphoreTypeCreateInfo type{.semaphoreType = vk::SemaphoreType::eTimeline, .initialValue = 0};
    return vk::Device(device.handle()).createSemaphoreUnique({.pNext = &type});
}

} // namespace

HostSide::HostSide(const gpu::Device& device, vk::Extent2D extent, vk::Format colorFormat)
    : m_device(device),
      m_extent(extent),
      m_color(device,
              {.extent = extent,
               .format = colorFormat,
               .usage = vk::ImageUsageFlagBits::eTransferDst | vk::ImageUsageFlagBits::eTransferSrc |
                        vk::ImageUsageFlagBits::eColorAttachment},
              "host color"),
      m_depth(
          device,
          {.extent = extent,
           .format = vk::Format::eD32Sfloat,
           .usage = vk::ImageUsageFlagBits::eDepthStencilAttachment | vk::ImageUsageFlagBits::eTransferSrc,
           .aspect = vk::ImageAspectFlagBits::eDepth},
          "host depth"),
      m_pool(device, vk::CommandBufferLevel::ePrimary, "host"),
      m_done(makeTimeline(device)) {}

render::HostFrame HostSide::begin() {
    m_commands = m_pool.next();
    m_commands.begin({.flags = vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
    ++m_frames;
    return {.commands = m_commands,
            .done = *m_done,
            .doneValue = m_frames,
            .color = {.image = m_color.handle(),
                      .format = static_cast<VkFormat>(m_color.options().format),
                      .extent = m_extent,
                      .layout = VK_IMAGE_LAYOUT_GENERAL}};
}

render::HostDepth HostSide::depth(double nearView) const {
    return {.image = {.image = m_depth.handle(),
                      .view = m_depth.view(),
                      .format = VK_FORMAT_D32_SFLOAT,
                      .extent = m_extent,
                      .layout = VK_IMAGE_LAYOUT_GENERAL},
            .nearView = nearView};
}

void HostSide::submit() {
    m_commands.end();
    const VkSemaphoreSubmitInfo signal = vk::SemaphoreSubmitInfo{
        .semaphore = *m_done, .value = m_frames, .stageMask = vk::PipelineStageFlagBits2::eAllCommands};
    gpu::submit(m_device, {&m_commands, 1}, {}, {}, {&signal, 1});
}

HostRectangles::HostRectangles(const gpu::Device& device, vk::Format format, const HostShaders& shaders)
    : m_layout(gpu::makePipelineLayout(
          device, {{}, {{.stageFlags = kRectangleStages, .size = sizeof(RectanglePush)}}},
          "host rectangles")) {
    m_pipeline = gpu::makeGraphicsPipeline(device, {.name = "host rectangles",
                                                    .vertexSpirv = readSpirv(shaders.vertexPath),
                                                    .fragmentSpirv = readSpirv(shaders.fragmentPath),
                                                    .layout = m_layout,
                                                    .colorFormats = {render::kGBufferFormat},
                                                    .depthFormat = format});
}

void HostRectangles::draw(const render::HostCascade& cascade, const Square& square) const {
    draw(cascade, {square.x, 0.0, square.distanceView - cascade.anchorView, square.halfSide}, square.object);
}

void HostRectangles::draw(const render::HostCascade& cascade, const std::array<double, 4>& place,
                          std::uint32_t object) const {
    const vk::CommandBuffer commands = cascade.commands;
    commands.bindPipeline(vk::PipelineBindPoint::eGraphics, *m_pipeline);
    commands.setCullMode(vk::CullModeFlagBits::eNone);
    commands.setFrontFace(vk::FrontFace::eCounterClockwise);
    RectanglePush push{.cascade = cascade.constants, .place = {}, .names = {cascade.index, object + 1}};
    std::transform(place.begin(), place.end(), push.place.begin(),
                   [](double value) { return static_cast<float>(value); });
    commands.pushConstants<RectanglePush>(*m_layout, kRectangleStages, 0, push);
    for (const std::uint32_t half : {0u, 1u}) { // of the four corners, as a list of triangles
        commands.draw(3, 1, half, 0);
    }
}

} // namespace cdr::render_test
