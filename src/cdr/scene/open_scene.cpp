#include <cdr/base/error.h>
#include <cdr/base/suggest.h>
#include <cdr/scene/extreme_scenes.h>
#include <cdr/scene/gltf_stage.h>
#include <cdr/scene/open_scene.h>
#include <cdr/scene/orbit_scene.h>

#include <array>
#include <string_view>

namespace cdr::scene {

namespace {

constexpr std::array<std::string_view, 7> kGenerated{"cubes",  "afc",   "afc-near", "rotation",
                                                     "ladder", "mixed", "orbit"};

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
        return openGltf(nameOrPath);
    }
    throw base::InputError(base::unknownName("scene", nameOrPath, kGenerated) + ", or a .gltf or .glb file");
}

} // namespace cdr::scene
