#pragma once

#include <cli/command.h>
#include <cli/picture_folder.h>

#include <options/help_texts.h>
#include <options/parsed_option.h>

#include <filesystem>

namespace cdr::cli {

/// Adds the options of the commands that draw a scene in several ways, frame by frame (detail, effects and focus). They are
/// the positional scene, what of a glTF file is shown, --frames, --size, --threads, --seed and --out.
template <typename Options>
void addComparison(CLI::App& command, Options& options, scene::GltfChoice& choice,
                   std::filesystem::path& folder) {
    addValue(command, "scene", options.scene, options::sceneHelp());
    options::addStillChoice(command, choice);
    options::addLight(command, choice, scene::ModelLight::lamps);
    addFrames(command, options.frames, "Measured frames of each mode");
    addSize(command, options.drawing.width, options.drawing.height);
    addThreads(command, options.drawing.threads);
    addSeed(command, options.seed);
    options::addFolder(command, "--out", folder, "Folder for a picture of each mode");
}

/// What their documents say of how they were made; the command adds its own.
template <typename Options>
nlohmann::ordered_json settingsOf(const Options& options, const scene::GltfChoice& choice) {
    nlohmann::ordered_json settings{
        {"scene", options.scene},   {"width", options.drawing.width},     {"height", options.drawing.height},
        {"frames", options.frames}, {"threads", options.drawing.threads}, {"seed", options.seed}};
    options::addChoiceJson(settings, choice);
    return settings;
}

} // namespace cdr::cli
