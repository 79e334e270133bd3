#include "scene_options.h"

#include "help_texts.h"
#include "layer_text.h"
#include "number_checks.h"
#include "parsed_option.h"

#include <CLI/CLI.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace cdr::options {

void addSeed(CLI::App& command, std::uint64_t& seed) {
    addValue(command, "--seed", seed, "Seed of all random numbers");
}

void addColours(CLI::App& command, std::optional<scenes::Colours>& colours) {
    addParsed(command, "--colours", colours, scenes::parseColours,
              "Colours of a generated scene: thesis (one grey) or bright")
        ->default_str(colours ? std::string(nameOf(*colours)) : "");
}

void addLayers(CLI::App& command, LayerArguments& layers) {
    command
        .add_option_function<std::vector<std::string>>(
            "--layer",
            [&layers](const std::vector<std::string>& texts) {
                layers.texts = texts;
                for (const std::string& text : texts) {
                    layers.choices.push_back(parseLayer(text));
                }
            },
            "Decides between faces at the same place: those of MATERIAL count as nearer by LAYER scene units. "
            "MATERIAL is a name, or #N for the index N from 0. May be repeated")
        ->type_name("MATERIAL=LAYER")
        ->allow_extra_args(false);
}

void addTextureMemory(CLI::App& command, std::optional<std::uint64_t>& textureMiB) {
    command
        .add_option(
            "--texture-memory", textureMiB,
            "Memory for the textures of a glTF file in MiB: the largest are reduced until all fit. Without "
            "it, more than 1366 MiB are refused")
        ->check(CLI::Range(std::uint64_t{1}, scene::kMaxTextureMiB));
}

void addPointRadius(CLI::App& command, std::optional<double>& radius) {
    command
        .add_option(
            "--points", radius,
            "Radius of a glTF file's points and lines, in scene units; without it, it follows from their extent")
        ->check(numberFrom(scene::kMinPointRadius, scene::kMaxPointRadius));
}

void addSceneChoice(CLI::App& command, scene::GltfChoice& choice) {
    command.add_option("--gltf-scene", choice.scene, "Scene of a glTF file, by its index from 0")
        ->default_str("the file's default scene");
    command.add_option("--camera", choice.camera, kCameraHelp)
        ->default_str("one that shows all of the scene");
}

void addMoment(CLI::App& command, scene::GltfChoice& choice) {
    command.add_option("--animation", choice.animation, kAnimationHelp)
        ->default_str("the first, if --time is given");
    command.add_option("--time", choice.seconds, kTimeHelp)->default_str("0");
}

void addLight(CLI::App& command, scene::GltfChoice& choice, scene::ModelLight otherwise) {
    addParsed(command, "--light", choice.light, scene::parseModelLight, kLightHelp)
        ->default_str(std::string(nameOf(otherwise)));
}

void addStillChoice(CLI::App& command, scene::GltfChoice& choice) {
    addSceneChoice(command, choice);
    addMoment(command, choice);
}

void addAnimationChoice(CLI::App& command, scene::GltfChoice& choice) {
    command.add_option("--animation", choice.animation, kAnimationHelp)
        ->default_str("the first, if --time or --fps is given");
    command.add_option("--time", choice.seconds, "Time in the animation at frame 0, in seconds")
        ->default_str("0");
    command.add_option("--fps", choice.framesPerSecond,
                       "Frames per second of the animation; without it, all frames show the same moment");
}

void addChoiceJson(nlohmann::ordered_json& options, const scene::GltfChoice& choice) {
    const auto add = [&](const char* key, const auto& value) {
        if (value) {
            options[key] = *value;
        }
    };
    add("gltf_scene", choice.scene);
    add("camera", choice.camera);
    if (choice.light) {
        options["light"] = nameOf(*choice.light);
    }
    add("animation", choice.animation);
    add("time", choice.seconds);
    add("fps", choice.framesPerSecond);
}

} // namespace cdr::options
