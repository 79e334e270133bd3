#pragma once

#include <cdr/scene/gltf/open_gltf.h>
#include <scenes/colours.h>
#include <scenes/layer_choice.h>

#include <nlohmann/json_fwd.hpp>
#include <options/cli_app.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cdr::options {

/// What --layer was given.
struct LayerArguments {
    std::vector<std::string> texts;
    std::vector<scenes::LayerChoice> choices; ///< what each text means
};

/// Adds --seed.
void addSeed(CLI::App& command, std::uint64_t& seed);
/// Adds --texture-memory.
void addTextureMemory(CLI::App& command, std::optional<std::uint64_t>& textureMiB);
/// Adds --points.
void addPointRadius(CLI::App& command, std::optional<double>& radius);
/// Adds --gltf-scene and --camera.
void addSceneChoice(CLI::App& command, scene::GltfChoice& choice);
/// Adds --animation and --time, for a command that shows one moment.
void addMoment(CLI::App& command, scene::GltfChoice& choice);
/// Adds --light.
/// @param otherwise what the command takes where none is told, for the help.
void addLight(CLI::App& command, scene::GltfChoice& choice, scene::ModelLight otherwise);
/// Adds what addSceneChoice() and addMoment() add, for a command that shows one moment of a file.
void addStillChoice(CLI::App& command, scene::GltfChoice& choice);
/// Adds --animation, --time and --fps.
void addAnimationChoice(CLI::App& command, scene::GltfChoice& choice);
/// What the options of a JSON have of a choice: gltf_scene, camera, light, animation, time and fps, where they are told.
void addChoiceJson(nlohmann::ordered_json& options, const scene::GltfChoice& choice);
/// Adds --layer.
void addLayers(CLI::App& command, LayerArguments& layers);
/// Adds --colours. Help shows a default where there is one.
void addColours(CLI::App& command, std::optional<scenes::Colours>& colours);

} // namespace cdr::options
