#include "failed_edits.h"

#include <cdr/render/views/views_renderer.h>
#include <scenes/sheets.h>

#include <array>
#include <functional>
#include <system_error>

namespace cdr::render_test {

namespace {

scene::Camera cameraAt(double x) {
    scene::Camera camera;
    camera.position = {x, 0.0, 0.0};
    camera.farView = 1000.0;
    return camera;
}

/// One that sees so far that the split below has more cascades than there may be.
scene::Camera refusedCamera() {
    scene::Camera camera = cameraAt(1.0);
    camera.farView = 1e12;
    return camera;
}

/// One whose cascades begin elsewhere.
scene::Camera otherCamera(double x) {
    scene::Camera camera = cameraAt(x);
    camera.nearView = 0.3;
    return camera;
}

/// One whose distance to the scene is larger by `distance`.
scene::Camera cameraBehind(double distance) {
    scene::Camera camera = cameraAt(0.0);
    camera.position.z = distance;
    return camera;
}

/// After an error all is as the last frame that was drawn left it.
/// Expects that an action throws where its first call of this name runs out of memory.
void expectFailure(const char* call, const std::function<void()>& action) {
    const FailingCall failing(call);
    EXPECT_THROW(action(), std::exception);
    EXPECT_TRUE(FailingCall::hasFailed());
}

class FailedFrameTest : public RenderTest {
  protected:
    void SetUp() override {
        RenderTest::SetUp();
        addBox(m_scene, {0.0, 0.0, -5.0});
        m_onDevice.emplace(device(), m_scene);
    }

    static render::RenderOptions options() {
        render::RenderOptions options = thumbnailOptions(depth::parseTechnique("anchored/ratio:1.5"));
        options.motion = true;
        return options;
    }

    void addPanes() {
        m_scene.meshes.push_back(scenes::makeSquare(100.0f));
        m_scene.materials.push_back(
            {.name = "glass", .baseColorFactor = glm::vec4(0.5f), .alphaMode = scene::AlphaMode::blend});
        for (std::uint32_t pane = 0; pane < 3; ++pane) {
            scene::addInstance(m_scene, 1, 1, 1 + pane, {0.0, 0.0, -2.0 - 0.5 * pane}, glm::mat3(1.0f));
        }
    }

    static void expectSame(const render::Surfaces& now, const render::Surfaces& before) {
        EXPECT_EQ(now.color.image, before.color.image);
        EXPECT_EQ(now.color.layout, before.color.layout);
        EXPECT_EQ(now.gbuffer.layout, before.gbuffer.layout);
        EXPECT_EQ(now.motion.layout, before.motion.layout);
        EXPECT_EQ(now.anchorsView, before.anchorsView);
    }

    scene::Scene m_scene = boxScene();
    std::optional<render::GpuScene> m_onDevice;
};

TEST_F(FailedFrameTest, WhatIsRefusedLeavesTheLastFrame) {
    for (const std::size_t inFlight : {std::size_t{1}, std::size_t{2}}) {
        render::RenderOptions chosen = options();
        chosen.framesInFlight = inFlight;
        render::Renderer renderer(device(), m_scene, *m_onDevice, chosen);
        render::Renderer other(device(), m_scene, *m_onDevice, chosen);
        const render::Surfaces none = renderer.surfaces();
        EXPECT_THROW(renderer.render(refusedCamera()), base::InputError);
        expectSame(renderer.surfaces(), none);
        const render::FrameStats drawn = renderer.draw(cameraAt(0.0));
        EXPECT_GT(drawn.draws, 0u);
        other.draw(cameraAt(0.0));
        const render::Surfaces last = renderer.surfaces();
        EXPECT_FALSE(last.anchorsView.empty());
        EXPECT_THROW(renderer.render(refusedCamera()), base::InputError);
        expectSame(renderer.surfaces(), last);
        EXPECT_EQ(renderer.lastStats().draws, drawn.draws);
        EXPECT_EQ(renderer.render(cameraAt(0.1)).motion, other.render(cameraAt(0.1)).motion);
    }
}

/// Its first submission fails. The next frame is drawn right, and nothing in it moved.
TEST_F(FailedFrameTest, WhatIsNotSubmittedLeavesTheLastFrame) {
    render::Renderer renderer(device(), m_scene, *m_onDevice, options());
    renderer.draw(cameraAt(0.0));
    const render::Surfaces last = renderer.surfaces();
    expectFailure("vkQueueSubmit2", [&] { renderer.draw(otherCamera(0.5)); });
    expectSame(renderer.surfaces(), last);
    const render::Frame first = draw(m_scene, cameraAt(1.0), options());
    const render::Frame next = renderer.render(cameraAt(1.0));
    EXPECT_EQ(hashOf(next), hashOf(first));
    EXPECT_EQ(next.motion, first.motion);
}

/// Whose time cannot be read. It is not waited for a second time, which would never end.
TEST_F(FailedFrameTest, WhatIsNotTimedIsWaitedForOnce) {
    render::RenderOptions chosen = options();
    chosen.deviceClock = true;
    render::Renderer renderer(device(), m_scene, *m_onDevice, chosen);
    if (!renderer.draw(cameraAt(0.0)).times.deviceMs) {
        GTEST_SKIP() << "the device has no clock";
    }
    expectFailure("vkGetQueryPoolResults", [&] { renderer.draw(cameraAt(0.5)); });
    EXPECT_EQ(hashOf(renderer.render(cameraAt(1.0))), hashOf(draw(m_scene, cameraAt(1.0), options())));
}

/// A little motion keeps the cascades of the last frame that was drawn, not of the one that failed.
TEST_F(FailedFrameTest, AFittedSplitKeepsToTheLastFrame) {
    render::Renderer renderer(device(), m_scene, *m_onDevice,
                              thumbnailOptions(depth::parseTechnique("anchored")));
    const render::Frame first = renderer.render(cameraBehind(0.0));
    ASSERT_NE(renderer.render(cameraBehind(30.0)).anchorsView, first.anchorsView);
    ASSERT_EQ(renderer.render(cameraBehind(0.0)).anchorsView, first.anchorsView);
    expectFailure("vkQueueSubmit2", [&] { renderer.draw(cameraBehind(30.0)); });
    EXPECT_EQ(renderer.render(cameraBehind(0.001)).anchorsView, first.anchorsView);
}

/// Three panes over all of the picture find no room in its lists, nor does the device have more.
TEST_F(FailedFrameTest, WhatIsNotSettledLeavesNoMotion) {
    addPanes();
    const render::GpuScene onDevice(device(), m_scene);
    render::RenderOptions chosen = withSorting(thumbnailOptions(depth::parseTechnique("reversed")));
    chosen.motion = true;
    const scene::Camera next = cameraAt(0.3);
    const render::Frame wanted = draw(m_scene, onDevice, next, chosen);
    render::Renderer renderer(device(), m_scene, onDevice, chosen);
    renderer.draw(cameraBehind(500.0));
    expectFailure("vkCreateBuffer", [&] { renderer.draw(cameraAt(0.0)); });
    EXPECT_EQ(renderer.lastStats().translucency.fragments, 3u * 96 * 54); // it was submitted
    const render::Frame frame = renderer.render(next);
    EXPECT_EQ(frame.motion, wanted.motion);
    EXPECT_EQ(hashOf(frame), hashOf(wanted));

    render::ViewsRenderer views(device(), m_scene, onDevice, chosen, 2);
    views.draw(std::array{cameraBehind(500.0), cameraBehind(500.0)});
    expectFailure("vkCreateBuffer", [&] { views.draw(std::array{cameraAt(0.0), cameraAt(0.0)}); });
    for (const render::Frame& each : views.render(std::array{next, next})) {
        EXPECT_EQ(each.motion, wanted.motion);
        EXPECT_EQ(hashOf(each), hashOf(wanted));
    }
}

TEST_F(FailedFrameTest, RefusedViewsLeaveTheLastOnes) {
    for (const bool deviceClock : {false, true}) { // views are drawn together, and in turn
        render::RenderOptions chosen = options();
        chosen.deviceClock = deviceClock;
        render::ViewsRenderer renderer(device(), m_scene, *m_onDevice, chosen, 2);
        render::ViewsRenderer other(device(), m_scene, *m_onDevice, chosen, 2);
        const std::array first{cameraAt(0.0), cameraAt(0.2)};
        const std::array refused{refusedCamera(), refusedCamera()};
        const std::array next{cameraAt(0.1), cameraAt(0.3)};
        renderer.draw(first);
        other.draw(first);
        const std::array last{renderer.surfaces(0), renderer.surfaces(1)};
        EXPECT_THROW(renderer.draw(refused), base::InputError);
        const std::vector<render::Frame> wanted = other.render(next);
        expectSame(renderer.surfaces(0), last[0]);
        expectSame(renderer.surfaces(1), last[1]);
        const std::vector<render::Frame> frames = renderer.render(next);
        EXPECT_EQ(frames[0].motion, wanted[0].motion);
        EXPECT_EQ(frames[1].motion, wanted[1].motion);
    }
}

/// Where the draws of a view were not submitted, none of its frame was drawn.
TEST_F(FailedFrameTest, ViewsThatAreNotSubmittedLeaveTheLastOnes) {
    render::ViewsRenderer renderer(device(), m_scene, *m_onDevice, options(), 2);
    const std::array first{cameraAt(0.0), cameraAt(0.2)};
    const std::array next{otherCamera(0.1), otherCamera(0.3)};
    renderer.draw(first);
    const std::array last{renderer.surfaces(0), renderer.surfaces(1)};
    expectFailure("vkQueueSubmit2", [&] { renderer.draw(next); });
    expectSame(renderer.surfaces(0), last[0]);
    expectSame(renderer.surfaces(1), last[1]);
    const std::vector<render::Frame> frames = renderer.render(next);
    for (std::size_t view = 0; view < 2; ++view) {
        EXPECT_EQ(hashOf(frames[view]), hashOf(draw(m_scene, next[view], options())));
    }
}

TEST_F(FailedFrameTest, ASizeThatIsNotMadeLeavesTheLastFrame) {
    render::Renderer renderer(device(), m_scene, *m_onDevice, options());
    renderer.draw(cameraAt(0.0));
    const render::Surfaces last = renderer.surfaces();
    {
        const FailingCall failing("vkCreateFence");
        EXPECT_THROW(renderer.resize(32, 32), std::system_error);
        ASSERT_TRUE(FailingCall::hasFailed());
    }
    EXPECT_EQ(renderer.options(), options());
    expectSame(renderer.surfaces(), last);
    EXPECT_EQ(hashOf(renderer.render(cameraAt(1.0))), hashOf(draw(m_scene, cameraAt(1.0), options())));
}

/// A size that some views have and others have not would be none that can be drawn.
TEST_F(FailedFrameTest, ASizeThatIsNotMadeOfAllViewsLeavesTheLastFrames) {
    render::ViewsRenderer renderer(device(), m_scene, *m_onDevice, options(), 2);
    const std::array cameras{cameraAt(0.0), cameraAt(0.2)};
    renderer.draw(cameras);
    const std::array last{renderer.surfaces(0), renderer.surfaces(1)};
    std::size_t failures = 0;
    for (bool hasFailed = true; hasFailed; failures += hasFailed ? 1 : 0) {
        hasFailed = failsAt("vkCreateFence", failures, [&] { renderer.resize(32, 32); });
        if (hasFailed) {
            EXPECT_EQ(renderer.options(), options());
            expectSame(renderer.surfaces(0), last[0]);
            expectSame(renderer.surfaces(1), last[1]);
        }
    }
    EXPECT_GE(failures, 2u); // of each view
    EXPECT_EQ(renderer.options().width, 32u);
    EXPECT_EQ(renderer.render(cameras)[1].width(), 32u);
}

/// Two boxes that are one object. @return the right one
scene::InstanceHandle addParts(scene::World& world) {
    scene::InstanceHandle last{};
    for (const double x : {-1.5, 1.5}) {
        last = world.addInstance({.mesh = world.mesh(0),
                                  .material = world.material(0),
                                  .object = 7,
                                  .transform = {{x, 0.0, -8.0}}});
    }
    return last;
}

/// A fitted split keeps to the last frame that was drawn.
TEST_F(FailedFrameTest, AFrameThatIsRefusedDoesNotMoveFittedCascades) {
    const auto drawnAfter = [&](bool isRefusedBetween, std::size_t views) {
        scene::World world(boxScene());
        const scene::InstanceHandle part = addParts(world);
        render::GpuScene onDevice(device(), world);
        render::RenderOptions chosen = thumbnailOptions(depth::parseTechnique("anchored/fitted:0.001"));
        chosen.motion = true;
        render::ViewsRenderer renderer(device(), onDevice, chosen, views);
        const auto camerasAt = [&](double z) {
            scene::Camera camera = cameraAt(0.0);
            camera.position.z = z;
            return std::vector<scene::Camera>(views, camera);
        };
        renderer.render(camerasAt(0.0));
        if (isRefusedBetween) {
            world.setTransform(part, {.position = {1.6, 0.0, -8.0}}); // parts of one object move apart
            EXPECT_THROW(renderer.render(camerasAt(0.0203)), base::InputError);
            world.setTransform(part, {.position = {1.5, 0.0, -8.0}});
        }
        return renderer.render(camerasAt(0.0101)).front().cascades;
    };
    for (const std::size_t views : {std::size_t{1}, std::size_t{2}}) {
        EXPECT_EQ(drawnAfter(true, views), drawnAfter(false, views)) << views;
    }
}

/// The first view refuses the frame before the second one looks at what moved, which is not refused again.
TEST_F(FailedFrameTest, ViewsRefuseTogetherWhatMovedApart) {
    using render::ViewsRenderer;
    const std::array cameras{cameraAt(0.0), cameraAt(0.2)};
    const std::vector<std::function<void(ViewsRenderer&)>> ways{
        [&](ViewsRenderer& renderer) { renderer.draw(cameras); },
        [&](ViewsRenderer& renderer) { renderer.skip(cameras); }};
    for (const auto& goOn : ways) {
        for (const bool deviceClock : {false, true}) { // views are drawn together, and in turn
            scene::World world(boxScene());
            const scene::InstanceHandle part = addParts(world);
            render::GpuScene onDevice(device(), world);
            render::RenderOptions chosen = options();
            chosen.deviceClock = deviceClock;
            ViewsRenderer renderer(device(), onDevice, chosen, 2);
            goOn(renderer);
            world.setTransform(part, {.position = {1.6, 0.0, -8.0}});
            EXPECT_THROW(goOn(renderer), base::InputError);
            EXPECT_NO_THROW(goOn(renderer));
        }
    }
}

/// However far it came: once the mesh is gone that had no room, or there is room for it, all others are there.
TEST_F(FailedFrameTest, MeshesOutliveAnUploadWithoutMemory) {
    const std::string wanted = hashOf(draw(m_scene, cameraAt(0.0), options()));
    std::size_t failures = 0;
    for (bool hasFailed = true; hasFailed; failures += hasFailed ? 1 : 0) {
        for (const bool goes : {true, false}) {
            scene::World world(m_scene);
            render::GpuScene onDevice(device(), world);
            const scene::MeshHandle mesh = world.addMesh(scene::makeBox(glm::vec3(1.0f)));
            hasFailed = failsAt<base::RunError>("vkCreateBuffer", failures, [&] { onDevice.update(); });
            if (goes) {
                world.removeMesh(mesh);
            }
            render::Renderer renderer(device(), onDevice, options());
            EXPECT_EQ(hashOf(renderer.render(cameraAt(0.0))), wanted) << "buffer " << failures;
        }
    }
    EXPECT_GE(failures, 3u); // vertices, indices, and what takes them there
}

/// A box that is no longer faceted takes another pipeline, whether its vertices were uploaded at once or after an error.
TEST_F(FailedFrameTest, MeshesTakeThePipelineOfTheirVertices) {
    std::vector<scene::Vertex> round = m_scene.meshes[0].vertices;
    for (scene::Vertex& vertex : round) {
        vertex.normal = glm::normalize(vertex.position);
    }
    const scene::World begun(m_scene);
    const auto edit = [&](scene::World& world) { world.setVertices(world.mesh(0), round); };
    // Of the vertices before, and of those that are uploaded.
    EXPECT_GE(expectEditOutlivesFailures(device(), "vkCreateBuffer", begun, edit), 2u);
    EXPECT_GE(expectEditOutlivesFailures(device(), "vkQueueSubmit2", begun, edit), 3u);
}

/// More lights than there is room for, in a frame that runs out of memory. Without them again all is drawn as before.
TEST_F(FailedFrameTest, LightsThatFindNoRoomLeaveWhatSlotsRead) {
    m_scene.materials.push_back(
        {.name = "glass", .baseColorFactor = {1.0f, 0.0f, 0.0f, 0.5f}, .alphaMode = scene::AlphaMode::blend});
    scene::addInstance(m_scene, 0, 1, 1, {0.5, 0.0, -4.0}, glm::mat3(0.5f));
    render::RenderOptions chosen = options();
    chosen.shadows.method = render::ShadowMethod::anchored;
    const scene::Camera camera = cameraAt(0.0);
    const std::string wanted = hashOf(draw(m_scene, camera, chosen));
    std::size_t failures = 0;
    for (bool hasFailed = true; hasFailed; failures += hasFailed ? 1 : 0) {
        scene::World world(m_scene);
        SoleRenderer renderer(device(), world, chosen);
        renderer.draw(camera);
        std::vector<scene::LightHandle> added;
        for (int i = 0; i < 3; ++i) {
            added.push_back(world.addLight({.position = {-5.0, 10.0, 0.0}}));
        }
        hasFailed = failsAt<base::RunError>("vkCreateBuffer", failures, [&] { renderer.draw(camera); });
        for (const scene::LightHandle light : added) {
            world.removeLight(light);
        }
        EXPECT_EQ(hashOf(renderer.render(camera)), wanted) << "buffer " << failures;
    }
    EXPECT_GE(failures, 3u);
}

/// Descriptors are made for layers that were not drawn before.
TEST_F(FailedFrameTest, LayersOfALensOutliveDescriptorsWithoutMemory) {
    render::RenderOptions chosen = thumbnailOptions(depth::parseTechnique("reversed/at:5,7.5,15,30"));
    chosen.targets = render::TargetsKind::layers;
    chosen.focus = {.distance = 10.0, .aperture = 0.3};
    const std::string wanted = hashOf(draw(m_scene, *m_onDevice, cameraAt(0.0), chosen));
    for (const char* call : {"vkCreateDescriptorPool", "vkAllocateDescriptorSets"}) {
        std::size_t failures = 0;
        for (bool hasFailed = true; hasFailed; failures += hasFailed ? 1 : 0) {
            render::Renderer renderer(device(), m_scene, *m_onDevice, chosen);
            hasFailed = failsAt(call, failures, [&] { renderer.draw(cameraAt(0.0)); });
            EXPECT_EQ(hashOf(renderer.render(cameraAt(0.0))), wanted) << call << " " << failures;
        }
        EXPECT_GE(failures, 3u) << call; // for merging, composing and lighting a layer
    }
}

} // namespace

} // namespace cdr::render_test
