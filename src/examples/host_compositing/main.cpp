// An engine composes its own frame with cdr's. Squares of the engine's share the cascades' depth with boxes 1,000 km away, and
// are 0.00001 units before and behind them. The engine gets the depth of its own camera for what it draws afterwards.
#include "engine.h"

#include <cdr/render/renderer.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>

namespace {

namespace depth = cdr::depth;
namespace gpu = cdr::gpu;
namespace render = cdr::render;
namespace scene = cdr::scene;
using Usage = vk::ImageUsageFlagBits;

constexpr vk::Extent2D kExtent{320, 180};
constexpr double kFaceView = 1e6;
constexpr scene::Camera kCamera{.fovY = 4e-6, .nearView = 1.0, .farView = 1e8};
constexpr double kHostNearView = 0.1; // of the engine's reversed projection, which has no far plane
constexpr auto kStages = vk::ShaderStageFlagBits::eVertex | vk::ShaderStageFlagBits::eFragment;

struct Square {
    double x;
    double distanceView;
    std::uint32_t object;
};
constexpr std::array kSquares{Square{-1.0, kFaceView - 1e-5, 100}, Square{1.0, kFaceView + 1e-5, 101},
                              Square{2.5, kFaceView, 102}};

struct Push { // of surface.vert
    depth::CascadeConstants cascade;
    float place[4]; // x, y, view distance beyond the anchor, half a side
    std::uint32_t names[2];
};

/// What is read back of a pixel.
struct Shown {
    render::GBufferPixel surface;
    float depth;
};

scene::Scene twoBoxes() {
    scene::Scene made;
    made.meshes.push_back(scene::makeBox(glm::vec3(0.5f)));
    made.materials.push_back({.name = "white"});
    for (const std::uint32_t object : {0u, 1u}) {
        scene::addInstance(made, 0, 0, object, {2.0 * object - 1.0, 0.0, -kFaceView - 0.5}, glm::mat3(1.0f));
    }
    return made;
}

} // namespace

int main() try {
    const gpu::Instance instance;
    const gpu::Device device(instance, ""); // or gpu::BorrowedDevice
    const HostImage color =
        makeImage(device, kExtent, vk::Format::eR8G8B8A8Srgb, Usage::eTransferDst | Usage::eColorAttachment,
                  vk::ImageAspectFlagBits::eColor);
    const HostImage hostDepth =
        makeImage(device, kExtent, vk::Format::eD32Sfloat,
                  Usage::eDepthStencilAttachment | Usage::eTransferSrc, vk::ImageAspectFlagBits::eDepth);
    const vk::PushConstantRange pushed{.stageFlags = kStages, .size = sizeof(Push)};
    const vk::UniquePipelineLayout layout =
        vk::Device(device.handle())
            .createPipelineLayoutUnique({.pushConstantRangeCount = 1, .pPushConstantRanges = &pushed});
    const vk::UniquePipeline surface = makePipeline(device.handle(), *layout);
    const vk::UniqueCommandPool pool =
        vk::Device(device.handle()).createCommandPoolUnique({.queueFamilyIndex = device.queueFamily()});
    const vk::CommandBuffer commands =
        vk::Device(device.handle())
            .allocateCommandBuffers({.commandPool = *pool, .commandBufferCount = 1})
            .front();
    const vk::SemaphoreTypeCreateInfo timeline{.semaphoreType = vk::SemaphoreType::eTimeline};
    const vk::UniqueSemaphore done = vk::Device(device.handle()).createSemaphoreUnique({.pNext = &timeline});
    const scene::Scene boxes = twoBoxes();
    const render::GpuScene onDevice(device, boxes);
    render::Renderer renderer(
        device, boxes, onDevice,
        {.width = kExtent.width, .height = kExtent.height, .technique = depth::parseTechnique("anchored")});
    commands.begin(vk::CommandBufferBeginInfo{.flags = vk::CommandBufferUsageFlagBits::eOneTimeSubmit});

    // quoted in src/cdr/README.md: begin
    render::HostFrame frame{.commands = commands, .done = *done, .doneValue = 1};
    frame.color = {.image = *color.image,
                   .format = VK_FORMAT_R8G8B8A8_SRGB,
                   .extent = kExtent,
                   .layout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL}; // that the frame leaves it in
    frame.depth = {.image = {.image = *hostDepth.image,
                             .view = *hostDepth.view,
                             .format = VK_FORMAT_D32_SFLOAT,
                             .extent = kExtent,
                             .layout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL},
                   .nearView = kHostNearView}; // near / distance, 0 for background
    for (const Square& square : kSquares) {
        frame.occupied.push_back({square.distanceView, square.distanceView});
    }
    frame.draw = [&](const render::HostCascade& cascade) {
        const vk::CommandBuffer inside = cascade.commands;
        inside.bindPipeline(vk::PipelineBindPoint::eGraphics, *surface); // writes a cdrGBufferTexel()
        for (const Square& square : kSquares) {
            const auto ahead =
                static_cast<float>(square.distanceView - cascade.anchorView); // float64 until here
            const Push push{.cascade = cascade.constants,
                            .place = {static_cast<float>(square.x), 0.0f, ahead, 0.25f},
                            .names = {cascade.index, square.object + 1}};
            inside.pushConstants<Push>(*layout, kStages, 0, push);
            inside.draw(4, 1, 0, 0);
        }
    };
    renderer.record(kCamera, frame);
    // The engine's own passes go here: over the picture, by its own depth test.
    // quoted in src/cdr/README.md: end

    const std::array points{-1.0, -0.6, 1.0, 2.5, 0.0};
    const double pixelsPerUnit = kExtent.height / (2.0 * kFaceView * std::tan(0.5 * kCamera.fovY));
    const vk::UniqueBuffer buffer = vk::Device(device.handle())
                                        .createBufferUnique({.size = points.size() * sizeof(Shown),
                                                             .usage = vk::BufferUsageFlagBits::eTransferDst});
    const vk::UniqueDeviceMemory memory =
        allocate(device, vk::Device(device.handle()).getBufferMemoryRequirements(*buffer),
                 vk::MemoryPropertyFlagBits::eHostVisible | vk::MemoryPropertyFlagBits::eHostCoherent);
    vk::Device(device.handle()).bindBufferMemory(*buffer, *memory, 0);
    const auto* shown =
        static_cast<const Shown*>(vk::Device(device.handle()).mapMemory(*memory, 0, VK_WHOLE_SIZE));
    const render::SurfaceImage gbuffer = renderer.surfaces().gbuffer;
    const vk::ImageMemoryBarrier2 readable{.srcStageMask = vk::PipelineStageFlagBits2::eAllCommands,
                                           .srcAccessMask = vk::AccessFlagBits2::eMemoryWrite,
                                           .dstStageMask = vk::PipelineStageFlagBits2::eCopy,
                                           .dstAccessMask = vk::AccessFlagBits2::eTransferRead,
                                           .oldLayout = vk::ImageLayout(gbuffer.layout),
                                           .newLayout = vk::ImageLayout::eTransferSrcOptimal,
                                           .image = gbuffer.image,
                                           .subresourceRange = {vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1}};
    commands.pipelineBarrier2({.imageMemoryBarrierCount = 1, .pImageMemoryBarriers = &readable});
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto column = static_cast<std::int32_t>(0.5 * kExtent.width + points[i] * pixelsPerUnit);
        vk::BufferImageCopy pixel{.bufferOffset = i * sizeof(Shown),
                                  .imageSubresource = {vk::ImageAspectFlagBits::eColor, 0, 0, 1},
                                  .imageOffset = {column, kExtent.height / 2, 0},
                                  .imageExtent = {1, 1, 1}};
        commands.copyImageToBuffer(gbuffer.image, vk::ImageLayout::eTransferSrcOptimal, *buffer, pixel);
        pixel.bufferOffset += offsetof(Shown, depth);
        pixel.imageSubresource.aspectMask = vk::ImageAspectFlagBits::eDepth;
        commands.copyImageToBuffer(*hostDepth.image, vk::ImageLayout::eTransferSrcOptimal, *buffer, pixel);
    }
    const vk::MemoryBarrier2 toHost{.srcStageMask = vk::PipelineStageFlagBits2::eCopy,
                                    .srcAccessMask = vk::AccessFlagBits2::eTransferWrite,
                                    .dstStageMask = vk::PipelineStageFlagBits2::eHost,
                                    .dstAccessMask = vk::AccessFlagBits2::eHostRead};
    commands.pipelineBarrier2({.memoryBarrierCount = 1, .pMemoryBarriers = &toHost});
    commands.end();
    const vk::CommandBufferSubmitInfo submitted{.commandBuffer = commands};
    const vk::SemaphoreSubmitInfo signal{
        .semaphore = *done, .value = 1, .stageMask = vk::PipelineStageFlagBits2::eAllCommands};
    vk::Queue(device.queue())
        .submit2(vk::SubmitInfo2{.commandBufferInfoCount = 1,
                                 .pCommandBufferInfos = &submitted,
                                 .signalSemaphoreInfoCount = 1,
                                 .pSignalSemaphoreInfos = &signal});
    renderer.finish();
    for (std::size_t i = 0; i < points.size(); ++i) {
        std::printf("at %4.1f: id %u, depth %.1e\n", points[i], shown[i].surface.id(), shown[i].depth);
    }
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
