#include "random.h"

#include <scenes/alley.h>
#include <scenes/cube_scene.h>

#include <array>
#include <cmath>
#include <numbers>

namespace cdr::scenes {

namespace {

constexpr double kLength = 240.0;
constexpr double kTile = 2.0;
constexpr int kTilesAcross = 12;
constexpr double kEyeHeight = 1.7;
enum MaterialIndex : std::uint32_t { lightTile, darkTile, post, firstBlock };

/// Adds a box that stands upright.
/// @param turn about the y axis.
void addUprightBox(scene::Scene& scene, std::uint32_t material, const glm::dvec3& centre,
                   const glm::dvec3& size, double turn = 0.0) {
    const glm::dmat3 basis(glm::dvec3(std::cos(turn), 0.0, -std::sin(turn)) * size.x,
                           glm::dvec3(0.0, size.y, 0.0),
                           glm::dvec3(std::sin(turn), 0.0, std::cos(turn)) * size.z);
    addBox(scene, material, centre, glm::mat3(basis));
}

void addMaterials(scene::Scene& scene) {
    constexpr std::array kColors{glm::vec3(0.55f, 0.5f, 0.42f), glm::vec3(0.16f, 0.15f, 0.15f),
                                 glm::vec3(0.9f, 0.88f, 0.8f),  glm::vec3(0.7f, 0.2f, 0.12f),
                                 glm::vec3(0.15f, 0.4f, 0.55f), glm::vec3(0.75f, 0.6f, 0.2f),
                                 glm::vec3(0.25f, 0.5f, 0.25f)};
    for (const glm::vec3& color : kColors) {
        scene.materials.push_back({.name = "paint", .baseColorFactor = glm::vec4(color, 1.0f)});
    }
}

void addFloor(scene::Scene& scene) {
    const int rows = static_cast<int>(kLength / kTile) + 3;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < kTilesAcross; ++column) {
            const glm::dvec3 centre((column - 0.5 * (kTilesAcross - 1)) * kTile, -0.1, (2.5 - row) * kTile);
            addUprightBox(scene, (row + column) % 2 == 0 ? lightTile : darkTile, centre, {kTile, 0.2, kTile});
        }
    }
}

void addSides(scene::Scene& scene, Random& random) {
    constexpr std::uint32_t kColors = 4;
    std::uint32_t number = 0;
    for (double z = -3.0; z > -kLength; z -= 6.0) {
        for (const double side : {-1.0, 1.0}) {
            // One number a line: compilers differ in the order of arguments.
            const double length = random.uniform(1.5, 3.5);
            const double height = random.uniform(1.5, 6.0);
            const double width = random.uniform(1.5, 3.0);
            const double turn = random.uniform(-0.4, 0.4);
            const double aside = side * random.uniform(6.5, 8.5);
            const double ahead = z - random.uniform(0.0, 2.0);
            addUprightBox(scene, firstBlock + number++ % kColors, {aside, 0.5 * height, ahead},
                          {width, height, length}, turn);
            addUprightBox(scene, post, {side * 4.5, 1.5, z}, {0.12, 3.0, 0.12});
        }
    }
}

void addCubesInTheWay(scene::Scene& scene) {
    constexpr std::array kPlaces{glm::dvec2(-0.9, -3.2), glm::dvec2(0.5, -12.0), glm::dvec2(-1.8, -19.0),
                                 glm::dvec2(2.0, -34.0), glm::dvec2(-1.0, -70.0)};
    std::uint32_t number = 0;
    for (const glm::dvec2& place : kPlaces) {
        const double side = number == 0 ? 0.8 : 1.6;
        addUprightBox(scene, firstBlock + number % 4, {place.x, 0.5 * side, place.y}, glm::dvec3(side),
                      0.5 + number);
        ++number;
    }
}

} // namespace

scene::SceneSetup makeAlley(std::uint64_t seed) {
    Random random(seed);
    scene::SceneSetup setup;
    scene::Scene& scene = setup.scene;
    scene.name = "alley";
    scene.meshes = {scene::makeBox(glm::vec3(0.5f))};
    scene.ambient = glm::vec3(0.35f);
    scene.background = glm::vec3(0.02f, 0.04f, 0.09f);
    scene.lights.push_back(
        {.position = glm::dvec3(300.0, 600.0, 400.0), .color = glm::vec3(0.9f), .halfDistance = 1e4});
    addMaterials(scene);
    addFloor(scene);
    addSides(scene, random);
    addCubesInTheWay(scene);
    constexpr double kFovY = 50.0 * std::numbers::pi / 180.0;
    setup.path =
        scene::stillPath(scene::lookAt({.fovY = kFovY, .nearView = 0.5, .farView = 500.0},
                                       glm::dvec3(0.0, kEyeHeight, 0.0), glm::dvec3(0.0, 1.1, -12.0)));
    return setup;
}

} // namespace cdr::scenes
