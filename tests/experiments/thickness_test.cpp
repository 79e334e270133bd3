#include <experiments/inspect/thickness.h>

#include <gtest/gtest.h>

#include <cmath>

namespace cdr::experiments_test {

namespace {

/// A box of those half sides, turned about z and then doubled.
scene::Scene boxOf(const glm::vec3& halfSides) {
    scene::Scene scene;
    scene.meshes.push_back(scene::makeBox(halfSides));
    scene.materials.push_back({.name = "white"});
    const float turn = 0.7f;
    const glm::mat3 turned(std::cos(turn), std::sin(turn), 0.0f, -std::sin(turn), std::cos(turn), 0.0f, 0.0f,
                           0.0f, 1.0f);
    scene::addInstance(scene, 0, 0, 0, {1e6, 2.0, -3.0}, 2.0f * turned);
    return scene;
}

TEST(Thickness, OfABoxIsItsSmallestSideHoweverItIsTurned) {
    EXPECT_NEAR(experiments::thicknessOf(boxOf({3.0f, 0.01f, 2.0f}), 0), 0.04, 1e-6);
    EXPECT_NEAR(experiments::thicknessOf(boxOf({1.0f, 1.0f, 1.0f}), 0), 4.0, 1e-6);
}

/// As exporters write that bake a node's rotation into its vertices: no axis of the mesh is across the face.
TEST(Thickness, OfAFlatFaceIsNoneWhicheverWayItIsTurnedInItsMesh) {
    scene::Scene scene = boxOf({1.0f, 1.0f, 1.0f});
    scene::Mesh& mesh = scene.meshes[0];
    mesh = {};
    for (const glm::vec3 corner : {glm::vec3(-1.0f, -1.0f, -1.0f), glm::vec3(1.0f, -1.0f, -1.0f),
                                   glm::vec3(1.0f, 1.0f, 1.0f), glm::vec3(-1.0f, 1.0f, 1.0f)}) {
        mesh.vertices.push_back({.position = corner});
    }
    mesh.indices = {0, 1, 2, 0, 2, 3};
    EXPECT_NEAR(experiments::thicknessOf(scene, 0), 0.0, 1e-6);
    mesh.indices.clear();
    EXPECT_EQ(experiments::thicknessOf(scene, 0), 0.0);
}

} // namespace

} // namespace cdr::experiments_test
