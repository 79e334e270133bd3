#include "../cameras.h"

#include <cdr/measure/truth/object_ray.h>
#include <cdr/measure/truth/shape.h>
#include <scenes/cubes.h>
#include <scenes/sheets.h>
#include <scenes/traffic.h>
#include <viewer/state/camera/fly_controller.h>
#include <viewer/state/camera/obstacles.h>

#include <algorithm>
#include <array>
#include <random>

namespace cdr::viewer {

namespace {

using namespace viewer_test;

constexpr std::array kWays{CameraKey::forward, CameraKey::backward, CameraKey::left,
                           CameraKey::right,   CameraKey::up,       CameraKey::down};

bool isInACube(const scene::Instances& cubes, const glm::dvec3& place) {
    for (std::size_t i = 0; i < cubes.size(); ++i) {
        const glm::dvec3 local = glm::transpose(glm::dmat3(cubes.basis[i])) * (place - cubes.position(i));
        if (std::max({std::abs(local.x), std::abs(local.y), std::abs(local.z)}) < 0.5) {
            return true;
        }
    }
    return false;
}

/// In every direction, by steps that would leap over a cube, and without any picture.
TEST(Obstacles, StopAFlightInEveryDirection) {
    const scene::SceneSetup setup = scenes::makeAfc(2013);
    platform::WorkerPool workers(1);
    const Obstacles obstacles(setup.scene, workers);
    std::mt19937_64 random(2013);
    scene::Camera camera = cameraWith(60.0, {0.0, 0.0, 40.0}, {0.0, 0.0, 0.0});
    int stops = 0;
    for (int step = 0; step < 4000; ++step) {
        const scene::Camera before = camera;
        const CameraKey way = kWays.at(random() % kWays.size());
        const scene::Camera wanted =
            fly(camera,
                {.keys = {way},
                 .drag = {static_cast<double>(random() % 100), static_cast<double>(random() % 100)},
                 .seconds = 0.2},
                20.0);
        camera = stopped(before, wanted, obstacles);
        ASSERT_FALSE(isInACube(setup.scene.instances, camera.position)) << step;
        stops += camera.position != wanted.position ? 1 : 0;
        if (glm::length(camera.position) > 40.0) {
            camera.position *= 0.1;
            camera.position += isInACube(setup.scene.instances, camera.position) ? glm::dvec3(0.0, 0.0, 40.0)
                                                                                 : glm::dvec3(0.0);
        }
    }
    EXPECT_GT(stops, 100);
}

/// Of cubes that move it stops at those where they are, and where one was it flies through.
TEST(Obstacles, MoveWithTheScene) {
    scene::Scene scene;
    scene.meshes.push_back(scene::makeBox(glm::vec3(0.5f)));
    scene.materials.push_back({.name = "white"});
    scene::addInstance(scene, 0, 0, 0, {0.0, 0.0, -5.0}, glm::mat3(1.0f));
    platform::WorkerPool workers(1);
    const Obstacles before(scene, workers);
    scene::Scene shown = scene;
    shown.instances = {};
    scene::addInstance(shown, 0, 0, 0, {20.0, 0.0, 0.0}, glm::mat3(1.0f));
    const Obstacles after = before.moved(shown, {}, workers);
    shown = {}; // what was taken from it stays
    const glm::dvec3 from(0.0);
    const glm::dvec3 ahead(0.0, 0.0, -100.0);
    const glm::dvec3 right(100.0, 0.0, 0.0);
    EXPECT_NEAR(before.clearWay(from, ahead), 4.5, 1e-9);
    EXPECT_EQ(before.clearWay(from, right), 100.0);
    EXPECT_EQ(after.clearWay(from, ahead), 100.0);
    EXPECT_NEAR(after.clearWay(from, right), 19.5, 1e-9);
    EXPECT_EQ(before.instances().position(0), glm::dvec3(0.0, 0.0, -5.0));
    EXPECT_EQ(after.instances().position(0), glm::dvec3(20.0, 0.0, 0.0));
}

/// As a device bends meshes: the scene that is shown has other vertices.
TEST(Obstacles, BendAsTheyAreTold) {
    scene::Scene scene;
    scene.meshes = {scenes::makeSquare(1.0f)};
    scene.materials = {{.doubleSided = true}};
    scene::addInstance(scene, 0, 0, 0, {0.0, 0.0, -5.0}, glm::mat3(1.0f));
    platform::WorkerPool workers(1);
    const Obstacles before(scene, workers);
    scene::MeshVertices vertices{.vertices = scene.meshes[0].vertices, .details = {}};
    for (scene::Vertex& vertex : vertices.vertices) {
        vertex.position.z += 0.5f;
    }
    const std::uint32_t mesh = 0;
    const Obstacles after = before.bent({&mesh, 1}, {vertices}, workers);
    const glm::dvec3 ahead(0.0, 0.0, -100.0);
    EXPECT_NEAR(before.clearWay(glm::dvec3(0.0), ahead), 5.0, 1e-9);
    EXPECT_NEAR(after.clearWay(glm::dvec3(0.0), ahead), 4.5, 1e-9);
}

/// What boxes of neighbours leave out changes nothing: ways past each cube, and into it.
TEST(Obstacles, AreMetAsIfEachWereLookedAt) {
    const scene::Scene scene = scenes::makeTraffic(2013, 2000).scene;
    const scene::Instances& cubes = scene.instances;
    platform::WorkerPool workers(1);
    const Obstacles obstacles(scene, workers);
    const measure::Shape box(scene.meshes[0]);
    std::size_t met = 0;
    for (std::size_t way = 0; way < cubes.size(); ++way) {
        const glm::dvec3 from = cubes.position(way) * 1.01;
        const glm::dvec3 to = cubes.position(way) * (way % 2 == 0 ? 1.3 : 1.003);
        double share = 1.0;
        for (std::size_t i = 0; i < cubes.size(); ++i) {
            const glm::dmat3 turn = measure::invertBasis(cubes.basis[i])->worldToObject;
            share = std::min(share, box.nearest({turn * (from - cubes.position(i)), turn * (to - from)},
                                                measure::Sidedness::fronts, {0.0, 1.0}));
        }
        ASSERT_EQ(obstacles.clearWay(from, to), share * glm::length(to - from)) << way;
        met += share < 1.0 ? 1 : 0;
    }
    EXPECT_GE(met, cubes.size() / 2);
    EXPECT_LT(met, cubes.size());
}

/// A thousand kilometres from the origin, to within two near planes.
TEST(Obstacles, StopTwoNearPlanesBeforeASurface) {
    scene::Scene scene;
    scene.meshes = {scene::makeBox(glm::vec3(0.5f)), scenes::makeSquare(100.0f)};
    scene.materials = {{}, {.doubleSided = true, .alphaMode = scene::AlphaMode::blend}};
    const glm::dvec3 far(1e6, 0.0, 0.0);
    scene::addInstance(scene, 0, 0, 0, far, glm::mat3(1.0f));
    scene::addInstance(scene, 1, 1, 1, far + glm::dvec3(0.0, 0.0, 2.0), glm::mat3(1.0f));
    platform::WorkerPool workers(1);
    const Obstacles obstacles(scene, workers);
    const scene::Camera before = cameraWith(60.0, far + glm::dvec3(0.0, 0.0, 3.0), far);
    scene::Camera after = before;
    after.position = far - glm::dvec3(0.0, 0.0, 3.0);
    EXPECT_NEAR(stopped(before, after, obstacles).position.z, 0.5 + 2.0 * before.nearView,
                1e-9); // through the glass
    EXPECT_EQ(obstacles.clearWay(far, after.position), 3.0) << "out of the cube it is free";
    after.position = far + glm::dvec3(3.0, 0.0, -3.0);
    EXPECT_EQ(stopped(before, after, obstacles).position, after.position) << "past it";
    expectSame(stopped(before, before, obstacles), before);
}

} // namespace

} // namespace cdr::viewer
