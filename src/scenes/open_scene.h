#pragma once

#include <cdr/scene/gltf/import_progress.h>
#include <cdr/scene/gltf/open_gltf.h>
#include <cdr/scene/scene_setup.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace cdr::scenes {

/// Names of the scenes that need no file.
std::span<const std::string_view> generatedScenes();

/// Whether it is a generated scene that shows the Earth, from the files of orbitFiles().
bool readsEarth(std::string_view scene);
/// Whether it is a generated scene that the thesis has in one grey, which paint() can paint.
bool isGreyInThesis(std::string_view scene);

/// Opens one of generatedScenes(), or a `.gltf` / `.glb` file by path. A file is lit and framed so that it
/// fills the picture. base::InputError says what is wrong, with a suggestion.
/// @param choice what of a file is shown; refused for a generated scene, except for its textureMiB and pointRadius,
///        which hold for the model that orbitFiles() may name.
/// @param progress told how much of a file has been imported.
scene::OpenedScene openScene(const std::string& nameOrPath, std::uint64_t seed,
                             const scene::GltfChoice& choice = {},
                             const scene::ImportProgress& progress = {});

/// The seed used where none is given.
inline constexpr std::uint64_t kDefaultSeed = 2013;

/// A choice for pictures to look at, not to measure: models are lit by a sky unless it says otherwise.
scene::GltfChoice shownChoice(const std::string& nameOrPath, scene::GltfChoice choice);

} // namespace cdr::scenes
