#include "../support/refusal.h"
#include "../support/timeline.h"
#include "fixture.h"

#include <cdr/base/error.h>
#include <cdr/gpu/commands.h>
#include <cdr/gpu/device_clock.h>
#include <cdr/gpu/features.h>
#include <cdr/gpu/memory.h>
#include <cdr/render/output/readback.h>
#include <cdr/render/views/views_renderer.h>
#include <scenes/cubes.h>
#include <scenes/sheets.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace cdr::render_test {

namespace {

using render::Frame;

class FrameTest : public RenderTest {};

TEST_F(FrameTest, HoldsIdDistanceNormalAndColor) {
    scene::Scene scene = boxScene();
    addBox(scene, glm::dvec3(0.0, 0.0, -10.0));
    const Frame frame = draw(scene, {.fovY = 0.2}, smallOptions(depth::parseTechnique("reversed")));
    const std::uint32_t x = frame.width() / 2;
    const std::uint32_t y = frame.height() / 2;
    EXPECT_EQ(frame.id(x, y), 1u);
    EXPECT_NEAR(frame.distanceView(x, y), 9.5, 1e-5);
    EXPECT_NEAR(frame.normalView(x, y).z, 1.0f, 1e-3f);
    EXPECT_GT(frame.color.at(x, y)[0], 60);
    EXPECT_EQ(frame.id(0, 0), 0u);
    EXPECT_TRUE(std::isinf(frame.distanceView(0, 0)));
    EXPECT_EQ(frame.color.at(0, 0), (image::Rgba8{0, 0, 0, 255}));
    EXPECT_EQ(frame.stats.draws, 1u);
}

TEST_F(FrameTest, IsTimedByTheDevicesClockWhereThatIsAsked) {
    scene::Scene scene = boxScene();
    addBox(scene, glm::dvec3(0.0, 0.0, -10.0));
    render::RenderOptions options = smallOptions(depth::parseTechnique("reversed"));
    EXPECT_FALSE(draw(scene, {.fovY = 0.2}, options).stats.times.deviceMs);
    if (!gpu::DeviceClock::isThere(device())) {
        leaveOut("timestamps");
        return;
    }
    options.deviceClock = true;
    const render::FrameTimes times = draw(scene, {.fovY = 0.2}, options).stats.times;
    ASSERT_TRUE(times.deviceMs);
    EXPECT_GT(*times.deviceMs, 0.0);
    EXPECT_LE(*times.deviceMs, times.executeMs);
}

TEST_F(FrameTest, TellsWhatFramesCameToThatAreNotCopied) {
    const scene::SceneSetup setup = scenes::makeRotation(1, 1000);
    const render::GpuScene onDevice(device(), setup.scene);
    for (const render::Submission submission : submissions()) {
        render::RenderOptions options = smallOptions(depth::parseTechnique("anchored"));
        options.submission = submission;
        options.framesInFlight = 2;
        render::Renderer renderer(device(), setup.scene, onDevice, options);
        EXPECT_EQ(renderer.lastStats().draws, 0u);
        const render::FrameStats first = renderer.draw(setup.path.at(0));
        EXPECT_EQ(renderer.lastStats().draws, first.draws);
        const render::FrameStats second = renderer.draw(setup.path.at(40));
        ASSERT_NE(first.draws, second.draws); // else the last frame is not told from others
        renderer.submit(setup.path.at(40));
        renderer.submit(setup.path.at(0));
        renderer.finish();
        EXPECT_EQ(renderer.lastStats().draws, first.draws);
        EXPECT_EQ(renderer.lastStats().visible, first.visible);
        EXPECT_GT(renderer.lastStats().times.recordMs, 0.0);
        EXPECT_EQ(renderer.lastStats().times.executeMs, 0.0);
        renderer.resize(64, 64);
        EXPECT_EQ(renderer.lastStats().draws, 0u);
    }
}

TEST_F(FrameTest, TellsHowSurfacesBlendBeforeTheyAreDrawn) {
    const scene::SceneSetup setup = scenes::makeSheets(2013);
    const render::GpuScene onDevice(device(), setup.scene);
    render::RenderOptions options = withSorting(thumbnailOptions(depth::parseTechnique("reversed")));
    for (const bool hasRoom : {true, false}) {
        options.translucency.maxBytes = hasRoom ? options.translucency.maxBytes : 1000;
        render::Renderer renderer(device(), setup.scene, onDevice, options);
        renderer.submit(setup.path.at(0));
        const render::TranslucencyStats begun = renderer.lastStats().translucency;
        EXPECT_EQ(begun.method, hasRoom ? render::Translucency::sorted : render::Translucency::weighted);
        EXPECT_EQ(begun.refusal.has_value(), !hasRoom);
        EXPECT_GT(begun.draws, 0u);
        EXPECT_GT(begun.bytes, 0u);
        renderer.finish();
        const render::TranslucencyStats done = renderer.lastStats().translucency;
        EXPECT_EQ(done.method, begun.method);
        EXPECT_EQ(done.refusal, begun.refusal);
        EXPECT_EQ(done.draws, begun.draws);
        EXPECT_EQ(done.fragments > 0, hasRoom);
    }
}

TEST_F(FrameTest, IsUprightAndNotMirrored) {
    scene::Scene scene = boxScene();
    addBox(scene, glm::dvec3(2.0, 0.0, -10.0));
    addBox(scene, glm::dvec3(0.0, 1.5, -10.0));
    const scene::Camera camera{.fovY = 0.6};
    const Frame frame = draw(scene, camera, smallOptions(depth::parseTechnique("reversed")));
    EXPECT_EQ(frame.id(frame.width() / 2 + frame.height() / 3, frame.height() / 2), 1u);
    EXPECT_EQ(frame.id(frame.width() / 2, frame.height() / 2 - frame.height() / 4), 2u);
}

TEST_F(FrameTest, DistanceIsMetricWhateverTheTechnique) {
    const scene::SceneSetup setup = scenes::makeRotation(1, 64'000);
    const scene::Camera camera = setup.path.at(0);
    const auto truth = truthOf(setup.scene, camera);
    for (const depth::Mapping mapping : depth::kMappings) {
        for (const char* split : {"none", "count:4"}) {
            const auto technique =
                depth::Technique{mapping, depth::parseSplit(split), depth::DepthFormat::d32f};
            const Frame frame = draw(setup.scene, camera, smallOptions(technique));
            std::size_t compared = 0;
            for (std::uint32_t y = 0; y < frame.height(); ++y) {
                for (std::uint32_t x = 0; x < frame.width(); ++x) {
                    if (frame.id(x, y) != 0 && frame.id(x, y) == truth.at(x, y).id) {
                        ++compared;
                        ASSERT_NEAR(frame.distanceView(x, y) / truth.at(x, y).distanceView, 1.0, 2e-2)
                            << nameOf(technique) << " " << x << " " << y;
                    }
                }
            }
            EXPECT_GT(compared, 10'000u) << nameOf(technique);
        }
    }
}

TEST_F(FrameTest, NonUniformAndMirroredBasesAreDrawnAsTheTruthSeesThem) {
    scene::Scene scene = boxScene();
    addBox(scene, glm::dvec3(-2.0, 0.0, -10.0),
           glm::mat3(1.0f, 0.2f, 0.0f, 0.0f, 2.0f, 0.3f, 0.4f, 0.0f, 0.5f));
    addBox(scene, glm::dvec3(0.0, 0.0, -10.0),
           glm::mat3(-1.0f, 0.0f, 0.0f, 0.0f, 1.5f, 0.0f, 0.3f, 0.0f, 1.0f));
    addBox(scene, glm::dvec3(2.0, 0.0, -10.0), glm::mat3(0.1f));
    const scene::Camera camera =
        scene::lookAt({.fovY = 0.6}, glm::dvec3(3.0, 4.0, 0.0), glm::dvec3(0.0, 0.0, -10.0));
    const Frame frame = draw(scene, camera, smallOptions(depth::parseTechnique("reversed")));
    const auto wrong = wrongIn(frame, scene, camera);
    EXPECT_GT(wrong.pixels, 2000u);
    EXPECT_EQ(wrong.wrong, 0u);
    for (std::uint32_t y = 0; y < frame.height(); ++y) {
        for (std::uint32_t x = 0; x < frame.width(); ++x) {
            // A surface that is seen faces the camera, so its normal leans towards it.
            if (frame.id(x, y) != 0) {
                ASSERT_GT(frame.normalView(x, y).z, -0.4f);
            }
        }
    }
}

TEST_F(FrameTest, RefusesWhatCannotBeRendered) {
    const scene::Scene scene = boxScene();
    const render::GpuScene gpuScene(device(), scene);
    auto options = smallOptions(depth::parseTechnique("reversed"));
    render::Renderer renderer(device(), scene, gpuScene, options);
    EXPECT_THROW(renderer.render({.nearView = -1.0}), base::InputError);
    options.width = 1'000'000'000;
    EXPECT_THROW(render::Renderer(device(), scene, gpuScene, options), base::InputError);
    options.width = 0;
    EXPECT_THROW(render::Renderer(device(), scene, gpuScene, options), base::InputError);
}

TEST_F(FrameTest, ABorrowedDeviceRendersTheSameAndStaysAlive) {
    const scene::SceneSetup setup = scenes::makeAfc(1);
    const auto options = smallOptions(depth::parseTechnique("reversed"));
    const scene::Camera camera = setup.path.at(7);
    const Frame own = draw(setup.scene, camera, options);
    {
        const gpu::Device borrowed(lentDevice());
        EXPECT_EQ(SoleRenderer(borrowed, setup.scene, options).render(camera).color, own.color);
    }
    EXPECT_EQ(draw(setup.scene, camera, options).color, own.color);
}

/// Images of a borrowed device come from its owner's allocator, which stays.
TEST_F(FrameTest, ABorrowedAllocatorIsUsedAndStays) {
    scene::Scene scene = boxScene();
    addBox(scene, {0.0, 0.0, -5.0});
    const std::uint64_t before = gpu::freeDeviceBytes(device());
    {
        gpu::BorrowedDevice handles = lentDevice();
        handles.allocator = device().allocator();
        const gpu::Device borrowed(handles);
        EXPECT_EQ(borrowed.allocator(), device().allocator());
        SoleRenderer renderer(borrowed, scene, smallOptions(depth::parseTechnique("anchored")));
        EXPECT_EQ(renderer.render({}).id(240, 135), 1u);
        EXPECT_LT(gpu::freeDeviceBytes(device()), before);
    }
    const gpu::Buffer stillThere(device(), 64, vk::BufferUsageFlagBits::eTransferDst,
                                 gpu::MemoryUse::deviceOnly, "after");
    EXPECT_TRUE(stillThere.handle());
}

/// A device without a feature that it is borrowed with is refused by the feature's name.
TEST_F(FrameTest, ABorrowedDeviceIsRefusedByTheNameOfWhatItLacks) {
    VkPhysicalDeviceVulkan13Features v13 = vk::PhysicalDeviceVulkan13Features{};
    VkPhysicalDeviceVulkan12Features v12 = vk::PhysicalDeviceVulkan12Features{};
    VkPhysicalDeviceFeatures2 features = vk::PhysicalDeviceFeatures2{.pNext = &v12};
    EXPECT_THROW(gpu::enableFeatures(instance().handle(), device().physical(), features), base::InputError);
    v12.pNext = &v13;
    gpu::enableFeatures(instance().handle(), device().physical(), features);
    EXPECT_TRUE(gpu::missingFeatures(features).empty());
    gpu::BorrowedDevice handles = lentDevice();
    handles.features = &features;
    EXPECT_EQ(gpu::Device(handles).info().gpuDrivenMissing, device().info().gpuDrivenMissing);
    v12.timelineSemaphore = VK_FALSE;
    v13.synchronization2 = VK_FALSE;
    features.features.depthClamp = VK_FALSE;
    const std::string message = test::inputErrorOf([&] { const gpu::Device refused(handles); });
    EXPECT_NE(message.find("was made without synchronization2, timelineSemaphore, depthClamp"),
              std::string::npos)
        << message;
}

TEST_F(FrameTest, ABorrowedDeviceIsRefusedByTheNameOfTheHandleThatIsNull) {
    std::map<std::string, gpu::BorrowedDevice> lacking;
    for (const char* name : {"VkInstance", "VkPhysicalDevice", "VkDevice", "VkQueue"}) {
        lacking[name] = lentDevice();
    }
    lacking["VkInstance"].instance = VK_NULL_HANDLE;
    lacking["VkPhysicalDevice"].physical = VK_NULL_HANDLE;
    lacking["VkDevice"].device = VK_NULL_HANDLE;
    lacking["VkQueue"].queue = VK_NULL_HANDLE;
    for (const auto& [name, handles] : lacking) {
        EXPECT_EQ(test::inputErrorOf([&handles = handles] { const gpu::Device refused(handles); }),
                  "the " + name + " of a borrowed device is null");
    }
    VkPhysicalDeviceFeatures2 features{};
    EXPECT_THROW(gpu::enableFeatures(VK_NULL_HANDLE, device().physical(), features), base::InputError);
    EXPECT_THROW(gpu::enableFeatures(instance().handle(), VK_NULL_HANDLE, features), base::InputError);
}

TEST_F(FrameTest, ResizedPicturesAreThoseOfARendererOfTheirSize) {
    const scene::SceneSetup setup = scenes::makeAfc(1);
    render::RenderOptions options = smallOptions(depth::parseTechnique("anchored"));
    options.framesInFlight = 2;
    const scene::Camera camera = setup.path.at(7);
    SoleRenderer renderer(device(), setup.scene, options);
    renderer.submit(camera);
    EXPECT_THROW(renderer.resize(0, 10), base::InputError);
    EXPECT_EQ(hashOf(renderer.render(camera)), hashOf(draw(setup.scene, camera, options)));
    options.width = 333;
    options.height = 111;
    renderer.resize(333, 111);
    EXPECT_EQ(hashOf(renderer.render(camera)), hashOf(draw(setup.scene, camera, options)));
}

/// A mouse may be outside the picture, and a frame without its G-buffer.
TEST_F(FrameTest, PickIsEmptyWhereThereIsNoSurfaceToRead) {
    scene::Scene scene = boxScene();
    addBox(scene, {0.0, 0.0, -0.6}); // fills the picture
    const render::RenderOptions options = thumbnailOptions(depth::parseTechnique("anchored"));
    const Frame frame = draw(scene, {}, options);
    EXPECT_TRUE(frame.pick(options.width - 1, options.height - 1));
    EXPECT_FALSE(frame.pick(options.width, 0));
    EXPECT_FALSE(frame.pick(options.width + 5, options.height / 2));
    EXPECT_FALSE(frame.pick(0, options.height));
    EXPECT_FALSE(frame.pick(0xffffffff, 0xffffffff));
    EXPECT_FALSE(SoleRenderer(device(), scene, options).render({}, render::FrameCopy::color).pick(3, 3));
}

TEST_F(FrameTest, ARendererRefusesTheGpuSceneOfAnotherScene) {
    const scene::Scene scene = boxScene();
    const scene::Scene equal = scene;
    const render::GpuScene gpuScene(device(), scene);
    const render::RenderOptions options = thumbnailOptions(depth::parseTechnique("anchored"));
    EXPECT_NO_THROW(render::Renderer(device(), scene, gpuScene, options));
    EXPECT_THROW(render::Renderer(device(), equal, gpuScene, options), base::InputError);
}

TEST_F(FrameTest, ARendererRefusesTheGpuSceneOfAnotherDevice) {
    const scene::Scene scene = boxScene();
    const scene::World world(boxScene());
    const gpu::Device other(instance(), "");
    const render::GpuScene there(other, scene);
    render::GpuScene live(other, world);
    const render::RenderOptions options = thumbnailOptions(depth::parseTechnique("anchored"));
    const std::vector<std::function<void()>> makers{
        [&] { render::Renderer(device(), scene, there, options); },
        [&] { render::Renderer(device(), live, options); },
        [&] { render::ViewsRenderer(device(), scene, there, options, 2); },
        [&] { render::ViewsRenderer(device(), live, options, 2); },
    };
    for (const auto& make : makers) {
        EXPECT_EQ(test::inputErrorOf([&] { make(); }), "the GpuScene is on another device than the renderer");
    }
    EXPECT_NO_THROW(render::Renderer(other, scene, there, options));
}

/// The commands that carry edits to the device were never run, so the next frame carries them again.
TEST_F(FrameTest, EditsOutliveASubmissionThatFails) {
    scene::World world(boxScene());
    const scene::InstanceHandle box =
        world.addInstance({.mesh = world.mesh(0), .material = world.material(0)});
    bool fails = false;
    const vk::Queue queue = device().queue();
    gpu::BorrowedDevice handles = lentDevice();
    handles.hasGpuDrivenFeatures = canDrawGpuDriven();
    handles.submit = [&](const VkSubmitInfo2& submission, VkFence done) {
        return fails ? VK_ERROR_OUT_OF_DEVICE_MEMORY
                     : gpu::functions().vkQueueSubmit2(queue, 1, &submission, done);
    };
    const gpu::Device borrowed(handles);
    for (const render::Submission submission : submissions()) {
        render::RenderOptions options = thumbnailOptions(depth::parseTechnique("anchored"));
        options.submission = submission;
        SoleRenderer renderer(borrowed, world, options);
        for (const double x : {0.5, -0.5}) { // the first frame, and one after an edit
            world.setTransform(box, {.position = {x, 0.0, -3.0}});
            fails = true;
            EXPECT_THROW(renderer.render({}), vk::OutOfDeviceMemoryError);
            fails = false;
            EXPECT_EQ(hashOf(renderer.render({})), hashOf(draw(world.scene(), {}, options)))
                << nameOf(submission) << " " << x;
        }
    }
}

/// A host that waits for the frame's semaphore reads on the device what render() reads back. The host's own submit function
/// brings frames to the queue.
TEST_F(FrameTest, ASubmittedFrameIsReachableOnTheDevice) {
    const scene::SceneSetup setup = scenes::makeAfc(1);
    const auto options = smallOptions(depth::parseTechnique("anchored"));
    const scene::Camera camera = setup.path.at(7);
    const Frame wanted = draw(setup.scene, camera, options);
    const vk::Device vulkan = device().handle();
    const vk::Queue queue = device().queue();
    std::size_t submissions = 0;
    gpu::BorrowedDevice handles = lentDevice();
    handles.submit = [&](const VkSubmitInfo2& submission, VkFence done) {
        ++submissions;
        return gpu::functions().vkQueueSubmit2(queue, 1, &submission, done);
    };
    const gpu::Device borrowed(handles);
    SoleRenderer renderer(borrowed, setup.scene, options);
    const vk::UniqueSemaphore drawn = vulkan.createSemaphoreUnique({});
    const VkSemaphoreSubmitInfo signal =
        vk::SemaphoreSubmitInfo{.semaphore = *drawn, .stageMask = vk::PipelineStageFlagBits2::eAllCommands};
    submissions = 0;
    renderer.submit(camera, {.signals = {&signal, 1}});
    EXPECT_EQ(submissions, 1u);
    const render::Surfaces surfaces = renderer.surfaces();
    EXPECT_EQ(surfaces.anchorsView, wanted.anchorsView);

    const std::size_t pixels = std::size_t{options.width} * options.height;
    const gpu::Buffer color(borrowed, pixels * 4, vk::BufferUsageFlagBits::eTransferDst,
                            gpu::MemoryUse::hostReads, "c");
    const gpu::Buffer gbuffer(borrowed, pixels * 16, vk::BufferUsageFlagBits::eTransferDst,
                              gpu::MemoryUse::hostReads, "g");
    gpu::CommandPool pool(borrowed, vk::CommandBufferLevel::ePrimary, "host");
    const vk::CommandBuffer commands = pool.next();
    commands.begin({.flags = vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
    gpu::pipelineBarrier(
        commands, {gpu::imageBarrier(surfaces.gbuffer.image, vk::ImageAspectFlagBits::eColor,
                                     {vk::PipelineStageFlagBits2::eAllCommands, vk::AccessFlagBits2::eNone,
                                      vk::ImageLayout(surfaces.gbuffer.layout)},
                                     {vk::PipelineStageFlagBits2::eCopy, vk::AccessFlagBits2::eTransferRead,
                                      vk::ImageLayout::eTransferSrcOptimal})});
    const vk::BufferImageCopy all{
        .imageSubresource = {vk::ImageAspectFlagBits::eColor, 0, 0, 1},
        .imageExtent = {surfaces.color.extent.width, surfaces.color.extent.height, 1}};
    commands.copyImageToBuffer(surfaces.color.image, vk::ImageLayout(surfaces.color.layout), color.handle(),
                               all);
    commands.copyImageToBuffer(surfaces.gbuffer.image, vk::ImageLayout::eTransferSrcOptimal, gbuffer.handle(),
                               all);
    render::recordHostBarrier(commands);
    commands.end();
    const vk::UniqueFence done = vulkan.createFenceUnique({});
    gpu::submit(borrowed, {&commands, 1}, *done, {&signal, 1});
    gpu::waitAndReset(borrowed, *done);
    color.invalidate();
    gbuffer.invalidate();
    EXPECT_EQ(std::memcmp(color.mapped(), wanted.color.pixels.data(), pixels * 4), 0);
    EXPECT_EQ(std::memcmp(gbuffer.mapped(), wanted.gbuffer.pixels.data(), pixels * 16), 0);
    // The next frame writes over what the host left in another layout.
    EXPECT_EQ(hashOf(renderer.render(camera)), hashOf(wanted));
}

/// A frame runs nothing before what it waits for is signalled, by a host that signals late.
TEST_F(FrameTest, ASubmittedFrameWaitsForTheHostsSemaphore) {
    const scene::SceneSetup setup = scenes::makeAfc(1);
    const auto options = smallOptions(depth::parseTechnique("anchored"));
    const test::Timeline ready(device());
    const test::Timeline drawn(device());
    SoleRenderer renderer(device(), setup.scene, options);
    const std::string wanted = hashOf(renderer.render(setup.path.at(7)));
    const VkSemaphoreSubmitInfo wait = ready.info();
    const VkSemaphoreSubmitInfo signal = drawn.info();
    renderer.submit(setup.path.at(7), {.waits = {&wait, 1}, .signals = {&signal, 1}});
    EXPECT_FALSE(drawn.isSignalled(300'000'000));
    ready.signal();
    EXPECT_TRUE(drawn.isSignalled(std::numeric_limits<std::uint64_t>::max()));
    EXPECT_EQ(hashOf(renderer.render(setup.path.at(7))), wanted);
}

} // namespace

} // namespace cdr::render_test
