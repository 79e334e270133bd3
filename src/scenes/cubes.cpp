#include <cdr/base/error.h>
#include <cdr/scene/frustum.h>
#include <scenes/cube_scene.h>
#include <scenes/cubes.h>
#include <scenes/degree.h>
#include <scenes/random.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace cdr::scenes {

namespace {

/// Centres of 1000 unit cubes that lie wholly within the 32^3 field of the 2AFC scene.
std::vector<glm::dvec3> afcField(std::uint64_t seed) {
    Random random(seed);
    std::vector<glm::dvec3> centres(1000);
    std::generate(centres.begin(), centres.end(), [&] { return random.inCube(15.5); });
    return centres;
}

} // namespace

scene::SceneSetup makeCubes(std::uint64_t seed) {
    constexpr double kScale = 10.0;
    constexpr double kDistance = 12'000.0;
    std::vector<glm::dvec3> centres = afcField(seed);
    std::sort(centres.begin(), centres.end(), [](const auto& a, const auto& b) { return a.z > b.z; });
    scene::SceneSetup setup{.scene = cubeScene("cubes", 16.0 * kScale), .path = {}};
    for (const glm::dvec3& centre : centres) {
        addCube(setup.scene, centre * kScale, static_cast<float>(kScale));
    }
    const scene::Camera lens{.fovY = 0.87 * kDegree, .nearView = 0.01, .farView = 100'000.0};
    setup.path = scene::stillPath(scene::lookAt(lens, glm::dvec3(0.0, 0.0, kDistance), glm::dvec3(0.0)));
    return setup;
}

scene::SceneSetup makeAfc(std::uint64_t seed) {
    scene::SceneSetup setup{.scene = cubeScene("afc", 16.0), .path = {}};
    for (const glm::dvec3& centre : afcField(seed)) {
        addCube(setup.scene, centre);
    }
    const scene::Camera lens{.fovY = 0.002 * kDegree, .nearView = 0.001, .farView = 2e6};
    setup.path = scene::orbitPath(lens, glm::dvec3(0.0), 1e6, 360);
    return setup;
}

scene::SceneSetup makeAfcNear(std::uint64_t seed) {
    constexpr double kAhead = 0.01;
    constexpr float kSide = 0.002f;
    constexpr double kHalf = 0.5 * static_cast<double>(kSide);
    scene::SceneSetup setup = makeAfc(seed);
    setup.scene.name = "afc-near";
    const scene::CameraPath orbit = setup.path;
    for (std::uint32_t frame = 0; frame < orbit.frames; ++frame) {
        const scene::Camera camera = orbit.at(frame);
        // The face it turns to the camera, kHalf nearer, reaches a tenth of the picture's height into a
        // corner.
        const double corner = scene::frustumOf(camera, 16.0, 9.0).tanY * (kAhead - kHalf);
        const double right = corner * (16.0 / 9.0 - 0.2) + kHalf;
        const double up = corner * 0.8 + kHalf;
        addBox(setup.scene, 0, camera.position + right * camera.right + up * camera.up - kAhead * camera.back,
               glm::mat3(camera.right, camera.up, camera.back) * kSide);
    }
    setup.path.at = [orbit](std::uint32_t frame) {
        scene::Camera camera = orbit.at(frame);
        camera.farView -= 1.0; // this side of the cube opposite
        return camera;
    };
    return setup;
}

scene::SceneSetup makeRotation(std::uint64_t seed, std::uint32_t cubes) {
    if (cubes > scene::kMaxObjects) {
        throw base::InputError("rotation: at most " + std::to_string(scene::kMaxObjects) + " cubes");
    }
    scene::SceneSetup setup{.scene = cubeScene("rotation", 100.0), .path = {}};
    Random random(seed);
    for (std::uint32_t i = 0; i < cubes; ++i) {
        addCube(setup.scene, random.inCube(200.0));
    }
    const scene::Camera lens{.fovY = 60.0 * kDegree, .nearView = 0.1, .farView = 100'000.0};
    setup.path = scene::turnPath(lens, glm::dvec3(0.0), 360);
    return setup;
}

scene::SceneSetup makeCrowd(std::uint64_t seed, std::uint32_t cubes, double aspect) {
    if (cubes > scene::kMaxObjects) {
        throw base::InputError("crowd: at most " + std::to_string(scene::kMaxObjects) + " cubes");
    }
    const scene::Camera lens{.fovY = 60.0 * kDegree, .nearView = 100.0, .farView = 10'000.0};
    // Wider than a cube's bounding sphere, so that no cube touches a plane.
    constexpr double kMargin = 2.0;
    const double tanY = scene::frustumOf(lens, aspect, 1.0).tanY;
    const double nearest = std::log(lens.nearView + kMargin);
    const double farthest = std::log(lens.farView - kMargin);
    scene::SceneSetup setup{.scene = cubeScene("crowd", 1'000.0), .path = {}};
    Random random(seed);
    for (std::uint32_t i = 0; i < cubes; ++i) {
        const double w = std::exp(random.uniform(nearest, farthest));
        const double halfX = std::max(0.0, w * tanY * aspect - kMargin * std::hypot(1.0, tanY * aspect));
        const double halfY = w * tanY - kMargin * std::hypot(1.0, tanY);
        const double x = random.uniform(-halfX, halfX);
        const double y = random.uniform(-halfY, halfY);
        addCube(setup.scene, {x, y, -w});
    }
    setup.path = scene::stillPath(lens);
    return setup;
}

} // namespace cdr::scenes
