#include <cdr/base/error.h>
#include <cdr/base/suggest.h>
#include <cdr/scene/alley_scene.h>
#include <cdr/scene/boulders.h>
#include <cdr/scene/extreme_scenes.h>
#include <cdr/scene/gltf_stage.h>
#include <cdr/scene/open_scene.h>
#include <cdr/scene/orbit_scene.h>
#include <cdr/scene/sheets_scene.h>

#include <algorithm>
#include <array>

namespace cdr::scene {

namespace {

struct Generator {
    std::string_view name;
    StagedScene (*make)(std::uint64_t seed);
};

constexpr std::array kGenerators{
    Generator{"cubes", [](std::uint64_t seed) { return makeCubes(seed); }},
    Generator{"afc", [](std::uint64_t seed) { return makeAfc(seed); }},
    Generator{"afc-near", [](std::uint64_t seed) { return makeAfcNear(seed); }},
    Generator{"rotation", [](std::uint64_t seed) { return makeRotation(seed); }},
    Generator{"ladder", [](std::uint64_t seed) { return makeLadder(seed); }},
    Generator{"mixed", [](std::uint64_t) { return makeMixed(); }},
    Generator{"boulders", [](std::uint64_t seed) { return makeBoulders(seed); }},
    Generator{"sheets", [](std::uint64_t seed) { return makeSheets(seed); }},
    Generator{"alley", [](std::uint64_t seed) { return makeAlley(seed); }},
    Generator{"orbit", [](std::uint64_t) { return openOrbit(orbitFiles()); }},
};

constexpr auto kNames = [] {
    std::array<std::string_view, kGenerators.size()> names;
    std::transform(kGenerators.begin(), kGenerators.end(), names.begin(),
                   [](const Generator& generator) { return generator.name; });
    return names;
}();

} // namespace

std::span<const std::string_view> generatedScenes() {
    return kNames;
}

OpenedScene openScene(const std::string& nameOrPath, std::uint64_t seed) {
    for (const Generator& generator : kGenerators) {
        if (nameOrPath == generator.name) {
            return {.staged = generator.make(seed), .notes = {}};
        }
    }
    if (isGltfPath(nameOrPath)) {
        return openGltf(nameOrPath);
    }
    throw base::InputError(base::unknownName("scene", nameOrPath, kNames) + ", or a .gltf or .glb file");
}

} // namespace cdr::scene
