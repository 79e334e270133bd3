#include <cdr/base/error.h>
#include <scenes/moving_scene.h>
#include <scenes/open_scene.h>
#include <scenes/traffic.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace cdr::scenes {

namespace {

TEST(Traffic, ReachesFromAUnitToTenMillionInEachDecade) {
    const scene::SceneSetup setup = openScene("traffic", 2013).setup;
    ASSERT_EQ(setup.scene.instances.size(), 100'000u);
    for (const std::uint32_t frame : {0u, 100u}) {
        std::array<int, 7> decades{};
        for (const scene::Transform& transform : setup.motion.transforms(frame)) {
            const double distance = glm::length(transform.position);
            ASSERT_GE(distance, 0.999999);
            ASSERT_LE(distance, 1.000001e7);
            ++decades[static_cast<std::size_t>(std::clamp(std::log10(distance), 0.0, 6.999))];
        }
        for (const int movers : decades) {
            EXPECT_NEAR(movers, 100'000 / 7, 500);
        }
    }
}

TEST(Traffic, AllMoveAndEveryFrameCanBeMadeAlone) {
    const scene::SceneSetup setup = makeTraffic(1, 500);
    const std::vector<scene::Transform> before = setup.motion.transforms(3);
    const std::vector<scene::Transform> after = setup.motion.transforms(4);
    EXPECT_EQ(setup.motion.transforms(3), before);
    for (std::size_t i = 0; i < before.size(); ++i) {
        const double share =
            glm::length(after[i].position - before[i].position) / glm::length(before[i].position);
        EXPECT_GT(share, 0.0);
        EXPECT_LT(share, 0.004);
        EXPECT_NE(after[i].basis, before[i].basis);
    }
    MovingScene moving(setup.scene, setup.motion);
    platform::WorkerPool workers(1);
    for (const std::uint32_t frame : {7u, 4u}) {
        moving.show(frame, workers);
    }
    const scene::Instances& instances = moving.world().scene().instances;
    for (std::size_t i = 0; i < instances.size(); ++i) {
        EXPECT_EQ(instances.position(i), after[i].position);
        EXPECT_EQ(instances.basis[i], after[i].basis);
    }
    EXPECT_THROW(makeTraffic(1, scene::kMaxObjects + 1), base::InputError);
}

/// Both would not hold for other vertices.
TEST(MovingScene, KeepsNoLevelsAndNoClustersOfWhatBends) {
    scene::Scene scene;
    scene.meshes.push_back(scene::makeBox(glm::vec3(1.0f)));
    scene.meshes[0].levels.push_back({.indices = {0, 1, 2}, .error = 1.0f});
    scene.meshes[0].clusters.indices = {0, 1, 2};
    scene.meshes[0].clusters.clusters.push_back({.indexCount = 3});
    scene.meshes.push_back(scene.meshes[0]);
    scene::SceneMotion motion;
    motion.meshes = {0};
    const MovingScene moving(scene, motion);
    const std::vector<scene::Mesh>& meshes = moving.world().scene().meshes;
    EXPECT_TRUE(meshes[0].levels.empty());
    EXPECT_TRUE(meshes[0].clusters.clusters.empty());
    EXPECT_FALSE(meshes[1].clusters.clusters.empty());
}

/// The meshes have then moved, and the instances have not.
TEST(MovingScene, ComesBackFromAFrameThatFails) {
    scene::Scene scene;
    scene.meshes.push_back(scene::makeBox(glm::vec3(1.0f)));
    scene.materials.push_back({.name = "white"});
    scene::addInstance(scene, 0, 0, 0, {0.0, 0.0, -5.0}, glm::mat3(1.0f));
    const std::vector<scene::Vertex> atRest = scene.meshes[0].vertices;
    scene::SceneMotion motion;
    motion.instances = {0};
    motion.transforms = [](std::uint32_t frame) {
        if (frame == 1) {
            throw base::InputError("nowhere");
        }
        return std::vector<scene::Transform>{{.position = {0.0, 0.0, -5.0}}};
    };
    motion.meshes = {0};
    motion.vertices = [&atRest](std::uint32_t frame, platform::WorkerPool&) {
        std::vector<scene::Vertex> vertices = atRest;
        vertices[0].position.x += 0.25f * static_cast<float>(frame);
        return std::vector<scene::MeshVertices>{{.vertices = vertices, .details = {}}};
    };
    MovingScene moving(scene, motion);
    platform::WorkerPool workers(1);
    EXPECT_THROW(moving.show(1, workers), base::InputError);
    EXPECT_TRUE(moving.show(0, workers));
    EXPECT_EQ(moving.world().scene().meshes[0].vertices[0].position, atRest[0].position);
    EXPECT_FALSE(moving.show(0, workers));
}

} // namespace

} // namespace cdr::scenes
