#pragma once

#include <cli/command.h>
#include <cli/picture_folder.h>

#include <filesystem>

namespace cdr::cli {

/// Adds the options of the commands that draw a scene in several ways, frame by frame (detail, effects and focus). They are
/// the positional scene, what of a glTF file is shown, --frames, --size, --threads, --seed and --out.
template <typename Options>
void addComparison(CLI::App& command, Options& options, scene::GltfChoice& choice,
                   std::filesystem::path& folder) {
    command.add_option("scene", options.scene, options.scene + ", or any scene that render takes")
        ->capture_default_str();
    options::addStillChoice(command, choice);
    options::addLight(command, choice, scene::ModelLight::lamps);
    addFrames(command, options.frames, "Measured frames of every mode");
    addSize(command, options.width, options.height);
    addThreads(command, options.threads, "Threads that cull, bin and record");
    addSeed(command, options.seed, "Seed of the scene, the orders and the bootstrap");
    command.add_option("--out", folder, "Folder for a picture of every mode");
}

/// What their documents say of how they were made; the command adds its own.
template <typename Options>
nlohmann::ordered_json settingsOf(const Options& options, const scene::GltfChoice& choice) {
    nlohmann::ordered_json settings{{"scene", options.scene},     {"width", options.width},
                                    {"height", options.height},   {"frames", options.frames},
                                    {"threads", options.threads}, {"seed", options.seed}};
    options::addChoiceJson(settings, choice);
    return settings;
}

} // namespace cdr::cli
