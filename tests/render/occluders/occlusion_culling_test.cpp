#include "../../support/all_cases.h"
#include "../../support/refusal.h"
#include "../failing_calls.h"
#include "../fixture.h"

#include <cdr/gpu/vulkan_hpp.h>
#include <scenes/city.h>
#include <scenes/open_scene.h>

#include <string>
#include <vector>

namespace cdr::render_test {

namespace {

using render::RenderOptions;

/// Many frames of a town of 2,500 boxes, so that what was hidden comes out from behind corners.
constexpr std::uint32_t kBlocks = 2;
constexpr std::uint32_t kStep = 24;    // frames
constexpr std::uint32_t kFarStep = 60; // frames

glm::mat3 basisOf(const glm::vec3& sides) {
    return {glm::vec3(sides.x, 0, 0), glm::vec3(0, sides.y, 0), glm::vec3(0, 0, sides.z)};
}

/// A wall that fills the picture, and a box behind it that 16 bits cannot tell from it.
scene::SceneSetup wallAndBox() {
    scene::SceneSetup setup{.scene = boxScene(), .path = {}};
    const auto add = [&](double distanceView, double side) {
        addBox(setup.scene, {0.0, 0.0, -distanceView}, basisOf({side, side, 1.0}));
    };
    add(1000.0, 2000.0);
    add(1020.0, 10.0); // drawn later, so in 16 bits it shows
    setup.path = scene::stillPath({.fovY = 1.0, .nearView = 0.1, .farView = 1e5});
    setup.path.frames = 3;
    return setup;
}

RenderOptions fewPixels(const std::string& technique) {
    return quarterOf(smallOptions(depth::parseTechnique(technique)));
}

class OcclusionCullingTest : public RenderTest {
  protected:
    static RenderOptions culling(RenderOptions options) {
        options.occlusionCulling = true;
        return options;
    }

    /// Draws frames with and without, compares them to the bit, and returns how many instances were hidden.
    std::size_t expectSamePictures(const scene::SceneSetup& setup, const RenderOptions& options,
                                   std::uint32_t step) {
        return expectSamePictures(setup, render::GpuScene(device(), setup.scene), options, step);
    }
    std::size_t expectSamePictures(const scene::SceneSetup& setup, const render::GpuScene& gpuScene,
                                   const RenderOptions& options, std::uint32_t step) {
        render::Renderer whole(device(), setup.scene, gpuScene, options);
        render::Renderer culled(device(), setup.scene, gpuScene, culling(options));
        std::size_t hidden = 0;
        for (std::uint32_t frame = 0; frame < setup.path.frames; frame += step) {
            const scene::Camera camera = setup.path.at(frame);
            const render::Frame wanted = whole.render(camera);
            const render::Frame made = culled.render(camera);
            EXPECT_EQ(hashOf(made), hashOf(wanted)) << nameOf(options.technique) << " frame " << frame;
            EXPECT_EQ(wanted.stats.occluders.hidden, 0u);
            EXPECT_LE(made.stats.draws, wanted.stats.draws);
            hidden += made.stats.occluders.hidden;
        }
        return hidden;
    }

    scene::SceneSetup m_city = scenes::makeCity(5, kBlocks);
};

TEST_F(OcclusionCullingTest, LeavesOutMostOfATownAndNoneOfThePicture) {
    for (const char* name : {"standard", "cdr", "log", "logcdr", "reversed", "anchored"}) {
        const std::size_t hidden = expectSamePictures(m_city, fewPixels(name), kStep);
        EXPECT_GT(hidden, 2'500u) << name; // of 10 frames
    }
}

TEST_F(OcclusionCullingTest, HoldsForEveryFormatThatIsCoarse) {
    for (const char* name : {"standard", "log"}) {
        RenderOptions options = fewPixels(name);
        options.technique.format = depth::DepthFormat::d16;
        EXPECT_GT(expectSamePictures(m_city, options, kStep), 0u) << name;
        expectSamePictures(scenes::openScene("mixed", 1).setup, options, 1);
    }
}

TEST_F(OcclusionCullingTest, KeepsWhatACoarseBufferShowsThroughAWall) {
    const scene::SceneSetup setup = wallAndBox();
    RenderOptions options = smallOptions(depth::parseTechnique("standard"));
    options.technique.format = depth::DepthFormat::d16;
    EXPECT_EQ(draw(setup.scene, setup.path.at(0), options).id(240, 135), 2u);
    EXPECT_EQ(expectSamePictures(setup, options, 1), 0u);
    options.technique = depth::parseTechnique("anchored");
    EXPECT_EQ(draw(setup.scene, setup.path.at(0), options).id(240, 135), 1u);
    EXPECT_EQ(expectSamePictures(setup, options, 1), 3u);
}

TEST_F(OcclusionCullingTest, HoldsForAllTargetsThreadsSubmissionsAndSurfaces) {
    RenderOptions options = fewPixels("anchored");
    options.technique.split = depth::SplitCount{3};
    for (const char* targets : {"accumulate", "pool", "layers", "one-pass"}) {
        options.targets = render::parseTargets(targets);
        EXPECT_GT(expectSamePictures(m_city, options, kFarStep), 1'500u) << targets;
    }
    options.targets = render::TargetsKind::single;
    options.threads = 4;
    options.submission = render::Submission::primaries;
    EXPECT_GT(expectSamePictures(m_city, options, kFarStep), 1'500u);
    options.submission = render::Submission::secondaries;
    for (const render::Batching batching : {render::Batching::perObject, render::Batching::pushConstants}) {
        options.batching = batching;
        EXPECT_GT(expectSamePictures(m_city, options, kFarStep), 1'500u) << nameOf(batching);
    }
}

TEST_F(OcclusionCullingTest, HoldsForAVisibilityBuffer) {
    const std::uint64_t texels = m_city.scene.instances.size() * 6 * 2;
    if (texels > vk::PhysicalDevice(device().physical()).getProperties().limits.maxTexelBufferElements) {
        GTEST_SKIP() << "the device reads too few facets";
    }
    RenderOptions options = fewPixels("anchored");
    options.surface = render::SurfacePath::visibility;
    EXPECT_GT(expectSamePictures(m_city, options, kStep), 2'500u);
}

TEST_F(OcclusionCullingTest, HoldsGpuDriven) {
    if (!canDrawGpuDriven()) {
        GTEST_SKIP() << "the device cannot draw gpu-driven";
    }
    const std::vector<std::string> techniques{"standard", "cdr", "log", "anchored"};
    const auto expectAlike = [&](const scene::SceneSetup& setup, const std::vector<std::string>& names,
                                 std::uint32_t step) {
        const render::GpuScene gpuScene(device(), setup.scene);
        for (const std::string& name : names) {
            RenderOptions options = fewPixels(name);
            options.submission = render::Submission::gpuDriven;
            const std::size_t hidden = expectSamePictures(setup, gpuScene, options, step);
            EXPECT_TRUE(&setup != &m_city || hidden > 2'500u) << name << " " << hidden;
        }
    };
    expectAlike(m_city, techniques, kStep);
    // One technique each. CDR_ALL_CASES takes all.
    std::size_t turn = 0;
    for (const char* name : {"rotation", "orbit", "mixed"}) {
        expectAlike(scenes::openScene(name, 2013).setup,
                    test::takesAllCases() ? techniques : std::vector{techniques[++turn]}, 90);
    }
    RenderOptions coarse = fewPixels("standard");
    coarse.technique.format = depth::DepthFormat::d16;
    coarse.submission = render::Submission::gpuDriven;
    EXPECT_EQ(expectSamePictures(wallAndBox(), coarse, 1), 0u);
    coarse.technique = depth::parseTechnique("anchored");
    EXPECT_EQ(expectSamePictures(wallAndBox(), coarse, 1), 3u);
}

/// The slab reaches ahead from a centre that lies behind the camera. The layer offset draws the box above it.
TEST_F(OcclusionCullingTest, NothingIsHiddenWhereAFaceHasALayer) {
    scene::SceneSetup setup{.scene = boxScene(), .path = scene::stillPath({.fovY = 1.0, .farView = 1e3})};
    setup.path.frames = 3;
    setup.scene.materials.push_back({.name = "marking", .layer = 17.0f});
    addBox(setup.scene, {0.0, -3.0, 10.0}, basisOf({400.0, 1.0, 400.0}));
    scene::addInstance(setup.scene, 0, 1, 1, {0.0, -4.6, -20.0}, glm::mat3(1.0f));
    for (const render::Submission submission : submissions()) {
        RenderOptions options = smallOptions(depth::parseTechnique("anchored"));
        options.submission = submission;
        EXPECT_EQ(expectSamePictures(setup, options, 1), 0u) << nameOf(submission);
    }
}

TEST_F(OcclusionCullingTest, HoldsWhereVerticesAreSnapped) {
    RenderOptions options = fewPixels("anchored");
    options.snapBits = 4;
    EXPECT_GT(expectSamePictures(m_city, options, kStep), 2'500u);
}

TEST_F(OcclusionCullingTest, HoldsWhereNothingHidesMuch) {
    for (const char* name : {"rotation", "afc", "orbit"}) {
        const scene::SceneSetup setup = scenes::openScene(name, 2013).setup;
        expectSamePictures(setup, smallOptions(depth::parseTechnique("anchored")), 60);
    }
}

TEST_F(OcclusionCullingTest, HoldsAfterAJumpAndWhenForgotten) {
    const RenderOptions options = smallOptions(depth::parseTechnique("reversed"));
    const render::GpuScene gpuScene(device(), m_city.scene);
    render::Renderer whole(device(), m_city.scene, gpuScene, options);
    render::Renderer culled(device(), m_city.scene, gpuScene, culling(options));
    std::size_t hidden = 0;
    const auto expectSame = [&](const scene::Camera& camera) {
        const render::Frame made = culled.render(camera);
        EXPECT_EQ(hashOf(made), hashOf(whole.render(camera)));
        hidden += made.stats.occluders.hidden;
    };
    for (const std::uint32_t frame : {0u, 200u, 10u, 120u}) {
        culled.forgetFrames();
        expectSame(m_city.path.at(frame));
        culled.resize(480 - frame, 270);
        whole.resize(480 - frame, 270);
        expectSame(m_city.path.at(frame));
        expectSame(m_city.path.at(frame + 1));
    }
    EXPECT_GT(hidden, 0u);
}

TEST_F(OcclusionCullingTest, ShowsWhatAWallUncoversInTheSameFrame) {
    scene::World world;
    const scene::MeshHandle mesh = world.addMesh(scene::makeBox(glm::vec3(0.5f)));
    const scene::MaterialHandle material = world.addMaterial({.name = "white"});
    const auto add = [&](const glm::dvec3& position, const glm::vec3& size) {
        return world.addInstance({.mesh = mesh,
                                  .material = material,
                                  .transform = {.position = position, .basis = basisOf(size)}});
    };
    const glm::vec3 wallSides(40.0f, 40.0f, 1.0f);
    const scene::InstanceHandle wall = add({0.0, 0.0, -10.0}, wallSides);
    for (int i = 0; i < 100; ++i) {
        const glm::ivec2 place(i % 10, i / 10);
        add({glm::dvec2(place) - 4.5, -30.0}, glm::vec3(0.4f));
    }
    render::GpuScene live(device(), world);
    const scene::Camera camera{.fovY = 1.0, .nearView = 0.1, .farView = 100.0};
    for (const render::Submission submission : submissions()) {
        RenderOptions options = culling(smallOptions(depth::parseTechnique("anchored")));
        options.submission = submission;
        render::Renderer renderer(device(), live, options);
        renderer.render(camera);
        EXPECT_EQ(renderer.render(camera).stats.occluders.hidden, 100u) << nameOf(submission);
        world.setTransform(wall, {.position = {0.0, 100.0, -10.0}, .basis = glm::mat3(1.0f)});
        const render::Frame open = renderer.render(camera);
        EXPECT_EQ(open.stats.occluders.hidden, 0u) << nameOf(submission);
        EXPECT_GT(open.stats.visible, 99u) << nameOf(submission);
        world.setTransform(wall, {.position = {0.0, 0.0, -10.0}, .basis = basisOf(wallSides)});
        renderer.render(camera);
        EXPECT_EQ(renderer.render(camera).stats.occluders.hidden, 100u) << nameOf(submission);
    }
}

TEST_F(OcclusionCullingTest, FramesInFlightAreTheSame) {
    RenderOptions options = fewPixels("anchored");
    options.framesInFlight = 3;
    for (const render::Submission submission : submissions()) {
        options.submission = submission;
        const render::GpuScene gpuScene(device(), m_city.scene);
        render::Renderer whole(device(), m_city.scene, gpuScene, options);
        render::Renderer culled(device(), m_city.scene, gpuScene, culling(options));
        for (std::uint32_t frame = 0; frame < 5; ++frame) {
            culled.submit(m_city.path.at(frame));
            whole.submit(m_city.path.at(frame)); // fitted cascades follow the frames before
        }
        const scene::Camera last = m_city.path.at(90);
        const render::Frame made = culled.render(last);
        EXPECT_EQ(hashOf(made), hashOf(whole.render(last))) << nameOf(submission);
        EXPECT_GT(made.stats.occluders.hidden, 0u) << nameOf(submission);
    }
}

TEST_F(OcclusionCullingTest, IsRefusedWhereItIsNotDone) {
    RenderOptions options = smallOptions(depth::parseTechnique("anchored"));
    options.focus = {.distance = 5.0, .aperture = 0.1};
    options.targets = render::TargetsKind::layers;
    EXPECT_NE(refusalOf(boxScene(), culling(options)).find("focus"), std::string::npos);
}

/// The device reads the occluders' depth from one buffer.
TEST_F(OcclusionCullingTest, APictureWhoseDepthTheDeviceCannotReadIsRefused) {
    if (!canDrawGpuDriven()) {
        return;
    }
    const std::uint64_t side = device().info().maxImageSide;
    const std::uint64_t rows = device().info().maxStorageBufferBytes / sizeof(float) / side + 1;
    if (rows > side) {
        leaveOut("a limit below its largest picture");
        return;
    }
    render::RenderOptions options = culling(thumbnailOptions(depth::parseTechnique("anchored")));
    options.submission = render::Submission::gpuDriven;
    options.width = static_cast<std::uint32_t>(side);
    options.height = static_cast<std::uint32_t>(rows);
    const std::string message = test::runErrorOf([&] { draw(boxScene(), {}, options); });
    EXPECT_NE(message.find("byte buffer"), std::string::npos) << message;
}

/// Its passes read the sets of binning and of occlusion together.
TEST_F(OcclusionCullingTest, ADeviceWithTooFewStorageBuffersIsRefused) {
    if (!canDrawGpuDriven()) {
        return;
    }
    RenderOptions options = thumbnailOptions(depth::parseTechnique("anchored"));
    options.submission = render::Submission::gpuDriven;
    scene::Scene scene = boxScene();
    addBox(scene, {0.0, 0.0, -5.0});
    const StandIn few = fewStorageBuffers(17);
    EXPECT_NO_THROW(draw(scene, {}, options));
    const std::string message = test::runErrorOf([&] { draw(scene, {}, culling(options)); });
    EXPECT_NE(message.find("needs 18 storage buffers"), std::string::npos) << message;
}

} // namespace

} // namespace cdr::render_test
