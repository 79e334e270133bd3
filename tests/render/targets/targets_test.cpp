#include "../../support/refusal.h"
#include "../fixture.h"

#include <cdr/gpu/memory.h>
#include <cdr/render/targets/targets.h>
#include <scenes/cubes.h>
#include <scenes/open_scene.h>

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace cdr::render_test {

namespace {

using render::Frame;
using render::TargetsChoice;
using render::TargetsKind;

render::RenderOptions tinyOptions(const depth::Technique& technique, const TargetsChoice& targets,
                                  std::size_t threads) {
    return {.width = 240, .height = 135, .technique = technique, .targets = targets, .threads = threads};
}

/// The presets, and one that cuts everything in view into many cascades.
std::vector<depth::Technique> techniques() {
    std::vector<depth::Technique> all = presetTechniques();
    all.push_back(
        depth::Technique{depth::Mapping::standard, depth::parseSplit("count:7"), depth::DepthFormat::d32f});
    return all;
}

class TargetsTest : public RenderTest {
  protected:
    /// Renders a frame with every kind of targets that must agree, on several numbers of threads.
    void expectOneImage(const scene::Scene& scene, const scene::Camera& camera,
                        const std::vector<std::size_t>& threadCounts = {1, 4}) {
        const render::GpuScene gpuScene(device(), scene);
        for (const depth::Technique& technique : techniques()) {
            std::string first;
            for (const char* targets : {"single", "accumulate", "pool:2", "pool:3", "pool:4", "layers"}) {
                const TargetsChoice choice = render::parseTargets(targets);
                for (const std::size_t threads : threadCounts) {
                    const std::string hash =
                        hashOf(draw(scene, gpuScene, camera, tinyOptions(technique, choice, threads)));
                    first = first.empty() ? hash : first;
                    EXPECT_EQ(hash, first) << nameOf(technique) << " " << targets << " " << threads;
                }
            }
        }
    }
};

TEST_F(TargetsTest, AfcIsOneImageWhateverTheTargetsAndThreads) {
    const scene::SceneSetup setup = scenes::makeAfc(2013);
    expectOneImage(setup.scene, setup.path.at(40));
}

TEST_F(TargetsTest, RotationIsOneImageWhateverTheTargetsAndThreads) {
    const scene::SceneSetup setup = scenes::makeRotation(2013, 2000);
    expectOneImage(setup.scene, setup.path.at(40), {1, 3, 16});
}

TEST_F(TargetsTest, GltfIsOneImageWhateverTheTargetsAndThreads) {
    const scene::OpenedScene opened =
        scenes::openScene(CDR_SOURCE_DIR "/tests/assets/garden.glb", scenes::kDefaultSeed);
    expectOneImage(opened.setup.scene, opened.setup.path.at(0));
}

/// Races show now and then, not always.
TEST_F(TargetsTest, FiftyFramesByEightThreadsAreOneImage) {
    const scene::SceneSetup setup = scenes::makeRotation(7, 20'000);
    const auto technique =
        depth::Technique{depth::Mapping::standard, depth::parseSplit("count:5"), depth::DepthFormat::d32f};
    const scene::Camera camera = setup.path.at(90);
    SoleRenderer renderer(device(), setup.scene, tinyOptions(technique, TargetsChoice::pool(3), 8));
    const Frame first = renderer.render(camera);
    EXPECT_EQ(first.cascades.size(), 5u);
    for (int repeat = 1; repeat < 50; ++repeat) {
        const Frame frame = renderer.render(camera);
        ASSERT_EQ(hashOf(frame), hashOf(first)) << repeat;
    }
}

TEST_F(TargetsTest, TheNumberOfCascadesMayChangeBetweenFrames) {
    const scene::SceneSetup setup = scenes::makeRotation(3, 1000);
    const render::GpuScene gpuScene(device(), setup.scene);
    const auto technique =
        depth::Technique{depth::Mapping::log, depth::parseSplit("ratio:10"), depth::DepthFormat::d32f};
    for (const char* targets : {"single", "accumulate", "pool:2", "pool:5", "layers", "one-pass"}) {
        const TargetsChoice choice = render::parseTargets(targets);
        render::Renderer warm(device(), setup.scene, gpuScene, tinyOptions(technique, choice, 2));
        for (const auto& [decades, near] :
             {std::pair{2u, 5.0}, {6u, 0.01}, {1u, 40.0}, {9u, 1e-4}, {2u, 5.0}}) {
            scene::Camera camera = setup.path.at(10 * decades);
            camera.nearView = near;
            camera.farView = near * std::pow(10.0, decades) * 0.999;
            const Frame frame = warm.render(camera);
            EXPECT_EQ(frame.cascades.size(), decades);
            EXPECT_EQ(hashOf(frame),
                      hashOf(draw(setup.scene, gpuScene, camera, tinyOptions(technique, choice, 1))))
                << targets << " " << decades;
            if (choice.kind != TargetsKind::onePass) {
                render::Renderer single(device(), setup.scene, gpuScene,
                                        tinyOptions(technique, TargetsKind::single, 1));
                EXPECT_EQ(hashOf(frame), hashOf(single.render(camera))) << targets << " " << decades;
            }
        }
    }
}

/// Pixels such that a picture fits, but not `layers` layers of 20 bytes a pixel.
std::uint32_t sideTooLargeFor(const gpu::Device& device, std::uint32_t layers) {
    const auto free = static_cast<double>(gpu::freeDeviceBytes(device));
    return static_cast<std::uint32_t>(std::ceil(std::sqrt(1.1 * free / (20.0 * layers))));
}

/// What a pool of 16 layers is told on a device that has no room for it.
TEST_F(TargetsTest, APoolThatDoesNotFitIsRefusedWithBothFigures) {
    const std::uint32_t side = sideTooLargeFor(device(), render::kMaxPoolLayers);
    const render::TargetsOptions options{.extent = {side, side}, .depthFormat = depth::DepthFormat::d32f};
    const std::uint64_t free = gpu::freeDeviceBytes(device());
    const std::string message = test::runErrorOf(
        [&] { render::makeTargets(device(), TargetsChoice::pool(render::kMaxPoolLayers), options); });
    const std::uint64_t accumulated =
        gpu::predictBytes(device(), render::colorOptions(options.extent, render::kGBufferFormat));
    const std::uint64_t layer = render::predictLayerBytes(device(), options.extent, options.depthFormat);
    EXPECT_GE(layer, std::uint64_t{side} * side * 20);
    const double needed = static_cast<double>(accumulated + 16 * layer) / 0x1p20;
    EXPECT_NE(message.find(fmt::format("an accumulated G-buffer of {0}x{0} with 16 layers needs {1:.1f} MiB",
                                       side, needed)),
              std::string::npos)
        << message;
    EXPECT_NE(message.find(fmt::format("{:.1f} MiB are free", double(free) / 0x1p20)), std::string::npos)
        << message;
    EXPECT_EQ(gpu::freeDeviceBytes(device()), free);
}

/// Layers are made when a frame needs them, so it is the frame that is refused; the next may be drawn.
TEST_F(TargetsTest, AFrameOfTooManyLayersIsRefusedAndTheNextIsDrawn) {
    const scene::SceneSetup setup = scenes::makeRotation(5, 100);
    const auto technique =
        depth::Technique{depth::Mapping::standard, depth::parseSplit("ratio:1.2"), depth::DepthFormat::d32f};
    auto options = tinyOptions(technique, TargetsKind::layers, 1);
    options.width = options.height = sideTooLargeFor(device(), 60);
    SoleRenderer renderer(device(), setup.scene, options);
    scene::Camera camera = setup.path.at(0);
    camera.nearView = 1.0;
    camera.farView = std::pow(1.2, 63.5);
    const std::string message = test::runErrorOf([&] { renderer.draw(camera); });
    EXPECT_NE(message.find("63 layer G-buffers of"), std::string::npos) << message;
    camera.nearView = 300.0;
    camera.farView = 400.0;
    EXPECT_EQ(renderer.render(camera).cascades.size(), 2u);
}

} // namespace

} // namespace cdr::render_test
