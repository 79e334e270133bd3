#include <cdr/base/error.h>
#include <cdr/base/suggest.h>
#include <cdr/scene/extreme_scenes.h>
#include <cdr/scene/gltf.h>
#include <cdr/scene/open_scene.h>
#include <cdr/scene/orbit_scene.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string_view>

namespace cdr::scene {

namespace {

constexpr std::array<std::string_view, 7> kGenerated{"cubes",  "afc",   "afc-near", "rotation",
                                                     "ladder", "mixed", "orbit"};

struct Sphere {
    glm::dvec3 centre{0.0};
    double radius = 1.0;
};

/// A sphere around every instance, about the middle of their bounding box.
Sphere boundingSphere(const Instances& instances) {
    if (instances.size() == 0) {
        return {};
    }
    glm::dvec3 low(INFINITY);
    glm::dvec3 high(-INFINITY);
    for (std::size_t i = 0; i < instances.size(); ++i) {
        low = glm::min(low, instances.position(i) - glm::dvec3(instances.radius[i]));
        high = glm::max(high, instances.position(i) + glm::dvec3(instances.radius[i]));
    }
    Sphere sphere{.centre = 0.5 * (low + high), .radius = 0.0};
    for (std::size_t i = 0; i < instances.size(); ++i) {
        sphere.radius = std::max(sphere.radius, glm::distance(sphere.centre, instances.position(i)) +
                                                    static_cast<double>(instances.radius[i]));
    }
    return sphere;
}

/// Lights a model from the front left above, and from behind, and looks at it from the front, a little from
/// above.
StagedScene stageModel(Scene scene) {
    const Sphere bounds = boundingSphere(scene.instances);
    if (bounds.radius <= 0.0 || !std::isfinite(bounds.radius)) {
        throw base::InputError(scene.name + ": the scene has no extent to look at");
    }
    const auto at = [&](double x, double y, double z) {
        return bounds.centre + bounds.radius * glm::dvec3(x, y, z);
    };
    scene.lights.push_back(
        {.position = at(-2.0, 2.5, 3.0), .color = glm::vec3(1.3f), .halfDistance = 6.0 * bounds.radius});
    scene.lights.push_back({.position = at(2.5, 1.0, -2.0),
                            .color = glm::vec3(0.5f, 0.55f, 0.7f),
                            .halfDistance = 6.0 * bounds.radius});
    scene.background = glm::vec3(0.03f, 0.035f, 0.045f);
    const double fovY = 40.0 * std::numbers::pi / 180.0;
    const double distance = 1.02 * bounds.radius / std::sin(0.5 * fovY);
    const Camera lens{.fovY = fovY, .nearView = 0.01 * bounds.radius, .farView = 1000.0 * bounds.radius};
    const double elevation = 0.2;
    const glm::dvec3 offset(0.35 * distance, elevation * distance, 0.0);
    const double forward = std::sqrt(distance * distance - glm::dot(offset, offset));
    const Camera first = lookAt(lens, bounds.centre + offset + glm::dvec3(0.0, 0.0, forward), bounds.centre);
    return {.scene = std::move(scene), .path = stillPath(first)};
}

bool isGltfPath(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension == ".gltf" || extension == ".glb";
}

} // namespace

OpenedScene openScene(const std::string& nameOrPath, std::uint64_t seed) {
    if (nameOrPath == "cubes") {
        return {.staged = makeCubes(seed), .notes = {}};
    }
    if (nameOrPath == "afc") {
        return {.staged = makeAfc(seed), .notes = {}};
    }
    if (nameOrPath == "afc-near") {
        return {.staged = makeAfcNear(seed), .notes = {}};
    }
    if (nameOrPath == "rotation") {
        return {.staged = makeRotation(seed), .notes = {}};
    }
    if (nameOrPath == "ladder") {
        return {.staged = makeLadder(seed), .notes = {}};
    }
    if (nameOrPath == "mixed") {
        return {.staged = makeMixed(), .notes = {}};
    }
    if (nameOrPath == "orbit") {
        return {.staged = openOrbit(orbitFiles()), .notes = {}};
    }
    if (isGltfPath(nameOrPath)) {
        GltfImport import = loadGltf(nameOrPath);
        return {.staged = stageModel(std::move(import.scene)), .notes = std::move(import.ignored)};
    }
    throw base::InputError(base::unknownName("scene", nameOrPath, kGenerated) + ", or a .gltf or .glb file");
}

} // namespace cdr::scene
