#include "fixture.h"

#include <cdr/base/error.h>
#include <cdr/host/sha256.h>
#include <scenes/cubes.h>

#include <algorithm>
#include <cmath>
#include <limits>

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
    host::WorkerPool workers(1);
    const auto truth = measure::castTruth(setup.scene, camera, 480, 270, workers);
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

TEST_F(FrameTest, ManyFramesFromOneRendererEqualFreshOnes) {
    const scene::SceneSetup setup = scenes::makeRotation(1, 5000);
    const render::GpuScene gpuScene(device(), setup.scene);
    const auto options = smallOptions(depth::parseTechnique("cdr"));
    render::Renderer warm(device(), setup.scene, gpuScene, options);
    for (const std::uint32_t number : {0u, 200u, 90u, 0u}) {
        render::Renderer fresh(device(), setup.scene, gpuScene, options);
        const scene::Camera camera = setup.path.at(number);
        const Frame a = warm.render(camera);
        const Frame b = fresh.render(camera);
        EXPECT_EQ(hashOf(a), hashOf(b));
    }
}

TEST_F(FrameTest, AnEmptySceneIsBackground) {
    const scene::Scene scene = boxScene();
    const Frame frame = draw(scene, scene::Camera{}, smallOptions(depth::parseTechnique("logcdr")));
    EXPECT_TRUE(std::all_of(frame.gbuffer.pixels.begin(), frame.gbuffer.pixels.end(),
                            [](const render::GBufferPixel& pixel) { return pixel.idAndCascade == 0; }));
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
    const gpu::BorrowedDevice handles{.instance = instance().handle(),
                                      .physical = device().physical(),
                                      .device = device().handle(),
                                      .queue = device().queue(),
                                      .queueFamily = device().queueFamily(),
                                      .hasDebugNames = instance().hasDebugNames()};
    {
        const gpu::Device borrowed(handles);
        const render::GpuScene gpuScene(borrowed, setup.scene);
        render::Renderer renderer(borrowed, setup.scene, gpuScene, options);
        EXPECT_EQ(renderer.render(camera).color, own.color);
    }
    EXPECT_EQ(draw(setup.scene, camera, options).color, own.color);
}

} // namespace

} // namespace cdr::render_test
