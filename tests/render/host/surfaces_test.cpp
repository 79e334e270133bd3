#include "../../support/timeline.h"
#include "../failing_calls.h"
#include "../fixture.h"
#include "host_side.h"
#include "read_image.h"

#include <cdr/gpu/functions.h>
#include <cdr/render/renderer_setup.h>
#include <scenes/cubes.h>

#include <optional>
#include <vector>

namespace cdr::render_test {

namespace {

class SurfacesTest : public RenderTest {};

/// A box that four cascades and more share asks for more draw records than there are instances.
struct Crowded {
    Crowded() {
        addBox(scene, {0.0, 0.0, -10.0});
        addBox(scene, {0.0, 0.0, 500.0}, glm::mat3(100.0f));
        options.submission = render::Submission::gpuDriven;
        options.framesInFlight = 2;
        lacks.back = {0.0, 0.0, -1.0};
        lacks.right = {-1.0, 0.0, 0.0};
    }
    scene::Scene scene = boxScene();
    render::RenderOptions options =
        smallOptions(depth::parseTechnique("anchored/at:440,450,460,470,480,490,500"));
    scene::Camera fits{.fovY = 0.2};
    scene::Camera lacks{.fovY = 0.4}; ///< sees that box
};

TEST_F(SurfacesTest, AVisibilityBufferIsNotHandedOutAsAGBuffer) {
    const scene::SceneSetup setup = scenes::makeAfc(1);
    render::RenderOptions options = smallOptions(depth::parseTechnique("anchored"));
    const render::GpuScene gpuScene(device(), setup.scene);
    for (const render::SurfacePath path : render::kSurfacePaths) {
        options.surface = path;
        render::Renderer renderer(device(), setup.scene, gpuScene, options);
        for (int frame = 0; frame < 2; ++frame) {
            const render::Surfaces surfaces = renderer.surfaces();
            const bool has = path == render::SurfacePath::gbuffer;
            EXPECT_EQ(surfaces.gbuffer.image != VK_NULL_HANDLE, has);
            EXPECT_EQ(surfaces.gbuffer.format, has ? VK_FORMAT_R32G32B32A32_UINT : VK_FORMAT_UNDEFINED);
            EXPECT_EQ(surfaces.color.extent.width, options.width);
            renderer.submit(setup.path.at(0));
        }
    }
}

TEST_F(SurfacesTest, AVisibilityBufferCountsInThePredictedBytes) {
    render::RenderOptions options = smallOptions(depth::parseTechnique("anchored"));
    const std::uint64_t without = predictPictureBytes(device(), options, {});
    options.surface = render::SurfacePath::visibility;
    EXPECT_GE(predictPictureBytes(device(), options, {}),
              without + std::uint64_t{4} * options.width * options.height);
}

/// Copies in main memory count where the device's memory is main memory.
TEST_F(SurfacesTest, ARendererTakesNoMoreThanPredicted) {
    scene::Scene scene = boxScene();
    addBox(scene, {0.0, 0.0, -10.0});
    render::RenderOptions options = smallOptions(depth::parseTechnique("anchored"));
    draw(scene, {}, options); // blocks for small buffers stay
    options.width = 1280;
    options.height = 720;
    options.motion = true;
    options.linear = true;
    const std::uint64_t before = gpu::freeDeviceBytes(device());
    const SoleRenderer renderer(device(), scene, options);
    constexpr std::uint64_t kBlocks = std::uint64_t{4} << 20u;
    EXPECT_LE(before - gpu::freeDeviceBytes(device()), predictPictureBytes(device(), options, {}) + kBlocks);
}

/// Frames that lack room are drawn again. One that was submitted and left must not be over the images of the frame after it.
TEST_F(SurfacesTest, AFrameThatLackedRoomDoesNotComeOverALaterOne) {
    if (!canDrawGpuDriven()) {
        return;
    }
    const Crowded crowded;
    SoleRenderer renderer(device(), crowded.scene, crowded.options);
    renderer.submit(crowded.fits);
    renderer.submit(crowded.lacks);
    renderer.submit(crowded.fits);
    renderer.finish();
    const auto pixels = readGBuffer(device(), renderer.surfaces().gbuffer);
    EXPECT_EQ(pixels.at(240, 135).id(), 1u);
    EXPECT_EQ(renderer.render(crowded.lacks).id(240, 135), 2u);
}

/// A host may still read the images on another queue. The next frame waits for that, so it must not draw the last one again.
TEST_F(SurfacesTest, AFrameThatLackedRoomIsDrawnAgainByFinishAlone) {
    if (!canDrawGpuDriven()) {
        return;
    }
    std::vector<std::uint32_t> waits; // by submission
    gpu::BorrowedDevice handles = lentDevice();
    handles.hasGpuDrivenFeatures = true;
    handles.submit = [&](const VkSubmitInfo2& submission, VkFence done) {
        waits.push_back(submission.waitSemaphoreInfoCount);
        return gpu::functions().vkQueueSubmit2(handles.queue, 1, &submission, done);
    };
    const gpu::Device borrowed(handles);
    const test::Timeline hasRead(borrowed);
    hasRead.signal();
    const VkSemaphoreSubmitInfo read = hasRead.info();
    Crowded crowded;
    crowded.options.framesInFlight = 1;
    for (const bool isFinished : {true, false}) {
        SoleRenderer renderer(borrowed, crowded.scene, crowded.options);
        renderer.submit(crowded.lacks);
        waits.clear();
        if (isFinished) {
            renderer.finish();
        } else {
            renderer.submit(crowded.fits, {.waits = {&read, 1}});
        }
        EXPECT_EQ(waits, std::vector<std::uint32_t>{isFinished ? 0u : 1u});
        const auto pixels = readGBuffer(borrowed, renderer.surfaces().gbuffer);
        EXPECT_EQ(pixels.at(240, 135).id(), isFinished ? 2u : 1u);
    }
    {
        SoleRenderer renderer(borrowed, crowded.scene, crowded.options);
        renderer.submit(crowded.lacks);
        waits.clear();
    }
    EXPECT_TRUE(waits.empty()) << "nobody sees what is drawn while a renderer ends";
}

/// Room for the first frame's lists is not there. The frame after it is waited for nonetheless.
TEST_F(SurfacesTest, AFrameThatFailsLateDoesNotKeepLaterOnesInFlight) {
    if (!canDrawGpuDriven()) {
        return;
    }
    const Crowded crowded;
    std::optional<SoleRenderer> renderer;
    for (const bool isFinished : {true, false}) {
        renderer.emplace(device(), crowded.scene, crowded.options);
        renderer->submit(crowded.lacks);
        renderer->submit(crowded.lacks);
        const FailingCall failing("vkCreateBuffer");
        if (isFinished) {
            EXPECT_THROW(renderer->finish(), std::exception);
            EXPECT_GT(renderer->lastStats().draws, 0u); // the device counted them
        } else {
            renderer.reset(); // validation would say what is destroyed while it is in use
        }
        EXPECT_TRUE(FailingCall::hasFailed());
    }
}

/// Emulated snapping is by the picture's size.
TEST_F(SurfacesTest, VerticesOfAResizedPictureSnapByItsOwnSize) {
    const scene::SceneSetup setup = scenes::makeAfc(1);
    const scene::Camera camera = setup.path.at(7);
    const render::GpuScene gpuScene(device(), setup.scene);
    for (const render::SurfacePath path : render::kSurfacePaths) {
        render::RenderOptions options = smallOptions(depth::parseTechnique("anchored"));
        options.surface = path;
        options.snapBits = 1;
        render::Renderer renderer(device(), setup.scene, gpuScene, options);
        renderer.submit(camera);
        options.width = 333;
        options.height = 111;
        renderer.resize(options.width, options.height);
        EXPECT_EQ(hashOf(renderer.render(camera)), hashOf(draw(setup.scene, camera, options)));
    }
}

/// A host's square in the far cascade is in the part that draws it, and in no other.
TEST_F(SurfacesTest, AHostDrawsIntoTheCascadesOfAPart) {
    scene::Scene scene = boxScene();
    addBox(scene, {-0.5, 0.0, -3.0});
    render::RenderOptions options = thumbnailOptions(depth::parseTechnique("anchored/count:2"));
    const render::GpuScene gpuScene(device(), scene);
    const HostRectangles squares(device(), vk::Format(device().depthFormat(depth::DepthFormat::d32f)));
    for (std::size_t part = 0; part < 2; ++part) {
        options.part = {.index = part, .count = 2};
        HostSide host(device(), {options.width, options.height});
        render::Renderer renderer(device(), scene, gpuScene, options);
        render::HostFrame frame = host.begin();
        std::vector<std::uint32_t> drawn;
        frame.draw = [&](const render::HostCascade& cascade) {
            drawn.push_back(cascade.index);
            squares.draw(cascade, {.x = 0.0, .distanceView = 900.0, .halfSide = 90.0, .object = 10});
        };
        host.submit(renderer, {.fovY = 0.5, .nearView = 1.0, .farView = 1000.0}, frame);
        const auto pixels = readGBuffer(device(), renderer.surfaces().gbuffer);
        EXPECT_EQ(pixels.at(55, 27).id(), part == 0 ? 0u : 11u);
        EXPECT_EQ(drawn, std::vector{static_cast<std::uint32_t>(part)});
    }
}

} // namespace

} // namespace cdr::render_test
