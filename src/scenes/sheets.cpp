#include "random.h"

#include <cdr/scene/frustum.h>
#include <scenes/sheets.h>

#include <array>
#include <cmath>
#include <numbers>

namespace cdr::scenes {

namespace {

constexpr double kNear = 0.1;
constexpr double kFar = 1e6;
constexpr double kFovY = std::numbers::pi / 3.0;
constexpr double kAspect = 16.0 / 9.0;
constexpr std::uint32_t kCubes = 28;
enum MeshIndex : std::uint32_t { square, box };

/// Where in the view, at distance w; both from -1 to 1 across it.
glm::dvec3 placeInView(double acrossX, double acrossY, double w) {
    const double tanY = scene::frustumOf({.fovY = kFovY}, kAspect, 1.0).tanY;
    return w * glm::dvec3(acrossX * tanY * kAspect, acrossY * tanY, -1.0);
}

/// Turned every way, evenly: Shoemake 1992, Uniform Random Rotations.
glm::dmat3 anyTurn(Random& random) {
    const double share = random.uniform(0.0, 1.0);
    const double a = random.uniform(0.0, 2.0 * std::numbers::pi);
    const double b = random.uniform(0.0, 2.0 * std::numbers::pi);
    const double x = std::sqrt(1.0 - share) * std::sin(a);
    const double y = std::sqrt(1.0 - share) * std::cos(a);
    const double z = std::sqrt(share) * std::sin(b);
    const double w = std::sqrt(share) * std::cos(b);
    return {{1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)},
            {2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)},
            {2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)}};
}

/// Smooth in colour and alpha, so that how finely a device places samples between texels does not show. Without levels,
/// since devices choose between those by rules of their own.
scene::Texture softTexture() {
    scene::Texture texture{
        .name = "soft", .pixels = image::ImageRgba8(64, 64), .levels = scene::TextureLevels::none};
    for (std::uint32_t y = 0; y < 64; ++y) {
        for (std::uint32_t x = 0; x < 64; ++x) {
            const auto wave = [](std::uint32_t i) {
                return 0.5 + 0.5 * std::cos(2.0 * std::numbers::pi * (i + 0.5) / 64.0);
            };
            const auto byte = [](double value) {
                return static_cast<std::uint8_t>(std::lround(255.0 * value));
            };
            texture.pixels.at(x, y) = {byte(0.6 + 0.4 * wave(x)), byte(0.6 + 0.4 * wave(y)), 220,
                                       byte(0.5 + 0.5 * wave(x) * wave(y))};
        }
    }
    return texture;
}

/// The translucent materials: hues at four opacities, textured, unlit, single-sided.
void addTranslucentMaterials(scene::Scene& scene) {
    constexpr std::array kHues{glm::vec3(0.9f, 0.25f, 0.2f),  glm::vec3(0.2f, 0.7f, 0.3f),
                               glm::vec3(0.2f, 0.35f, 0.9f),  glm::vec3(0.9f, 0.75f, 0.2f),
                               glm::vec3(0.6f, 0.25f, 0.85f), glm::vec3(0.25f, 0.75f, 0.8f)};
    constexpr std::array kAlphas{0.25f, 0.5f, 0.35f, 0.75f};
    for (std::uint32_t i = 0; i < 12; ++i) {
        scene::Material material{.name = "translucent " + std::to_string(i),
                                 .baseColorFactor =
                                     glm::vec4(kHues[i % kHues.size()], kAlphas[i % kAlphas.size()]),
                                 .doubleSided = i % 5 != 4,
                                 .unlit = i % 6 == 5,
                                 .alphaMode = scene::AlphaMode::blend};
        if (i % 3 == 1) {
            material.baseColorTexture = 0;
        }
        scene.materials.push_back(material);
    }
}

void addSheets(scene::Scene& scene, Random& random, std::uint32_t sheets) {
    for (std::uint32_t i = 0; i < sheets; ++i) {
        const double w = kNear * std::pow(0.8 * kFar / kNear, (i + random.uniform(0.2, 0.8)) / sheets) * 1.1;
        const bool isBox = i % 8 == 7;
        const double halfSide = w * (isBox ? random.uniform(0.1, 0.25) : random.uniform(0.45, 0.6));
        const glm::mat3 basis(anyTurn(random) * halfSide);
        // One number a line: compilers differ in the order of arguments.
        const double up = random.uniform(-0.7, 0.7);
        const double right = random.uniform(-0.75, 0.75);
        const glm::dvec3 centre = placeInView(right, up, w);
        // Neighbours in distance differ in material; which is drawn first has nothing to do with distance.
        scene::addInstance(scene, isBox ? box : square, (5 * i) % 12, i, centre, basis);
    }
}

void addCubes(scene::Scene& scene, Random& random, std::uint32_t firstObject) {
    const auto firstMaterial = static_cast<std::uint32_t>(scene.materials.size());
    scene.materials.push_back({.name = "white", .baseColorFactor = glm::vec4(0.8f, 0.8f, 0.8f, 1.0f)});
    scene.materials.push_back({.name = "brick", .baseColorFactor = glm::vec4(0.6f, 0.25f, 0.15f, 1.0f)});
    for (std::uint32_t i = 0; i < kCubes; ++i) {
        const double w = kNear * std::pow(kFar / kNear, (i + 2.5) / (kCubes + 2.0));
        const double halfSide = w * random.uniform(0.05, 0.14);
        const glm::mat3 basis(anyTurn(random) * halfSide);
        const double up = random.uniform(-0.9, 0.9);
        const double right = random.uniform(-0.9, 0.9);
        const glm::dvec3 centre = placeInView(right, up, w);
        scene::addInstance(scene, box, firstMaterial + i % 2, firstObject + i, centre, basis);
    }
}

/// The same objects in another order, which has nothing to do with distance.
void shuffle(scene::Instances& instances, Random& random) {
    for (std::size_t i = instances.size(); i > 1; --i) {
        const auto j = static_cast<std::size_t>(random.uniform(0.0, static_cast<double>(i)));
        scene::swapInstances(instances, i - 1, j);
    }
}

} // namespace

scene::Mesh makeSquare(float halfSide) {
    scene::Mesh mesh;
    mesh.name = "square";
    mesh.boundingRadius = halfSide * std::numbers::sqrt2_v<float>;
    for (const glm::vec2 corner : {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)}) {
        mesh.vertices.push_back({.position = glm::vec3(corner * halfSide, 0.0f), .uv = corner * 0.5f + 0.5f});
    }
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

scene::SceneSetup makeSheets(std::uint64_t seed, std::uint32_t sheets) {
    Random random(seed);
    scene::SceneSetup setup;
    scene::Scene& scene = setup.scene;
    scene.name = "sheets";
    scene.meshes = {makeSquare(1.0f), scene::makeBox(glm::vec3(1.0f))};
    scene.textures.push_back(softTexture());
    scene.ambient = glm::vec3(0.3f);
    scene.background = glm::vec3(0.02f, 0.03f, 0.05f);
    // One so far away that it shines alike on everything, one beside the nearest sheets.
    scene.lights.push_back(
        {.position = glm::dvec3(4e6, 6e6, 5e6), .color = glm::vec3(0.8f), .halfDistance = 1e8});
    scene.lights.push_back({.position = glm::dvec3(-0.5, 0.3, -0.6),
                            .color = glm::vec3(0.5f, 0.4f, 0.25f),
                            .halfDistance = 2.0});
    addTranslucentMaterials(scene);
    addSheets(scene, random, sheets);
    addCubes(scene, random, sheets);
    shuffle(scene.instances, random);
    setup.path = scene::stillPath({.fovY = kFovY, .nearView = kNear, .farView = kFar});
    return setup;
}

} // namespace cdr::scenes
