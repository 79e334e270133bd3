#include "random.h"

#include <cdr/base/error.h>
#include <scenes/cubes.h>
#include <scenes/random.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace cdr::scenes {

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// A scene with one white material and a unit cube as its only mesh.
scene::Scene cubeScene(const char* name, double halfDistanceOfLight) {
    scene::Scene scene;
    scene.name = name;
    scene.meshes.push_back(scene::makeBox(glm::vec3(0.5f)));
    scene.materials.push_back({.name = "white", .baseColorFactor = glm::vec4(0.8f, 0.8f, 0.8f, 1.0f)});
    scene.lights.push_back(
        {.position = glm::dvec3(0.0), .color = glm::vec3(1.0f), .halfDistance = halfDistanceOfLight});
    return scene;
}

void addCube(scene::Scene& scene, const glm::dvec3& position, float scale = 1.0f) {
    const auto object = static_cast<std::uint32_t>(scene.instances.size());
    scene::addInstance(scene, 0, 0, object, position, glm::mat3(scale));
}

/// Centres of 1000 unit cubes that lie wholly within the 32^3 field of the 2AFC scene.
std::vector<glm::dvec3> afcField(std::uint64_t seed) {
    Random random(seed);
    std::vector<glm::dvec3> centres(1000);
    std::generate(centres.begin(), centres.end(), [&] { return random.inCube(15.5); });
    return centres;
}

} // namespace

scene::StagedScene makeCubes(std::uint64_t seed) {
    constexpr double kScale = 10.0;
    constexpr double kDistance = 12'000.0;
    std::vector<glm::dvec3> centres = afcField(seed);
    std::sort(centres.begin(), centres.end(), [](const auto& a, const auto& b) { return a.z > b.z; });
    scene::StagedScene staged{.scene = cubeScene("cubes", 16.0 * kScale), .path = {}};
    for (const glm::dvec3& centre : centres) {
        addCube(staged.scene, centre * kScale, static_cast<float>(kScale));
    }
    const scene::Camera lens{.fovY = 0.87 * kDegree, .nearView = 0.01, .farView = 100'000.0};
    staged.path = scene::stillPath(scene::lookAt(lens, glm::dvec3(0.0, 0.0, kDistance), glm::dvec3(0.0)));
    return staged;
}

scene::StagedScene makeAfc(std::uint64_t seed) {
    scene::StagedScene staged{.scene = cubeScene("afc", 16.0), .path = {}};
    for (const glm::dvec3& centre : afcField(seed)) {
        addCube(staged.scene, centre);
    }
    const scene::Camera lens{.fovY = 0.002 * kDegree, .nearView = 0.001, .farView = 2e6};
    staged.path = scene::orbitPath(lens, glm::dvec3(0.0), 1e6, 360);
    return staged;
}

scene::StagedScene makeAfcNear(std::uint64_t seed) {
    constexpr double kAhead = 0.01;
    constexpr float kSide = 0.002f;
    constexpr double kHalf = 0.5 * static_cast<double>(kSide);
    scene::StagedScene staged = makeAfc(seed);
    staged.scene.name = "afc-near";
    const scene::CameraPath orbit = staged.path;
    for (std::uint32_t frame = 0; frame < orbit.frames; ++frame) {
        const scene::Camera camera = orbit.at(frame);
        // The face it turns to the camera, kHalf nearer, reaches a tenth of the picture's height into a
        // corner.
        const double corner = std::tan(0.5 * camera.fovY) * (kAhead - kHalf);
        const double right = corner * (16.0 / 9.0 - 0.2) + kHalf;
        const double up = corner * 0.8 + kHalf;
        const auto object = static_cast<std::uint32_t>(staged.scene.instances.size());
        scene::addInstance(staged.scene, 0, 0, object,
                           camera.position + right * camera.right + up * camera.up - kAhead * camera.back,
                           glm::mat3(camera.right, camera.up, camera.back) * kSide);
    }
    staged.path.at = [orbit](std::uint32_t frame) {
        scene::Camera camera = orbit.at(frame);
        camera.farView -= 1.0; // this side of the cube opposite
        return camera;
    };
    return staged;
}

scene::StagedScene makeRotation(std::uint64_t seed, std::uint32_t cubes) {
    if (cubes > scene::kMaxObjects) {
        throw base::InputError("rotation: at most " + std::to_string(scene::kMaxObjects) + " cubes");
    }
    scene::StagedScene staged{.scene = cubeScene("rotation", 100.0), .path = {}};
    Random random(seed);
    for (std::uint32_t i = 0; i < cubes; ++i) {
        addCube(staged.scene, random.inCube(200.0));
    }
    const scene::Camera lens{.fovY = 60.0 * kDegree, .nearView = 0.1, .farView = 100'000.0};
    staged.path = scene::turnPath(lens, glm::dvec3(0.0), 360);
    return staged;
}

scene::StagedScene makeCrowd(std::uint64_t seed, std::uint32_t cubes, double aspect) {
    if (cubes > scene::kMaxObjects) {
        throw base::InputError("crowd: at most " + std::to_string(scene::kMaxObjects) + " cubes");
    }
    const scene::Camera lens{.fovY = 60.0 * kDegree, .nearView = 100.0, .farView = 10'000.0};
    // Wider than a cube's bounding sphere, so that no cube touches a plane.
    constexpr double kMargin = 2.0;
    const double tanY = std::tan(0.5 * lens.fovY);
    const double nearest = std::log(lens.nearView + kMargin);
    const double farthest = std::log(lens.farView - kMargin);
    scene::StagedScene staged{.scene = cubeScene("crowd", 1'000.0), .path = {}};
    Random random(seed);
    for (std::uint32_t i = 0; i < cubes; ++i) {
        const double w = std::exp(random.uniform(nearest, farthest));
        const double halfX = std::max(0.0, w * tanY * aspect - kMargin * std::hypot(1.0, tanY * aspect));
        const double halfY = w * tanY - kMargin * std::hypot(1.0, tanY);
        const double x = random.uniform(-halfX, halfX);
        const double y = random.uniform(-halfY, halfY);
        addCube(staged.scene, {x, y, -w});
    }
    staged.path = scene::stillPath(lens);
    return staged;
}

double ladderSeparation(const LadderOptions& options, std::uint32_t pair) {
    const double share = static_cast<double>(pair) / (kLadderPairs - 1);
    return options.scale * options.smallestSeparation *
           std::pow(options.largestSeparation / options.smallestSeparation, share);
}

scene::StagedScene makeLadder(std::uint64_t seed, const LadderOptions& options) {
    constexpr std::uint32_t kColumns = 16;
    scene::StagedScene staged{.scene = cubeScene("ladder", 32.0 * options.scale), .path = {}};
    staged.scene.lights.front().position = {0.0, 0.0, 64.0 * options.scale};
    const auto side = static_cast<float>(options.scale);
    Random random(seed);
    for (std::uint32_t pair = 0; pair < kLadderPairs; ++pair) {
        const std::uint32_t column = pair % kColumns;
        const std::uint32_t row = pair / kColumns;
        const glm::dvec3 back =
            options.scale * glm::dvec3(2.0 * column - 15.0, 15.0 - 2.0 * row, random.uniform(-0.5, 0.5));
        const glm::dvec3 front = back + glm::dvec3(0.0, 0.0, ladderSeparation(options, pair));
        const bool backFirst = random.uniform(0.0, 1.0) < 0.5;
        addCube(staged.scene, backFirst ? back : front, side);
        addCube(staged.scene, backFirst ? front : back, side);
    }
    const double halfHeight = 18.0 * options.scale;
    const scene::Camera lens{.fovY = 2.0 * std::atan(halfHeight / options.distanceView),
                             .nearView = options.nearView,
                             .farView = options.farView};
    const double angle = 20.0 * kDegree;
    const glm::dvec3 eye = options.distanceView * glm::dvec3(std::sin(angle), 0.0, std::cos(angle));
    staged.path = scene::stillPath(scene::lookAt(lens, eye, glm::dvec3(0.0)));
    return staged;
}

} // namespace cdr::scenes
