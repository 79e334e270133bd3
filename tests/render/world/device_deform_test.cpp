#include "../fixture.h"

#include <scenes/moving_scene.h>
#include <scenes/open_scene.h>

namespace cdr::render_test {

namespace {

constexpr const char* kMachineFile = CDR_SOURCE_DIR "/tests/assets/machine.glb";
constexpr const char* kVeilsFile = CDR_SOURCE_DIR "/tests/assets/veils.glb";

/// Files whose skins and morph targets the device bends.
class DeviceDeformTest : public DeformTest {
  protected:
    static scene::SceneSetup open(const char* file, double framesPerSecond) {
        scene::GltfChoice choice;
        choice.seconds = 0.0;
        choice.framesPerSecond = framesPerSecond;
        return scenes::openScene(file, scenes::kDefaultSeed, choice).setup;
    }
    static render::RenderOptions options(const depth::Technique& technique, std::size_t threads = 2) {
        render::RenderOptions options = quarterOf(smallOptions(technique));
        options.threads = threads;
        return options;
    }

    /// Draws the same frames, deformed by each, and expects them to be the same.
    void expectSame(const scene::SceneSetup& setup, const render::RenderOptions& options,
                    std::initializer_list<std::uint32_t> frames, const std::string& what) {
        platform::WorkerPool workers(options.threads);
        scenes::MovingScene byCpu(setup.scene, setup.motion, scenes::Deform::cpu);
        scenes::MovingScene byDevice(setup.scene, setup.motion, scenes::Deform::device);
        SoleRenderer cpu(device(), byCpu.world(), options);
        SoleRenderer other(device(), byDevice.world(), options);
        for (const std::uint32_t frame : frames) {
            byCpu.show(frame, workers);
            byDevice.show(frame, workers);
            const render::Frame expected = cpu.render(setup.path.at(frame));
            const render::Frame drawn = other.render(setup.path.at(frame));
            ASSERT_EQ(hashOf(drawn), hashOf(expected)) << what << ", frame " << frame;
            ASSERT_EQ(drawn.motion.pixels, expected.motion.pixels) << what << ", frame " << frame;
        }
    }
};

TEST_F(DeviceDeformTest, FramesAreThoseOfTheCpu) {
    const scene::SceneSetup setup = open(kMachineFile, 4.0);
    for (const auto& [name, technique] : depth::presets()) {
        expectSame(setup, options(technique), {0u, 1u, 2u, 5u, 3u, 8u, 40u}, name);
    }
    for (const render::Submission submission : submissions()) {
        for (const std::size_t threads : {std::size_t{1}, std::size_t{4}}) {
            render::RenderOptions chosen = options(depth::parseTechnique("anchored"), threads);
            chosen.submission = submission;
            chosen.shadows.method = render::ShadowMethod::anchored;
            expectSame(setup, chosen, {1u, 2u, 5u}, std::string(nameOf(submission)));
            chosen.shadows = {};
            chosen.occlusionCulling = true;
            expectSame(setup, chosen, {1u, 2u, 5u},
                       std::string(nameOf(submission)) + " with occlusion culling");
        }
    }
}

/// Motion needs the vertices of the last frame, which a frame in flight may still read.
TEST_F(DeviceDeformTest, MotionIsThatOfTheCpu) {
    const scene::SceneSetup setup = open(kMachineFile, 24.0);
    for (const std::size_t inFlight : {std::size_t{1}, std::size_t{3}}) {
        render::RenderOptions chosen = options(depth::parseTechnique("anchored"));
        chosen.motion = true;
        chosen.framesInFlight = inFlight;
        expectSame(setup, chosen, {0u, 1u, 2u, 3u, 6u, 6u, 2u}, std::to_string(inFlight) + " in flight");
    }
}

TEST_F(DeviceDeformTest, BlendedSurfacesAreThoseOfTheCpu) {
    const scene::SceneSetup setup = open(kVeilsFile, 4.0);
    render::RenderOptions chosen = options(depth::parseTechnique("anchored"));
    for (const render::Translucency method : {render::Translucency::weighted, render::Translucency::sorted}) {
        chosen.translucency.method = method;
        expectSame(setup, chosen, {1u, 2u, 5u}, std::string(nameOf(method)));
    }
}

/// The CPU's triangles are those of what the device draws, where truth asks for them.
TEST_F(DeviceDeformTest, TruthSeesWhatTheDeviceDraws) {
    const scene::SceneSetup setup = open(kMachineFile, 4.0);
    platform::WorkerPool workers(2);
    scenes::MovingScene moving(setup.scene, setup.motion, scenes::Deform::both);
    measure::TruthCaster caster(moving.world().scene(), workers);
    const render::RenderOptions size = options(depth::parseTechnique("anchored"));
    SoleRenderer renderer(device(), moving.world(), size);
    for (const std::uint32_t frame : {1u, 3u, 6u}) {
        moving.show(frame, workers);
        caster.follow(moving.deformedMeshes(), workers);
        const scene::Camera camera = setup.path.at(frame);
        const measure::TruthImage truth = caster.cast(camera, size.width, size.height, workers);
        EXPECT_EQ(measure::countWrong(renderer.render(camera).ids(), truth).wrong, 0u) << "frame " << frame;
    }
}

} // namespace

} // namespace cdr::render_test
