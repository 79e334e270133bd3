// An engine composes its own frame with cdr's. Squares of the engine's share the cascades' depth with boxes 1,000 km away, and
// are 0.00001 units before and behind them. A sky is drawn afterwards, by the engine's own reversed depth.
#include "host.h"
#include "sky_frag.h"
#include "surface_frag.h"
#include "surface_vert.h"

#include <cdr/render/renderer.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

namespace {

namespace depth = cdr::depth;
namespace gpu = cdr::gpu;
namespace render = cdr::render;
namespace scene = cdr::scene;

constexpr vk::Extent2D kExtent{320, 180};
constexpr double kFaceView = 1e6;
constexpr scene::Camera kCamera{.fovY = 4e-6, .nearView = 1.0, .farView = 1e8};
constexpr double kHostNearView = 0.1; // of the engine's reversed projection, which has no far plane

constexpr auto kColorFormat = vk::Format::eR8G8B8A8Srgb;
constexpr auto kGBufferFormat = vk::Format::eR32G32B32A32Uint;
constexpr auto kDepthFormat = vk::Format::eD32Sfloat;
constexpr auto kStages = vk::ShaderStageFlagBits::eVertex | vk::ShaderStageFlagBits::eFragment;

struct Square {
    double x;
    double distanceView;
    double halfSide;
    std::uint32_t object;
};
constexpr std::array kSquares{Square{-1.0, kFaceView - 1e-5, 0.25, 100},
                              Square{1.0, kFaceView + 1e-5, 0.25, 101}, Square{2.5, kFaceView, 0.25, 102}};
constexpr Square kSky{0.0, 1e7, 1e4, 0};

struct Push { // of surface.vert
    depth::CascadeConstants cascade;
    float x;
    float y;
    float ahead;
    float halfSide;
    std::uint32_t cascadeIndex;
    std::uint32_t id;
};

void drawSquare(vk::CommandBuffer commands, vk::PipelineLayout layout, const depth::CascadeConstants& cascade,
                double anchorView, const Square& square, std::uint32_t cascadeIndex) {
    const Push push{.cascade = cascade,
                    .x = static_cast<float>(square.x),
                    .y = 0.0f,
                    .ahead = static_cast<float>(square.distanceView - anchorView), // float64 until here
                    .halfSide = static_cast<float>(square.halfSide),
                    .cascadeIndex = cascadeIndex,
                    .id = square.object + 1};
    commands.pushConstants<Push>(layout, kStages, 0, push);
    commands.draw(4, 1, 0, 0);
}

scene::Scene twoBoxes() {
    scene::Scene made;
    made.meshes.push_back(scene::makeBox(glm::vec3(0.5f)));
    made.materials.push_back({.name = "white"});
    made.lights.push_back({.position = {2e5, 2e5, 0.0}, .halfDistance = 1e6});
    for (const double x : {-1.0, 1.0}) {
        scene::addInstance(made, 0, 0, static_cast<std::uint32_t>(made.instances.size()),
                           {x, 0.0, -kFaceView - 0.5}, glm::mat3(1.0f));
    }
    return made;
}

/// Over what cdr drew: the engine's pass, with the engine's depth.
void drawSky(vk::CommandBuffer commands, vk::Pipeline pipeline, vk::PipelineLayout layout,
             const HostImage& color, const HostImage& depthImage) {
    const vk::RenderingAttachmentInfo colors{.imageView = *color.view,
                                             .imageLayout = vk::ImageLayout::eGeneral,
                                             .loadOp = vk::AttachmentLoadOp::eLoad,
                                             .storeOp = vk::AttachmentStoreOp::eStore};
    const vk::RenderingAttachmentInfo depths{.imageView = *depthImage.view,
                                             .imageLayout = vk::ImageLayout::eGeneral,
                                             .loadOp = vk::AttachmentLoadOp::eLoad,
                                             .storeOp = vk::AttachmentStoreOp::eStore};
    commands.beginRendering({.renderArea = {{0, 0}, kExtent},
                             .layerCount = 1,
                             .colorAttachmentCount = 1,
                             .pColorAttachments = &colors,
                             .pDepthAttachment = &depths});
    commands.bindPipeline(vk::PipelineBindPoint::eGraphics, pipeline);
    commands.setViewport(0, vk::Viewport{0.0f, 0.0f, kExtent.width, kExtent.height, 0.0f, 1.0f});
    commands.setScissor(0, vk::Rect2D{{0, 0}, kExtent});
    const depth::CascadeConstants host =
        depth::cascadeConstants(depth::Mapping::reversed, {{kHostNearView, 1e9}}, 0,
                                {.fovY = kCamera.fovY, .aspect = 1.0 * kExtent.width / kExtent.height});
    drawSquare(commands, layout, host, 0.0, kSky, 0);
    commands.endRendering();
}

void copy(vk::CommandBuffer commands, vk::Image image, vk::ImageLayout layout, const HostBuffer& into) {
    const vk::MemoryBarrier2 all{.srcStageMask = vk::PipelineStageFlagBits2::eAllCommands,
                                 .srcAccessMask = vk::AccessFlagBits2::eMemoryWrite,
                                 .dstStageMask = vk::PipelineStageFlagBits2::eAllCommands,
                                 .dstAccessMask =
                                     vk::AccessFlagBits2::eMemoryRead | vk::AccessFlagBits2::eMemoryWrite};
    const vk::ImageMemoryBarrier2 readable{.srcStageMask = all.srcStageMask,
                                           .srcAccessMask = all.srcAccessMask,
                                           .dstStageMask = all.dstStageMask,
                                           .dstAccessMask = all.dstAccessMask,
                                           .oldLayout = layout,
                                           .newLayout = vk::ImageLayout::eTransferSrcOptimal,
                                           .image = image,
                                           .subresourceRange = {vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1}};
    commands.pipelineBarrier2({.memoryBarrierCount = 1,
                               .pMemoryBarriers = &all,
                               .imageMemoryBarrierCount = 1,
                               .pImageMemoryBarriers = &readable});
    commands.copyImageToBuffer(
        image, vk::ImageLayout::eTransferSrcOptimal, *into.buffer,
        vk::BufferImageCopy{.imageSubresource = {vk::ImageAspectFlagBits::eColor, 0, 0, 1},
                            .imageExtent = {kExtent.width, kExtent.height, 1}});
    commands.pipelineBarrier2({.memoryBarrierCount = 1, .pMemoryBarriers = &all});
}

void writePicture(const char* path, const HostBuffer& color) {
    std::FILE* file = std::fopen(path, "wb");
    std::fprintf(file, "P6 %u %u 255\n", kExtent.width, kExtent.height);
    const auto* rgba = static_cast<const unsigned char*>(color.mapped);
    for (std::size_t i = 0; i < std::size_t{kExtent.width} * kExtent.height; ++i) {
        std::fwrite(rgba + 4 * i, 1, 3, file);
    }
    std::fclose(file);
}

} // namespace

int main(int count, char** arguments) try {
    const gpu::Instance instance;
    const gpu::Device device(instance, ""); // or gpu::BorrowedDevice
    const Host host(device.physical(), device.handle(), kExtent);
    using Usage = vk::ImageUsageFlagBits;
    const HostImage color =
        host.makeImage(kColorFormat, Usage::eTransferDst | Usage::eColorAttachment | Usage::eTransferSrc,
                       vk::ImageAspectFlagBits::eColor);
    const HostImage hostDepth =
        host.makeImage(kDepthFormat, Usage::eDepthStencilAttachment, vk::ImageAspectFlagBits::eDepth);
    const vk::PushConstantRange pushed{.stageFlags = kStages, .size = sizeof(Push)};
    const vk::UniquePipelineLayout layout = host.device().createPipelineLayoutUnique(
        {.pushConstantRangeCount = 1, .pPushConstantRanges = &pushed});
    const vk::UniquePipeline surface = host.makePipeline({.vertex = surface_vert,
                                                          .fragment = surface_frag,
                                                          .layout = *layout,
                                                          .colorFormat = kGBufferFormat,
                                                          .depthFormat = kDepthFormat,
                                                          .compare = vk::CompareOp::eLessOrEqual});
    const vk::UniquePipeline sky = host.makePipeline({.vertex = surface_vert,
                                                      .fragment = sky_frag,
                                                      .layout = *layout,
                                                      .colorFormat = kColorFormat,
                                                      .depthFormat = kDepthFormat,
                                                      .compare = vk::CompareOp::eGreater});
    const HostBuffer pixels = host.makeReadBuffer(4 * kExtent.width * kExtent.height);
    const HostBuffer surfaces = host.makeReadBuffer(16 * kExtent.width * kExtent.height);
    const vk::UniqueCommandPool pool =
        host.device().createCommandPoolUnique({.queueFamilyIndex = device.queueFamily()});
    const vk::UniqueCommandBuffer commands = std::move(
        host.device()
            .allocateCommandBuffersUnique(
                {.commandPool = *pool, .level = vk::CommandBufferLevel::ePrimary, .commandBufferCount = 1})
            .front());
    const vk::SemaphoreTypeCreateInfo timeline{.semaphoreType = vk::SemaphoreType::eTimeline,
                                               .initialValue = 0};
    const vk::UniqueSemaphore done = host.device().createSemaphoreUnique({.pNext = &timeline});
    const scene::Scene boxes = twoBoxes();
    const render::GpuScene onDevice(device, boxes);
    render::Renderer renderer(
        device, boxes, onDevice,
        {.width = kExtent.width, .height = kExtent.height, .technique = depth::parseTechnique("anchored")});
    commands->begin(vk::CommandBufferBeginInfo{.flags = vk::CommandBufferUsageFlagBits::eOneTimeSubmit});

    // quoted in src/cdr/README.md: begin
    render::HostFrame frame{.commands = *commands, .done = *done, .doneValue = 1};
    frame.color = {.image = *color.image,
                   .format = VK_FORMAT_R8G8B8A8_SRGB,
                   .extent = kExtent,
                   .layout = VK_IMAGE_LAYOUT_GENERAL}; // that the frame leaves it in
    frame.depth = {.image = {.image = *hostDepth.image,
                             .view = *hostDepth.view,
                             .format = VK_FORMAT_D32_SFLOAT,
                             .extent = kExtent,
                             .layout = VK_IMAGE_LAYOUT_GENERAL},
                   .nearView = kHostNearView}; // near / distance, 0 for background
    for (const Square& square : kSquares) {
        frame.occupied.push_back({square.distanceView, square.distanceView});
    }
    frame.draw = [&](const render::HostCascade& cascade) {
        const vk::CommandBuffer inside = cascade.commands;
        inside.bindPipeline(vk::PipelineBindPoint::eGraphics, *surface); // writes a cdrGBufferTexel()
        for (const Square& square : kSquares) {
            drawSquare(inside, *layout, cascade.constants, cascade.anchorView, square, cascade.index);
        }
    };
    renderer.record(kCamera, frame);
    drawSky(*commands, *sky, *layout, color, hostDepth); // by the engine's own depth test
    // quoted in src/cdr/README.md: end

    copy(*commands, *color.image, vk::ImageLayout::eGeneral, pixels);
    const render::SurfaceImage gbuffer = renderer.surfaces().gbuffer;
    copy(*commands, gbuffer.image, vk::ImageLayout(gbuffer.layout), surfaces);
    commands->end();
    const vk::CommandBufferSubmitInfo submitted{.commandBuffer = *commands};
    const vk::SemaphoreSubmitInfo signal{
        .semaphore = *done, .value = 1, .stageMask = vk::PipelineStageFlagBits2::eAllCommands};
    device.queue().submit2(vk::SubmitInfo2{.commandBufferInfoCount = 1,
                                           .pCommandBufferInfos = &submitted,
                                           .signalSemaphoreInfoCount = 1,
                                           .pSignalSemaphoreInfos = &signal});
    renderer.finish();

    const auto* texels = static_cast<const render::GBufferPixel*>(surfaces.mapped);
    const auto* rgba = static_cast<const unsigned char*>(pixels.mapped);
    const double pixelsPerUnit = kExtent.height / (2.0 * kFaceView * std::tan(0.5 * kCamera.fovY));
    for (const double x : {-1.0, -0.6, 1.0, 2.5, 0.0}) {
        const auto column = static_cast<std::size_t>(0.5 * kExtent.width + x * pixelsPerUnit);
        const std::size_t pixel = kExtent.height / 2 * kExtent.width + column;
        const bool isSky = rgba[4 * pixel + 2] > rgba[4 * pixel] && texels[pixel].id() == 0;
        std::printf("at %4.1f: id %u%s\n", x, texels[pixel].id(), isSky ? ", the sky" : "");
    }
    if (count > 1) {
        writePicture(arguments[1], pixels);
    }
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
