#pragma once

#include <CLI/CLI.hpp>
#include <cdr/scene/gltf/open_gltf.h>

#include <cstdint>
#include <string>

namespace cdr::cli {

/// Adds `--gltf-scene` and `--camera`.
void addSceneChoice(CLI::App& command, scene::GltfChoice& choice);

/// scenes::openScene(), or of a glTF file what is chosen. base::InputError when something is chosen of a scene
/// that is no file.
scene::OpenedScene openChosen(const std::string& nameOrPath, std::uint64_t seed,
                              const scene::GltfChoice& choice);

} // namespace cdr::cli
