#include "../failing_calls.h"
#include "../fixture.h"

#include <cdr/render/draw_source.h>
#include <cdr/render/submit/binning_pass.h>

namespace cdr::render_test {

namespace {

using BinningChangesTest = RenderTest;

/// What gpu-driven draws copy to the device after an edit.
class Follower {
  public:
    Follower(const gpu::Device& device, const scene::World& world)
        : m_onDevice(device, world),
          m_binning(device, {.scene = world.scene(), .uploaded = m_onDevice.uploaded()},
                    visibility::DetailMode::none, {}),
          m_copies(m_binning.makeCopies()) {}

    std::size_t bytes() {
        m_onDevice.update();
        m_binning.follow(m_copies);
        m_binning.noteLaunched();
        std::size_t bytes = m_copies.scattered.count * sizeof(shaders::InstanceChange);
        for (const std::vector<vk::BufferCopy>& regions : m_copies.regions) {
            for (const vk::BufferCopy& region : regions) {
                bytes += region.size;
            }
        }
        return bytes;
    }

  private:
    render::GpuScene m_onDevice;
    render::BinningPass m_binning;
    render::BinningPass::Copies m_copies;
};

/// The time that an edit takes is by what it changes, not by what there is.
TEST_F(BinningChangesTest, EditsCopyWhatTheyChange) {
    if (!canDrawGpuDriven()) {
        GTEST_SKIP() << "the device does not draw gpu-driven";
    }
    constexpr std::uint32_t kBoxes = 10'000;
    constexpr std::size_t kFew = 1000; // bytes
    scene::Scene scene = boxScene();
    for (std::uint32_t i = 0; i < kBoxes; ++i) {
        addBox(scene, {0.0, 0.0, -5.0 - i});
    }
    scene::World world(scene);
    Follower follower(device(), world);
    const std::size_t all = follower.bytes();
    EXPECT_GT(all, kBoxes * sizeof(shaders::InstanceSphere));
    EXPECT_EQ(follower.bytes(), 0u);

    world.setTransform(world.instance(7), {.position = {0.0, 1.0, -5.0}});
    const std::size_t moved = follower.bytes();
    EXPECT_GE(moved, sizeof(shaders::InstanceSphere) + sizeof(shaders::InstanceLook));
    EXPECT_LE(moved, kFew);

    world.setMaterial(world.material(0), {.name = "red", .baseColorFactor = {1.0f, 0.0f, 0.0f, 1.0f}});
    const std::size_t painted = follower.bytes();
    EXPECT_GE(painted, sizeof(shaders::MaterialRecord));
    EXPECT_LE(painted, kFew);

    const auto add = [&](scene::MeshHandle mesh) {
        return world.addInstance({.mesh = mesh, .material = world.material(0), .object = 1});
    };
    add(world.mesh(0));
    EXPECT_GE(follower.bytes(), all); // into larger buffers
    for (int i = 0; i < 3; ++i) {
        const scene::InstanceHandle added = add(world.mesh(0));
        EXPECT_LE(follower.bytes(), kFew) << "of a kind that is there";
        world.removeInstance(added);
        EXPECT_LE(follower.bytes(), kFew) << "gone";
        add(world.mesh(0));
        EXPECT_LE(follower.bytes(), kFew) << "in its place";
    }
    add(world.addMesh(scene::makeBox(glm::vec3(0.1f))));
    EXPECT_LE(follower.bytes(), 2 * kFew) << "of another mesh";

    // An instance that becomes of another kind parts the run that it is in.
    world.setMaterial(world.instance(50), world.addMaterial({.name = "both sides", .doubleSided = true}));
    EXPECT_GE(follower.bytes(), all);
}

/// What comes behind the others, of each kind in turn, and what changes in a material while its kind of draws stays.
TEST_F(BinningChangesTest, WhatIsAddedOrPaintedIsDrawn) {
    if (!canDrawGpuDriven()) {
        GTEST_SKIP() << "the device does not draw gpu-driven";
    }
    scene::Scene scene = boxScene();
    scene.meshes.push_back(scene::makeBox(glm::vec3(0.3f)));
    scene.meshes[1].boxHalfSides.reset();
    scene.meshes[1].levels.push_back(
        {.indices = {scene.meshes[1].indices.begin(), scene.meshes[1].indices.begin() + 18}, .error = 0.2f});
    scene.materials.push_back({.name = "both sides", .doubleSided = true});
    addBox(scene, {0.0, 0.0, -5.0});
    scene::World world(scene);
    render::RenderOptions options = smallOptions(depth::parseTechnique("cdr"));
    options.submission = render::Submission::gpuDriven;
    options.detail = {.mode = visibility::DetailMode::perObject, .pixels = 2.0};
    options.framesInFlight = 2;
    SoleRenderer renderer(device(), world, options);
    const auto expectShown = [&](const char* what, std::uint32_t step) {
        renderer.submit({});
        renderer.forgetFrames();
        EXPECT_EQ(hashOf(renderer.render({})), hashOf(draw(world.scene(), {}, options)))
            << what << " " << step;
    };
    for (std::uint32_t i = 1; i < 24; ++i) {
        world.addInstance({.mesh = world.mesh(i % 4 == 0 ? 1 : 0),
                           .material = world.material(i / 2 % 2),
                           .object = i,
                           .transform = {.position = {0.5 * (i % 6) - 1.2, 0.6 * (i / 6) - 1.0, -6.0 - i}}});
        expectShown("added", i);
    }
    scene::Material material = scene.materials[1];
    for (std::uint32_t step = 0; step < 4; ++step) {
        material.baseColorFactor = glm::vec4(0.1f + 0.2f * static_cast<float>(step), 0.5f, 0.5f, 0.5f);
        material.unlit = step == 1;
        material.alphaMode = step == 2 ? scene::AlphaMode::blend : scene::AlphaMode::opaque;
        world.setMaterial(world.material(1), material);
        expectShown("painted", step);
    }
}

/// Pipelines that snap vertices are made for a size, and lists with them.
TEST_F(BinningChangesTest, EditsBeforeAnotherSizeAreDrawn) {
    if (!canDrawGpuDriven()) {
        GTEST_SKIP() << "the device does not draw gpu-driven";
    }
    scene::Scene scene = boxScene();
    addBox(scene, {-3.0, 0.0, -8.0});
    scene::World world(scene);
    render::RenderOptions options = thumbnailOptions(depth::parseTechnique("reversed"));
    options.submission = render::Submission::gpuDriven;
    options.snapping = render::Snapping::inPlane;
    SoleRenderer renderer(device(), world, options);
    const scene::Camera camera{.farView = 1000.0};
    renderer.draw(camera);
    world.setTransform(world.instance(0), {.position = {3.0, 0.0, -8.0}});
    renderer.resize(2 * options.width, options.height);
    const render::Frame frame = renderer.render(camera);
    EXPECT_EQ(hashOf(frame), hashOf(draw(world.scene(), camera, renderer.options())));
}

/// What grew has room to grow on.
TEST_F(BinningChangesTest, AnInstanceWithEachFrameTakesNoBuffersInEach) {
    if (!canDrawGpuDriven()) {
        GTEST_SKIP() << "the device does not draw gpu-driven";
    }
    scene::Scene scene = boxScene();
    for (int i = 0; i < 100; ++i) {
        addBox(scene, {0.0, 0.0, -5.0 - i});
    }
    scene::World world(scene);
    render::RenderOptions options = thumbnailOptions(depth::parseTechnique("anchored/count:2"));
    options.submission = render::Submission::gpuDriven;
    SoleRenderer renderer(device(), world, options);
    renderer.draw({});
    constexpr std::size_t kFrames = 20;
    std::size_t withBuffers = 0;
    for (std::size_t frame = 0; frame < kFrames; ++frame) {
        world.addInstance({.mesh = world.mesh(0),
                           .material = world.material(0),
                           .object = 1000,
                           .transform = {.position = {0.0, 0.0, -5.0}}});
        const FailingCall failing("vkCreateBuffer");
        try {
            renderer.draw({});
        } catch (const std::exception&) {
            renderer.draw({}); // only one call fails
        }
        withBuffers += FailingCall::hasFailed() ? 1 : 0;
    }
    EXPECT_GE(withBuffers, 1u);
    EXPECT_LE(withBuffers, kFrames / 3);
}

} // namespace

} // namespace cdr::render_test
