#include <cdr/base/error.h>
#include <cdr/base/suggest.h>
#include <cdr/scene/gltf/open_gltf.h>
#include <scenes/alley.h>
#include <scenes/boulders.h>
#include <scenes/city.h>
#include <scenes/coplanar.h>
#include <scenes/cubes.h>
#include <scenes/earth/earth.h>
#include <scenes/ladder.h>
#include <scenes/mixed.h>
#include <scenes/open_scene.h>
#include <scenes/orbit/eclipse.h>
#include <scenes/orbit/orbit.h>
#include <scenes/sheets.h>
#include <scenes/terrain.h>
#include <scenes/traffic.h>

#include <algorithm>
#include <array>

namespace cdr::scenes {

namespace {

/// What a generated scene is made of.
enum class Ingredients : std::uint8_t {
    coloured, ///< materials of its own
    grey,     ///< the thesis' one grey, as its first material
    earth     ///< the files of orbitFiles()
};

struct Generator {
    std::string_view name;
    Ingredients ingredients;
    scene::SceneSetup (*make)(std::uint64_t seed);
    scene::OpenedScene (*open)(const OrbitFiles& files) = nullptr; ///< in place of make()
};

constexpr std::array kGenerators{
    Generator{"cubes", Ingredients::grey, [](std::uint64_t seed) { return makeCubes(seed); }},
    Generator{"afc", Ingredients::grey, [](std::uint64_t seed) { return makeAfc(seed); }},
    Generator{"afc-near", Ingredients::grey, [](std::uint64_t seed) { return makeAfcNear(seed); }},
    Generator{"rotation", Ingredients::grey, [](std::uint64_t seed) { return makeRotation(seed); }},
    Generator{"ladder", Ingredients::grey, [](std::uint64_t seed) { return makeLadder(seed); }},
    Generator{"mixed", Ingredients::grey, [](std::uint64_t) { return makeMixed(); }},
    Generator{"boulders", Ingredients::coloured, [](std::uint64_t seed) { return makeBoulders(seed); }},
    Generator{"sheets", Ingredients::coloured, [](std::uint64_t seed) { return makeSheets(seed); }},
    Generator{"alley", Ingredients::coloured, [](std::uint64_t seed) { return makeAlley(seed); }},
    Generator{"city", Ingredients::coloured, [](std::uint64_t seed) { return makeCity(seed); }},
    Generator{"coplanar", Ingredients::coloured, [](std::uint64_t) { return makeCoplanar(); }},
    Generator{"orbit", Ingredients::earth, nullptr, openOrbit},
    Generator{"terrain", Ingredients::coloured, [](std::uint64_t seed) { return makeTerrain(seed); }},
    Generator{
        "eclipse", Ingredients::earth, nullptr,
        [](const OrbitFiles& files) { return scene::OpenedScene{.setup = openEclipse(files), .notes = {}}; }},
    Generator{"earth", Ingredients::earth, nullptr, openEarth},
    Generator{"traffic", Ingredients::grey, [](std::uint64_t seed) { return makeTraffic(seed); }},
};

constexpr auto kNames = [] {
    std::array<std::string_view, kGenerators.size()> names;
    std::ranges::transform(kGenerators, names.begin(), &Generator::name);
    return names;
}();

bool isOf(std::string_view name, Ingredients ingredients) {
    return std::any_of(kGenerators.begin(), kGenerators.end(), [&](const Generator& generator) {
        return generator.name == name && generator.ingredients == ingredients;
    });
}

} // namespace

std::span<const std::string_view> generatedScenes() {
    return kNames;
}

bool readsEarth(std::string_view scene) {
    return isOf(scene, Ingredients::earth);
}

bool isGreyInThesis(std::string_view scene) {
    return isOf(scene, Ingredients::grey);
}

scene::OpenedScene openScene(const std::string& nameOrPath, std::uint64_t seed,
                             const scene::GltfChoice& choice, const scene::ImportProgress& progress) {
    if (scene::isGltfPath(nameOrPath)) {
        return scene::openGltf(nameOrPath, choice, progress);
    }
    scene::GltfChoice ofFiles = choice;
    ofFiles.textureMiB.reset(); // these hold whatever is opened
    ofFiles.pointRadius.reset();
    if (ofFiles != scene::GltfChoice{}) {
        throw base::InputError(
            "--gltf-scene, --camera, --light, --animation, --time and --fps are for .gltf and .glb files, not " +
            nameOrPath);
    }
    for (const Generator& generator : kGenerators) {
        if (nameOrPath != generator.name) {
            continue;
        }
        if (generator.open == nullptr) {
            return {.setup = generator.make(seed), .notes = {}};
        }
        OrbitFiles files = orbitFiles();
        files.limits = scene::limitsOf(choice);
        return generator.open(files);
    }
    throw base::InputError(base::unknownName("scene", nameOrPath, kNames) + ", or a .gltf or .glb file");
}

scene::GltfChoice shownChoice(const std::string& nameOrPath, scene::GltfChoice choice) {
    if (!choice.light && scene::isGltfPath(nameOrPath)) {
        choice.light = scene::ModelLight::sky;
    }
    return choice;
}

} // namespace cdr::scenes
