#include "../../support/worst.h"
#include "../fixture.h"
#include "../output/held.h"
#include "../output/truth_motion.h"

#include <cdr/measure/certify/certifier.h>
#include <cdr/measure/compare/flip_difference.h>
#include <cdr/measure/compare/flips.h>
#include <cdr/measure/truth/layered_truth.h>
#include <scenes/moving_scene.h>
#include <scenes/open_scene.h>

#include <list>
#include <map>
#include <string>
#include <utility>

namespace cdr::render_test {

namespace {

constexpr const char* kMachine = CDR_SOURCE_DIR "/tests/assets/machine.glb";
constexpr const char* kStage = CDR_SOURCE_DIR "/tests/assets/stage.glb";
constexpr double kFramesPerSecond = 4.0;

/// The objects of machine.glb that its animation "work" turns and moves as they are, plus one.
constexpr std::uint32_t kRigidIds[] = {2, 3, 4};

class AnimationTest : public RenderTest {
  protected:
    static scene::OpenedScene open(double seconds, std::optional<double> framesPerSecond) {
        scene::GltfChoice choice;
        choice.seconds = seconds;
        choice.framesPerSecond = framesPerSecond;
        choice.camera = 0;
        return scenes::openScene(kMachine, scenes::kDefaultSeed, choice);
    }
    static render::RenderOptions options(const char* technique, std::size_t threads = 2) {
        return options(depth::parseTechnique(technique), threads);
    }
    static render::RenderOptions options(const depth::Technique& technique, std::size_t threads = 2) {
        render::RenderOptions options = smallOptions(technique, 240, 180);
        options.threads = threads;
        return options;
    }
};

/// Skins, morph targets and nodes. A world that was brought to a moment is as the file opened at that moment. That holds for
/// any number of threads that deform and record.
TEST_F(AnimationTest, FramesAreThoseOfAFileOpenedAtTheirMoment) {
    const scene::OpenedScene opened = open(0.0, kFramesPerSecond);
    std::map<std::pair<std::string, std::uint32_t>, std::string> stills; // hashes by technique and frame
    for (const std::size_t threads : {std::size_t{1}, std::size_t{3}, std::size_t{16}}) {
        platform::WorkerPool workers(threads);
        for (const auto& [name, technique] : depth::presets()) {
            if (threads != 3 && name != "anchored" && name != "cdr") {
                continue; // how many threads deform does not depend on the technique
            }
            scenes::MovingScene moving(opened.setup.scene, opened.setup.motion);
            SoleRenderer renderer(device(), moving.world(), options(technique, threads));
            for (const std::uint32_t frame : {1u, 2u, 5u, 3u, 8u, 40u}) {
                EXPECT_TRUE(moving.show(frame, workers));
                renderer.forgetFrames();
                std::string& expected = stills[{name, frame}];
                if (expected.empty()) {
                    const scene::SceneSetup still = open(frame / kFramesPerSecond, {}).setup;
                    EXPECT_FALSE(still.motion);
                    expected = hashOf(draw(still.scene, still.path.at(0), options(technique, 1)));
                }
                ASSERT_EQ(hashOf(renderer.render(opened.setup.path.at(frame))), expected)
                    << name << ", frame " << frame << ", " << threads << " threads";
            }
        }
    }
}

/// The truth and the certificate follow what deforms. A caster that was told of nothing sees another picture.
TEST_F(AnimationTest, TruthSeesTheSameTriangles) {
    const scene::OpenedScene opened = open(0.0, kFramesPerSecond);
    platform::WorkerPool workers(2);
    scenes::MovingScene moving(opened.setup.scene, opened.setup.motion);
    measure::TruthCaster caster(moving.world().scene(), workers);
    const measure::TruthCaster untold(moving.world().scene(), workers);
    render::GpuScene onDevice(device(), moving.world());
    std::list<render::Renderer> renderers;
    for (const auto& [name, technique] : depth::presets()) {
        renderers.emplace_back(device(), onDevice, options(technique));
    }
    for (const std::uint32_t frame : {1u, 3u, 4u, 6u, 8u}) {
        moving.show(frame, workers);
        caster.follow(moving.deformedMeshes(), workers);
        const scene::Camera camera = opened.setup.path.at(frame);
        const render::RenderOptions size = options("anchored");
        const measure::TruthImage truth = caster.cast(camera, size.width, size.height, workers);
        const measure::TruthImage other = untold.cast(camera, size.width, size.height, workers);
        for (render::Renderer& renderer : renderers) {
            const image::ImageU32 drawn = renderer.render(camera).ids();
            EXPECT_EQ(measure::countWrong(drawn, truth).wrong, 0u) << "frame " << frame;
            EXPECT_GT(measure::countWrong(drawn, other).wrong, 0u) << "frame " << frame;
        }
    }
}

/// What moves changes pixels and is no flip, because truth moves with it. With a truth that stays it would be one.
TEST_F(AnimationTest, NothingFlipsWhileAnAnimationPlays) {
    constexpr std::uint32_t kFrames = 5;
    const scene::OpenedScene opened = open(0.0, 24.0);
    platform::WorkerPool workers(2);
    scenes::MovingScene moving(opened.setup.scene, opened.setup.motion);
    measure::TruthCaster caster(moving.world().scene(), workers);
    render::GpuScene onDevice(device(), moving.world());
    std::list<render::Renderer> renderers;
    for (const auto& [name, technique] : depth::presets()) {
        renderers.emplace_back(device(), onDevice, options(technique));
    }
    std::vector<image::ImageU32> before(renderers.size());
    measure::TruthImage truthBefore;
    for (std::uint32_t frame = 0; frame < kFrames; ++frame) {
        moving.show(frame, workers);
        caster.follow(moving.deformedMeshes(), workers);
        const scene::Camera camera = opened.setup.path.at(frame);
        const render::RenderOptions size = options("anchored");
        const measure::TruthImage truth = caster.cast(camera, size.width, size.height, workers);
        std::size_t technique = 0;
        for (render::Renderer& renderer : renderers) {
            const image::ImageU32 drawn = renderer.render(camera).ids();
            image::ImageU32& last = before[technique++];
            if (frame > 0) {
                const measure::FlipCount flips = measure::countFlips({last, truthBefore}, {drawn, truth});
                EXPECT_GT(flips.compared, 10'000u);
                EXPECT_EQ(flips.flips, 0u) << depth::presets()[technique - 1].name << ", frame " << frame;
                EXPECT_GT(measure::countFlips({last, truth}, {drawn, truth}).flips, 0u) << "frame " << frame;
            }
            last = drawn;
        }
        truthBefore = truth;
    }
}

/// Lights go with their nodes. A world that was brought to a frame is lit as the file opened at that moment, and as the
/// float64 truth.
TEST_F(AnimationTest, LightsFollowNodes) {
    const auto openStage = [](double seconds, std::optional<double> framesPerSecond) {
        scene::GltfChoice choice;
        choice.seconds = seconds;
        choice.framesPerSecond = framesPerSecond;
        choice.camera = 0;
        choice.light = scene::ModelLight::file;
        return scenes::openScene(kStage, scenes::kDefaultSeed, choice).setup;
    };
    const scene::SceneSetup opened = openStage(0.0, kFramesPerSecond);
    for (const std::size_t threads : {std::size_t{1}, std::size_t{3}, std::size_t{16}}) {
        platform::WorkerPool workers(threads);
        for (const char* technique : {"anchored", "cdr"}) {
            scenes::MovingScene moving(opened.scene, opened.motion);
            SoleRenderer renderer(device(), moving.world(), withSorting(options(technique, threads)));
            std::string last;
            for (const std::uint32_t frame : {1u, 2u, 5u, 3u, 8u}) {
                moving.show(frame, workers);
                renderer.forgetFrames();
                const scene::Camera camera = opened.path.at(frame);
                const render::Frame drawn = renderer.render(camera);
                const scene::SceneSetup still = openStage(frame / kFramesPerSecond, {});
                ASSERT_EQ(hashOf(drawn),
                          hashOf(draw(still.scene, camera, withSorting(options(technique, 1)))))
                    << technique << frame;
                EXPECT_NE(hashOf(drawn), last);
                last = hashOf(drawn);
                if (threads == 3) {
                    const auto truth = measure::castLayers(moving.world().scene(), camera, drawn.width(),
                                                           drawn.height(), workers);
                    EXPECT_LE(measure::FlipDifference().mean(pictureOf(truth), drawn.color, workers), 0.03)
                        << technique << frame;
                }
            }
        }
    }
}

/// Motion is exact where nodes move as they are; what deforms moves by the point that it goes with.
TEST_F(AnimationTest, MotionFollowsNodes) {
    const scene::OpenedScene opened = open(0.1, 24.0);
    platform::WorkerPool workers(2);
    scenes::MovingScene moving(opened.setup.scene, opened.setup.motion);
    render::RenderOptions chosen = options("anchored");
    chosen.motion = true;
    SoleRenderer renderer(device(), moving.world(), chosen);
    renderer.render(opened.setup.path.at(0));
    for (std::uint32_t number = 1; number < 5; ++number) {
        const scene::Scene sceneBefore = moving.world().scene();
        const scene::Camera before = opened.setup.path.at(number - 1);
        const scene::Camera now = opened.setup.path.at(number);
        moving.show(number, workers);
        const render::Frame frame = renderer.render(now);
        const measure::TruthImage held = heldBy(frame);
        const auto exact = truthMotion(held, {moving.world().scene(), now}, {sceneBefore, before});
        for (const std::uint32_t id : kRigidIds) {
            std::size_t pixels = 0;
            double most = 0.0;
            double longest = 0.0;
            for (std::size_t i = 0; i < held.pixels.size(); ++i) {
                if (held.pixels[i].id == id) {
                    ++pixels;
                    most = test::worseOf(most,
                                         glm::length(glm::dvec2(frame.motion.pixels[i]) - exact.pixels[i]));
                    longest = std::max(longest, glm::length(exact.pixels[i]));
                }
            }
            EXPECT_GT(pixels, 10u) << id;
            EXPECT_GT(longest, 0.5) << id;
            EXPECT_LT(most, 0.01) << id;
        }
    }
}

} // namespace

} // namespace cdr::render_test
