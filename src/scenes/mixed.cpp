#include <scenes/degree.h>
#include <scenes/mixed.h>
#include <scenes/scene_builder.h>

#include <cmath>
#include <numbers>

namespace cdr::scenes {

namespace {

/// Turned about y, then about x.
glm::dmat3 turnedBy(double yaw, double pitch) {
    const glm::dmat3 aboutY(std::cos(yaw), 0.0, -std::sin(yaw), 0.0, 1.0, 0.0, std::sin(yaw), 0.0,
                            std::cos(yaw));
    const glm::dmat3 aboutX(1.0, 0.0, 0.0, 0.0, std::cos(pitch), std::sin(pitch), 0.0, -std::sin(pitch),
                            std::cos(pitch));
    return aboutX * aboutY;
}

} // namespace

scene::SceneSetup makeMixed() {
    constexpr double kSide = 0.018;
    constexpr double kSpacing = 0.027;
    const double kBehind = std::numbers::sqrt3; // puts corner-on faces one below
    scene::SceneSetup setup;
    scene::Scene& scene = setup.scene;
    scene.name = "mixed";
    scene.meshes.push_back(scene::makeBox(glm::vec3(0.5f)));
    scene.materials.push_back({.name = "white", .baseColorFactor = glm::vec4(0.8f, 0.8f, 0.8f, 1.0f)});
    scene.materials.push_back({.name = "twin", .baseColorFactor = glm::vec4(0.7f, 0.05f, 0.05f, 1.0f)});
    scene.lights.push_back(farLight({0.3, 0.5, 0.8}, 1e12));
    for (std::uint32_t pair = 0; pair < kMixedPairs; ++pair) {
        const std::uint32_t cell = pair / kMixedPairsPerCell;
        const std::uint32_t column = cell / kMixedShares.size();
        const std::uint32_t row = cell % kMixedShares.size();
        const std::uint32_t place = pair % kMixedPairsPerCell;
        const double w = kMixedDistances[column];
        const double x = 0.14 * (column - 1.5) + kSpacing * (place % 3 - 1.0);
        const double y = 0.082 - 0.164 * row + kSpacing * (1.0 - std::floor(place / 3));
        const glm::dvec3 centre = w * glm::dvec3(x, y, -1.0);
        // A corner towards the eye, a little aside: on faces seen from the edge, x and y would decide.
        const scene::Camera facing = scene::lookAt({}, glm::dvec3(0.0), centre);
        const glm::dmat3 turned = glm::dmat3(facing.right, facing.up, facing.back) *
                                  turnedBy((41.0 + place) * kDegree, 35.0 * kDegree);
        const glm::mat3 basis(turned * (kSide * w));
        scene::addInstance(scene, 0, 0, 2 * pair, centre, basis);
        scene::addInstance(scene, 0, 1, 2 * pair + 1, centre * (1.0 + kBehind * kMixedShares[row]), basis);
    }
    setup.path = scene::stillPath({.fovY = 20.0 * kDegree, .nearView = 0.1, .farView = 2e8});
    return setup;
}

} // namespace cdr::scenes
