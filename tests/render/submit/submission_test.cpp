#include "../fixture.h"

#include <cdr/base/error.h>
#include <scenes/cubes.h>
#include <scenes/open_scene.h>

#include <algorithm>
#include <utility>

namespace cdr::render_test {

namespace {

using render::Batching;
using render::Submission;
using render::TargetsKind;

render::RenderOptions tinyOptions(const depth::Technique& technique) {
    return {.width = 240, .height = 135, .technique = technique};
}

std::vector<depth::Technique> techniquesToSubmit() {
    std::vector<depth::Technique> all = presetTechniques();
    all.push_back(
        depth::Technique{depth::Mapping::standard, depth::parseSplit("count:7"), depth::DepthFormat::d16});
    return all;
}

/// Two meshes in turn, one of them mirrored now and then, so that runs are short and states change; shiny and
/// matt.
scene::SceneSetup patchwork(std::uint32_t objects) {
    scene::SceneSetup setup = scenes::makeRotation(5, objects);
    scene::Scene& scene = setup.scene;
    scene.meshes.push_back(scene::makeBox(glm::vec3(0.9f, 0.2f, 0.5f)));
    scene.materials[0].metallicRoughness = scene::MetallicRoughness{.metallic = 1.0f, .roughness = 0.3f};
    scene.materials.push_back(
        {.name = "both sides",
         .metallicRoughness = scene::MetallicRoughness{.metallic = 0.0f, .roughness = 0.5f},
         .doubleSided = true});
    scene.materials.push_back({.name = "matt"});
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        scene.instances.mesh[i] = i % 3 == 0 ? 1 : 0;
        scene.instances.material[i] = i % 70 < 20 ? 1 : i % 70 < 30 ? 2 : 0;
        if (i % 11 == 0) {
            scene.instances.basis[i][0] = -scene.instances.basis[i][0];
        }
    }
    return setup;
}

class SubmissionTest : public RenderTest {
  protected:
    /// Renders with every submission over one kind of targets and expects one image.
    void expectOneImage(const scene::Scene& scene, const render::GpuScene& gpuScene,
                        const scene::Camera& camera, const depth::Technique& technique, TargetsKind targets) {
        render::RenderOptions options = tinyOptions(technique);
        options.targets = targets;
        const render::Frame wanted = draw(scene, gpuScene, camera, options);
        for (const auto& [submission, threads] : {std::pair{Submission::primaries, 1u},
                                                  {Submission::primaries, 3u},
                                                  {Submission::gpuDriven, 3u}}) {
            if (submission == Submission::gpuDriven && !canDrawGpuDriven()) {
                continue;
            }
            options.submission = submission;
            options.threads = threads;
            const render::Frame frame = draw(scene, gpuScene, camera, options);
            EXPECT_EQ(hashOf(frame), hashOf(wanted))
                << nameOf(technique) << " " << nameOf(targets) << " " << nameOf(submission);
            EXPECT_EQ(frame.stats.draws, wanted.stats.draws) << nameOf(submission);
            EXPECT_EQ(frame.stats.visible, wanted.stats.visible) << nameOf(submission);
        }
    }

    /// Each technique with one kind of targets, in turn: what a scene does to the submissions, since one scene
    /// is tried with all pairs.
    void expectOneImageInTurn(const scene::Scene& scene, const scene::Camera& camera) {
        const render::GpuScene gpuScene(device(), scene);
        std::size_t turn = 0;
        for (const depth::Technique& technique : techniquesToSubmit()) {
            expectOneImage(scene, gpuScene, camera, technique,
                           render::kTargetsKinds[turn++ % render::kTargetsKinds.size()]);
        }
    }
};

TEST_F(SubmissionTest, AfcIsOneImageHoweverSubmitted) {
    const scene::SceneSetup setup = scenes::makeAfc(2013);
    expectOneImageInTurn(setup.scene, setup.path.at(40));
}

TEST_F(SubmissionTest, RotationIsOneImageHoweverSubmitted) {
    const scene::SceneSetup setup = scenes::makeRotation(2013, 8000);
    expectOneImageInTurn(setup.scene, setup.path.at(40));
}

TEST_F(SubmissionTest, ManyKindsAreOneImageHoweverSubmitted) {
    const scene::SceneSetup setup = patchwork(600);
    const render::GpuScene gpuScene(device(), setup.scene);
    for (const depth::Technique& technique : techniquesToSubmit()) {
        for (const TargetsKind targets : render::kTargetsKinds) {
            expectOneImage(setup.scene, gpuScene, setup.path.at(90), technique, targets);
        }
    }
}

TEST_F(SubmissionTest, GltfIsOneImageHoweverSubmitted) {
    const scene::OpenedScene opened =
        scenes::openScene(CDR_SOURCE_DIR "/tests/assets/garden.glb", scenes::kDefaultSeed);
    expectOneImageInTurn(opened.setup.scene, opened.setup.path.at(0));
}

TEST_F(SubmissionTest, MoreRunsThanAShadersLoopHasTurnsAreOneImage) {
    scene::SceneSetup setup = scenes::makeRotation(5, 140'000); // a driver may end a loop after 65,535 turns
    setup.scene.materials.push_back({.name = "red", .baseColorFactor = glm::vec4(1.0f, 0.1f, 0.1f, 1.0f)});
    for (std::size_t i = 0; i < setup.scene.instances.size(); i += 2) {
        setup.scene.instances.material[i] = 1;
    }
    render::RenderOptions options = tinyOptions(depth::parseTechnique("reversed"));
    const std::string wanted = hashOf(draw(setup.scene, setup.path.at(0), options));
    for (const Submission submission : submissions()) {
        options.submission = submission;
        EXPECT_EQ(hashOf(draw(setup.scene, setup.path.at(0), options)), wanted) << nameOf(submission);
    }
}

/// Cubes as large as their cascades are thin: each lands in many, more than there was room for at first.
TEST_F(SubmissionTest, GpuDrivenDrawsAgainWhenItsRecordsRunOut) {
    if (!canDrawGpuDriven()) {
        return;
    }
    scene::Scene scene = boxScene();
    for (int i = 0; i < 40; ++i) {
        addBox(scene, glm::dvec3(i - 20.0, 0.3 * i, -60.0 - i), glm::mat3(30.0f));
    }
    const scene::Camera camera = [] {
        scene::Camera made = scenes::makeRotation(1, 1).path.at(0);
        made.position = glm::dvec3(0.0);
        made.nearView = 1.0;
        made.farView = 200.0;
        return made;
    }();
    const render::GpuScene gpuScene(device(), scene);
    render::RenderOptions options = tinyOptions(
        depth::Technique{depth::Mapping::standard, depth::parseSplit("count:40"), depth::DepthFormat::d32f});
    const render::Frame wanted = draw(scene, gpuScene, camera, options);
    ASSERT_GT(wanted.stats.draws, 2 * scene.instances.size());
    options.submission = Submission::gpuDriven;
    render::Renderer onDevice(device(), scene, gpuScene, options);
    EXPECT_EQ(hashOf(onDevice.render(camera)), hashOf(wanted));
    onDevice.submit(camera);
    onDevice.finish();
    EXPECT_EQ(onDevice.draw(camera).draws, wanted.stats.draws);
}

TEST_F(SubmissionTest, BatchingChangesNoBit) {
    const scene::SceneSetup setup = patchwork(600);
    const render::GpuScene gpuScene(device(), setup.scene);
    for (const depth::Technique& technique : techniquesToSubmit()) {
        std::string first;
        for (const Submission submission : submissions()) {
            for (const Batching batching : render::kBatchings) {
                render::RenderOptions options = tinyOptions(technique);
                options.submission = submission;
                options.batching = batching;
                options.threads = 3;
                const std::string hash = hashOf(draw(setup.scene, gpuScene, setup.path.at(90), options));
                first = first.empty() ? hash : first;
                EXPECT_EQ(hash, first)
                    << nameOf(technique) << " " << nameOf(submission) << " " << nameOf(batching);
            }
        }
    }
}

/// The declared winner of equal depths, which the truth has too. Kinds of draws alternate, so that grouping them would show.
TEST_F(SubmissionTest, OfEqualSurfacesTheLastInTheScenesOrderShowsHoweverDrawn) {
    scene::Scene scene = boxScene();
    scene.meshes.push_back(scene.meshes[0]);
    const glm::mat3 turned(0.8f, 0.0f, -0.6f, 0.0f, 1.0f, 0.0f, 0.6f, 0.0f, 0.8f);
    for (const std::uint32_t object : {7u, 9u, 2u, 4u}) {
        const auto mesh = static_cast<std::uint32_t>(scene.instances.size() % 2);
        scene::addInstance(scene, mesh, 0, object, {0.0, 0.0, -6.0}, turned);
    }
    const scene::Camera camera{.fovY = 0.5, .nearView = 1.0, .farView = 100.0};
    const auto size = tinyOptions({});
    const measure::TruthImage truth = truthOf(scene, camera, size.width, size.height);
    ASSERT_EQ(truth.at(size.width / 2, size.height / 2).id, 5u);
    const render::GpuScene gpuScene(device(), scene);
    const auto expectRight = [&](const render::RenderOptions& options) {
        const render::Frame frame = render::Renderer(device(), scene, gpuScene, options).render(camera);
        EXPECT_EQ(measure::countWrong(frame.ids(), truth).wrong, 0u)
            << nameOf(options.technique) << " " << nameOf(options.targets) << " "
            << nameOf(options.submission) << " " << nameOf(options.batching) << " "
            << nameOf(options.surface);
    };
    for (const depth::NamedTechnique& preset : depth::presets()) {
        for (const Submission submission : submissions()) {
            for (const Batching batching : render::kBatchings) {
                render::RenderOptions options = tinyOptions(preset.technique);
                options.submission = submission;
                options.batching = batching;
                options.threads = 3;
                expectRight(options);
            }
        }
        for (const TargetsKind targets : render::kTargetsKinds) {
            render::RenderOptions options = tinyOptions(preset.technique);
            options.targets = targets;
            expectRight(options);
        }
        for (const render::SurfacePath surface :
             {render::SurfacePath::visibility, render::SurfacePath::lit}) {
            render::RenderOptions options = tinyOptions(preset.technique);
            options.surface = surface;
            expectRight(options);
        }
        render::RenderOptions options = tinyOptions(preset.technique);
        options.occlusionCulling = true;
        expectRight(options);
    }
}

/// Frames overlap on the device and in its buffers, and the last is still the one it would be alone.
TEST_F(SubmissionTest, FramesInFlightLeaveTheNextFrameAsItIs) {
    const scene::SceneSetup setup = scenes::makeRotation(3, 4000);
    const render::GpuScene gpuScene(device(), setup.scene);
    for (const Submission submission : submissions()) {
        render::RenderOptions options = tinyOptions(depth::parseTechnique("cdr"));
        options.submission = submission;
        options.targets = TargetsKind::layers;
        options.framesInFlight = 3;
        render::Renderer renderer(device(), setup.scene, gpuScene, options);
        for (std::uint32_t frame = 0; frame < 12; ++frame) {
            renderer.submit(setup.path.at(30 * frame));
        }
        options.framesInFlight = 1;
        EXPECT_EQ(hashOf(renderer.render(setup.path.at(77))),
                  hashOf(draw(setup.scene, gpuScene, setup.path.at(77), options)))
            << nameOf(submission);
    }
}

TEST_F(SubmissionTest, AnEmptySceneIsDrawnHoweverSubmitted) {
    const scene::Scene scene = boxScene();
    const scene::Camera camera = scenes::makeRotation(1, 1).path.at(0);
    for (const depth::Technique& technique : techniquesToSubmit()) {
        for (const Submission submission : submissions()) {
            for (const TargetsKind targets : render::kTargetsKinds) {
                render::RenderOptions options = tinyOptions(technique);
                options.submission = submission;
                options.targets = targets;
                const render::Frame frame = draw(scene, camera, options);
                EXPECT_EQ(frame.stats.draws, 0u);
                const std::vector<std::uint32_t>& ids = frame.ids().pixels;
                EXPECT_EQ(std::count(ids.begin(), ids.end(), 0u), std::ptrdiff_t(ids.size()))
                    << nameOf(technique) << " " << nameOf(submission) << " " << nameOf(targets);
            }
        }
    }
}

TEST_F(SubmissionTest, FramesInFlightOutOfRangeAreRefused) {
    const scene::Scene scene = boxScene();
    for (const std::size_t frames : {std::size_t{0}, render::kMaxFramesInFlight + 1}) {
        render::RenderOptions options = tinyOptions(depth::parseTechnique("cdr"));
        options.framesInFlight = frames;
        EXPECT_NE(refusalOf(scene, options), "none") << frames;
    }
}

/// Neighbours are drawn with other states, so that each is a group of its own, in each of the most cascades.
TEST_F(SubmissionTest, MoreListsThanTheDeviceHasGroupsForAreRefused) {
    if (!canDrawGpuDriven()) {
        return;
    }
    const std::uint64_t mostGroups =
        vk::PhysicalDevice(device().physical()).getProperties().limits.maxComputeWorkGroupCount[0];
    if (mostGroups > 65'535) {
        leaveOut("a limit that a small scene exceeds");
        return;
    }
    scene::Scene scene = boxScene();
    scene.materials.push_back({.name = "both sides", .doubleSided = true});
    const std::uint32_t instances = 32'768; // two lists in each of 64 cascades, 64 lists in a group
    for (std::uint32_t i = 0; i < instances; ++i) {
        scene::addInstance(scene, 0, i % 2, i, {0.0, 0.0, 10.0}, glm::mat3(1.0f));
    }
    render::RenderOptions options = thumbnailOptions(depth::parseTechnique("standard/count:64"));
    options.submission = Submission::gpuDriven;
    EXPECT_THROW(draw(scene, {}, options), base::RunError);
}

} // namespace

} // namespace cdr::render_test
