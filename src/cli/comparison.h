#pragma once

#include "commands.h"
#include "console.h"

#include <cdr/host/file.h>
#include <cdr/host/worker_pool.h>
#include <cdr/image/codec.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

namespace cdr::cli {

/// What the commands share that draw a scene in several ways, frame by frame: detail, effects and focus.
/// Their experiments' options hold a scene, frames, width, height, threads and seed each; their results a
/// mode and its picture.
struct ComparisonArguments {
    std::string size = "1280x720";
    std::filesystem::path folder; ///< no pictures when empty
    OutputOptions output;
};

/// Adds the positional scene, --frames, --size, --threads, --seed, --out and --json.
template <typename Options>
void addComparison(CLI::App& command, Options& options, ComparisonArguments& arguments) {
    command.add_option("scene", options.scene, options.scene + ", or any scene that render takes")
        ->capture_default_str();
    command.add_option("--frames", options.frames, "Measured frames of every mode")
        ->check(CLI::Range(1u, kMaxFrames))
        ->capture_default_str();
    command.add_option("--size", arguments.size, "WIDTHxHEIGHT in pixels")->capture_default_str();
    command.add_option("--threads", options.threads, "Threads that cull, bin and record")
        ->check(CLI::Range(std::size_t{1}, host::WorkerPool::kMaxThreads))
        ->capture_default_str();
    command.add_option("--seed", options.seed, "Seed of the scene, the orders and the bootstrap")
        ->capture_default_str();
    command.add_option("--out", arguments.folder, "Folder for a picture of every mode");
    addJson(command, arguments.output);
}

/// Completes the options and checks what can be checked before long work. base::InputError.
template <typename Options>
void begin(const ComparisonArguments& arguments, Options& options) {
    const PictureSize size = parseSize(arguments.size);
    options.width = size.width;
    options.height = size.height;
    requireJsonWritable(arguments.output);
    if (!arguments.folder.empty()) {
        host::makeFolder(arguments.folder);
    }
}

/// What a document says of how it was made; the command adds its own.
template <typename Options>
nlohmann::ordered_json settingsOf(const Options& options) {
    return {{"scene", options.scene},   {"width", options.width},     {"height", options.height},
            {"frames", options.frames}, {"threads", options.threads}, {"seed", options.seed}};
}

/// Writes a mode's picture into the folder, if there is one, and its name into the mode's row.
inline void keepPicture(const ComparisonArguments& arguments, const char* key, const std::string& name,
                        const image::ImageRgba8& picture, nlohmann::ordered_json& row) {
    if (!arguments.folder.empty()) {
        image::writeImage(arguments.folder / name, picture);
        row[key] = name;
    }
}

} // namespace cdr::cli
