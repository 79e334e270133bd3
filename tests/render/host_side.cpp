#include "host_side.h"

#include "read_spirv.h"

#include <cdr/render/targets/gbuffer.h>

#include <vector>

namespace cdr::render_test {

namespace {

struct SquarePush {
    depth::CascadeConstants cascade;
    float place[4];
    std::uint32_t names[2];
};

constexpr auto kSquareStages = vk::ShaderStageFlagBits::eVertex | vk::ShaderStageFlagBits::eFragment;

vk::UniqueSemaphore makeTimeline(const gpu::Device& device) {
    const vk::SemaphoreTypeCreateInfo type{.semaphoreType = vk::SemaphoreType::eTimeline, .initialValue = 0};
    return device.handle().createSemaphoreUnique({.pNext = &type});
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

HostSquares::HostSquares(const gpu::Device& device, vk::Format format, Language language)
    : m_layout(gpu::makePipelineLayout(
          device, {}, {{.stageFlags = kSquareStages, .size = sizeof(SquarePush)}}, "host squares")) {
    const std::vector<std::uint32_t> vertex =
        readSpirv(language == Language::glsl ? CDR_HOST_SURFACE_VERT : CDR_HOST_SURFACE_VERT_HLSL);
    const std::vector<std::uint32_t> fragment =
        readSpirv(language == Language::glsl ? CDR_HOST_SURFACE_FRAG : CDR_HOST_SURFACE_FRAG_HLSL);
    m_pipeline = gpu::makeGraphicsPipeline(device, {.name = "host squares",
                                                    .vertexSpirv = vertex,
                                                    .fragmentSpirv = fragment,
                                                    .constants = {},
                                                    .layout = *m_layout,
                                                    .bindings = {},
                                                    .attributes = {},
                                                    .colorFormats = {render::kGBufferFormat},
                                                    .depthFormat = format});
}

void HostSquares::draw(const render::HostCascade& cascade, const Square& square) const {
    const vk::CommandBuffer commands = cascade.commands;
    commands.bindPipeline(vk::PipelineBindPoint::eGraphics, *m_pipeline);
    commands.setCullMode(vk::CullModeFlagBits::eNone);
    commands.setFrontFace(vk::FrontFace::eCounterClockwise);
    for (const int half :
         {0, 1}) { // of a square that the shader makes of four corners, as a list of triangles
        const SquarePush push{.cascade = cascade.constants,
                              .place = {static_cast<float>(square.x), 0.0f,
                                        static_cast<float>(square.distanceView - cascade.anchorView),
                                        static_cast<float>(square.halfSide)},
                              .names = {cascade.index, square.object + 1}};
        commands.pushConstants<SquarePush>(*m_layout, kSquareStages, 0, push);
        commands.draw(3, 1, static_cast<std::uint32_t>(half), 0);
    }
}

} // namespace cdr::render_test
