#include "../support/refusal.h"

#include <cdr/base/error.h>
#include <scenes/cubes.h>
#include <scenes/ladder.h>
#include <scenes/open_scene.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace {

using namespace cdr::scene;
using namespace cdr::scenes;
using cdr::base::InputError;

TEST(Generators, AfcIsTheThesisScene) {
    const SceneSetup setup = makeAfc(1);
    EXPECT_EQ(setup.scene.instances.size(), 1000u);
    EXPECT_EQ(setup.path.frames, 360u);
    for (std::size_t i = 0; i < setup.scene.instances.size(); ++i) {
        const glm::dvec3 p = glm::abs(setup.scene.instances.position(i));
        EXPECT_LE(std::max({p.x, p.y, p.z}) + 0.5, 16.0);
    }
    for (const std::uint32_t frame : {0u, 90u, 359u}) {
        const Camera camera = setup.path.at(frame);
        EXPECT_NEAR(glm::length(camera.position), 1e6, 1e-6);
        EXPECT_NEAR(camera.viewDistance(glm::dvec3(0.0)), 1e6, 1e-6);
        EXPECT_NEAR(camera.fovY * 180.0 / std::numbers::pi, 0.002, 1e-12);
    }
}

TEST(Generators, ASeedFixesTheScene) {
    EXPECT_EQ(makeAfc(5).scene.instances.x, makeAfc(5).scene.instances.x);
    EXPECT_NE(makeAfc(5).scene.instances.x, makeAfc(6).scene.instances.x);
    // The first value of mt19937_64(2013), so that scenes stay what they are on every platform.
    EXPECT_DOUBLE_EQ(makeRotation(2013, 1).scene.instances.x[0], makeRotation(2013, 9).scene.instances.x[0]);
}

TEST(Generators, CubesAreListedNearestFirst) {
    const SceneSetup setup = makeCubes(1);
    const Camera camera = setup.path.at(0);
    for (std::size_t i = 1; i < setup.scene.instances.size(); ++i) {
        EXPECT_GE(camera.viewDistance(setup.scene.instances.position(i)),
                  camera.viewDistance(setup.scene.instances.position(i - 1)));
    }
}

TEST(Generators, ACrowdIsWhollyInViewAndEvenOverCascades) {
    for (const double aspect : {16.0 / 9.0, 1.0, 0.5}) {
        const SceneSetup setup = makeCrowd(3, 4000, aspect);
        const Camera camera = setup.path.at(0);
        const double tanY = std::tan(0.5 * camera.fovY);
        std::vector<int> perCascade(4);
        for (std::size_t i = 0; i < setup.scene.instances.size(); ++i) {
            const glm::dvec3 p = camera.toView(setup.scene.instances.position(i));
            EXPECT_LT((std::abs(p.x) + 1.0) / (tanY * aspect), -p.z - 1.0);
            EXPECT_LT((std::abs(p.y) + 1.0) / tanY, -p.z - 1.0);
            const double share =
                std::log(-p.z / camera.nearView) / std::log(camera.farView / camera.nearView);
            ++perCascade.at(static_cast<std::size_t>(4.0 * share));
        }
        for (const int cubes : perCascade) {
            EXPECT_NEAR(cubes, 1000, 120);
        }
    }
}

TEST(Generators, LadderRungsAscendInEqualRatios) {
    const LadderOptions options;
    EXPECT_DOUBLE_EQ(ladderSeparation(options, 0), 1e-6);
    EXPECT_DOUBLE_EQ(ladderSeparation(options, kLadderPairs - 1), 1.0);
    const SceneSetup setup = makeLadder(1, options);
    ASSERT_EQ(setup.scene.instances.size(), 2 * kLadderPairs);
    for (std::uint32_t pair = 0; pair < kLadderPairs; ++pair) {
        const glm::dvec3 gap =
            setup.scene.instances.position(2 * pair + 1) - setup.scene.instances.position(2 * pair);
        EXPECT_EQ(gap.x, 0.0);
        EXPECT_EQ(gap.y, 0.0);
        EXPECT_NEAR(std::abs(gap.z), ladderSeparation(options, pair), 1e-15);
    }
}

TEST(Generators, BoxesFaceOutwards) {
    const Mesh box = makeBox(glm::vec3(1.0f, 2.0f, 3.0f));
    ASSERT_EQ(box.indices.size(), 36u);
    for (std::size_t i = 0; i < box.indices.size(); i += 3) {
        const Vertex& a = box.vertices[box.indices[i]];
        const Vertex& b = box.vertices[box.indices[i + 1]];
        const Vertex& c = box.vertices[box.indices[i + 2]];
        const glm::vec3 normal = glm::normalize(glm::cross(b.position - a.position, c.position - a.position));
        EXPECT_GT(glm::dot(normal, a.position), 0.0f);
        EXPECT_NEAR(glm::dot(normal, a.normal), 1.0f, 1e-6f);
    }
}

TEST(Instances, RadiusBoundsTheTransformedMesh) {
    Scene scene;
    scene.meshes.push_back(makeBox(glm::vec3(0.5f)));
    scene.materials.push_back({});
    const glm::mat3 shear(2.0f, 0.5f, 0.0f, 1.0f, 3.0f, 0.25f, 0.0f, 0.0f, 0.1f);
    for (const glm::mat3& basis : {glm::mat3(1.0f), glm::mat3(4.0f), shear}) {
        addInstance(scene, 0, 0, 0, glm::dvec3(0.0), basis);
        for (const Vertex& vertex : scene.meshes[0].vertices) {
            EXPECT_LE(glm::length(basis * vertex.position), scene.instances.radius.back());
        }
    }
    EXPECT_LT(scene.instances.radius[0], 0.8661f);
}

TEST(Camera, LooksAtItsTarget) {
    for (const glm::dvec3& eye : {glm::dvec3(3, 4, 5), glm::dvec3(0, 9, 0), glm::dvec3(0, -9, 0)}) {
        const Camera camera = lookAt(Camera{}, eye, glm::dvec3(1e-3, 0, 0));
        const glm::dvec3 seen = camera.toView(glm::dvec3(1e-3, 0, 0));
        EXPECT_NEAR(seen.x, 0.0, 1e-12);
        EXPECT_NEAR(seen.y, 0.0, 1e-12);
        EXPECT_LT(seen.z, 0.0);
        EXPECT_NEAR(glm::dot(glm::cross(camera.right, camera.up), camera.back), 1.0, 1e-12);
    }
    EXPECT_THROW(lookAt(Camera{}, glm::dvec3(1.0), glm::dvec3(1.0)), InputError);
}

TEST(Camera, RefusesUnusableLenses) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_NO_THROW(requireUsable(Camera{}));
    EXPECT_THROW(requireUsable({.nearView = 0.0}), InputError);
    EXPECT_THROW(requireUsable({.nearView = 2.0, .farView = 2.0}), InputError);
    EXPECT_THROW(requireUsable({.nearView = kNan}), InputError);
    EXPECT_THROW(requireUsable({.farView = std::numeric_limits<double>::infinity()}), InputError);
    EXPECT_THROW(requireUsable({.fovY = 0.0}), InputError);
    EXPECT_THROW(requireUsable({.fovY = 4.0}), InputError);
}

TEST(OpenScene, SuggestsNamesForUnknownOnes) {
    const std::string message = cdr::test::inputErrorOf([&] { openScene("rotatoin", 1); });
    EXPECT_NE(message.find("did you mean 'rotation'"), std::string::npos);
    EXPECT_THROW(openScene("missing.glb", 1), InputError);
}

} // namespace
