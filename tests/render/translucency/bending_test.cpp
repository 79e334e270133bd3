#include "../fixture.h"

#include <cdr/measure/truth/layered_truth.h>
#include <scenes/moving_scene.h>
#include <scenes/open_scene.h>

#include <list>
#include <string>

namespace cdr::render_test {

namespace {

constexpr const char* kVeils = CDR_SOURCE_DIR "/tests/assets/veils.glb";
constexpr double kVeilFps = 4.0;
constexpr std::uint32_t kVeilFrames[] = {0, 1, 3, 6, 8};

/// Blended meshes of a file that joints and a morph target bend.
class BendingTest : public RenderTest {
  protected:
    static scene::SceneSetup open() {
        scene::GltfChoice choice;
        choice.seconds = 0.0;
        choice.framesPerSecond = kVeilFps;
        choice.camera = 0;
        return scenes::openScene(kVeils, scenes::kDefaultSeed, choice).setup;
    }
    static render::RenderOptions sorted(const depth::Technique& technique) {
        return {.width = 240,
                .height = 180,
                .technique = technique,
                .translucency = {.method = render::Translucency::sorted, .countsFragments = true}};
    }
    static std::string pictureOf(const render::Frame& frame) {
        return program::sha256Of(frame.color.pixels) + program::sha256Of(frame.fragmentCounts.pixels);
    }
};

/// One renderer, and how its options differ from those of others.
struct Drawer {
    Drawer(const gpu::Device& device, render::GpuScene& scene, const render::RenderOptions& options)
        : name(std::string(nameOf(options.technique)) + " " + std::string(nameOf(options.submission)) + " " +
               std::to_string(options.threads)),
          renderer(device, scene, options) {}

    std::string name;
    render::Renderer renderer;
};

/// For each preset: every submission by one thread and by four gives one picture, which is the truth to two steps of 255.
TEST_F(BendingTest, SortedIsTheTruthAtEachMomentHoweverDrawn) {
    const scene::SceneSetup setup = open();
    platform::WorkerPool workers(2);
    scenes::MovingScene moving(setup.scene, setup.motion);
    render::GpuScene onDevice(device(), moving.world());
    std::list<std::list<Drawer>> presets;
    for (const depth::NamedTechnique& preset : depth::presets()) {
        std::list<Drawer>& drawers = presets.emplace_back();
        for (const render::Submission submission : submissions()) {
            for (const std::size_t threads : {std::size_t{1}, std::size_t{4}}) {
                render::RenderOptions options = sorted(preset.technique);
                options.submission = submission;
                options.threads = threads;
                drawers.emplace_back(device(), onDevice, options);
            }
        }
    }
    std::string last;
    for (const std::uint32_t frame : kVeilFrames) {
        moving.show(frame, workers);
        const scene::Camera camera = setup.path.at(frame);
        const measure::LayeredTruth truth =
            measure::castLayers(moving.world().scene(), camera, 240, 180, workers);
        for (std::list<Drawer>& drawers : presets) {
            std::string wanted;
            for (Drawer& drawer : drawers) {
                const render::Frame drawn = drawer.renderer.render(camera);
                ASSERT_EQ(drawn.stats.translucency.method, render::Translucency::sorted);
                const measure::LayerDifference difference =
                    measure::compareLayers(drawn.color, drawn.fragmentCounts, truth);
                EXPECT_GT(difference.translucent, 5'000u) << drawer.name << ", frame " << frame;
                EXPECT_EQ(difference.miscounted, 0u) << drawer.name << ", frame " << frame;
                // Glossy surfaces that are seen at a low angle are off by two.
                EXPECT_LE(difference.largestError, 2u) << drawer.name << ", frame " << frame;
                EXPECT_GE(difference.withinFraction(), 0.995) << drawer.name << ", frame " << frame;
                wanted = wanted.empty() ? pictureOf(drawn) : wanted;
                EXPECT_EQ(pictureOf(drawn), wanted) << drawer.name << ", frame " << frame;
            }
            EXPECT_NE(wanted, last) << "frame " << frame; // what moves is seen
            last = &drawers == &presets.back() ? wanted : last;
        }
    }
}

/// The bent surfaces are what the truth is held against: it differs where the world has moved on.
TEST_F(BendingTest, AnEarlierMomentIsNotTheTruth) {
    const scene::SceneSetup setup = open();
    platform::WorkerPool workers(2);
    scenes::MovingScene moving(setup.scene, setup.motion);
    const scene::Camera camera = setup.path.at(0);
    const measure::LayeredTruth before =
        measure::castLayers(moving.world().scene(), camera, 240, 180, workers);
    moving.show(1, workers);
    const render::Frame drawn =
        draw(moving.world().scene(), camera, sorted(depth::parseTechnique("anchored")));
    const measure::LayerDifference difference =
        measure::compareLayers(drawn.color, drawn.fragmentCounts, before);
    EXPECT_GT(difference.miscounted, 100u);
    EXPECT_LT(difference.withinFraction(), 0.9);
}

} // namespace

} // namespace cdr::render_test
