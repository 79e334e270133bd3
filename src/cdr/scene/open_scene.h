#pragma once

#include <cdr/scene/generators.h>

#include <cstdint>
#include <string>
#include <vector>

namespace cdr::scene {

/// What openScene() found.
struct OpenedScene {
    StagedScene staged;
    std::vector<std::string> notes; ///< what an importer ignored, one line each
};

/// Opens a generated scene by name (`cubes`, `afc`, `afc-near`, `rotation`, `ladder`, `mixed`, `orbit`) or a
/// `.gltf` / `.glb` file by path. A file is lit and framed so that it fills the picture. base::InputError
/// says what is wrong, with a suggestion.
OpenedScene openScene(const std::string& nameOrPath, std::uint64_t seed);

/// The seed used where none is given.
inline constexpr std::uint64_t kDefaultSeed = 2013;

} // namespace cdr::scene
