#include "scene_options.h"

#include "layer_text.h"
#include "number_checks.h"
#include "parsed_option.h"

#include <CLI/CLI.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace cdr::options {

void addSeed(CLI::App& command, std::uint64_t& seed, const std::string& help) {
    command.add_option("--seed", seed, help)->check(wholeNumber())->capture_default_str();
}

void addColours(CLI::App& command, std::optional<scenes::Colours>& colours) {
    addParsed(command, "--colours", colours, scenes::parseColours,
              "Of a generated scene: thesis (one grey) or bright")
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
            "MATERIAL=LAYER: decides between faces at one place. Those of the material count as nearer by "
            "LAYER scene units; MATERIAL is a name, or #N from 0. May be repeated")
        ->allow_extra_args(false);
}

void addTextureMemory(CLI::App& command, std::optional<std::uint64_t>& textureMiB) {
    command
        .add_option("--texture-memory", textureMiB,
                    "Most MiB of a glTF file's textures, which are shown smaller to fit")
        ->check(CLI::Range(std::uint64_t{1}, scene::kMaxTextureMiB));
}

void addPointRadius(CLI::App& command, std::optional<double>& radius) {
    command
        .add_option(
            "--points", radius,
            "Radius of a glTF file's points and lines, in scene units; else by how far they are apart")
        ->check(numberFrom(scene::kMinPointRadius, scene::kMaxPointRadius));
}

void addSceneChoice(CLI::App& command, scene::GltfChoice& choice) {
    command.add_option("--gltf-scene", choice.scene, "Scene of a glTF file, from 0; its default one");
    command.add_option("--camera", choice.camera,
                       "Look through a glTF scene's camera, from 0; else the view shows all of the scene");
}

void addMoment(CLI::App& command, scene::GltfChoice& choice) {
    command.add_option(
        "--animation", choice.animation,
        "Animation of a glTF file, by name or from 0 (#N where another is named N); with --time the first");
    command.add_option("--time", choice.seconds, "Seconds of the animation; else 0");
}

void addLight(CLI::App& command, scene::GltfChoice& choice, scene::ModelLight otherwise) {
    addParsed(command, "--light", choice.light, scene::parseModelLight,
              fmt::format("Of a glTF file: sky (a computed one), lamps or file (its own lights); else {}",
                          nameOf(otherwise)));
}

void addStillChoice(CLI::App& command, scene::GltfChoice& choice) {
    addSceneChoice(command, choice);
    addMoment(command, choice);
}

void addAnimationChoice(CLI::App& command, scene::GltfChoice& choice) {
    command.add_option(
        "--animation", choice.animation,
        "Animation of a glTF file, by name or from 0 (#N where another is named N); with --time or --fps the "
        "first");
    command.add_option("--time", choice.seconds, "Seconds of the animation at frame 0");
    command.add_option("--fps", choice.framesPerSecond,
                       "Frames of --frames to a second of the animation; else all show one moment");
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
