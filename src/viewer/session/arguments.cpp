#include "arguments.h"

#include <CLI/CLI.hpp>
#include <cdr/base/document.h>
#include <cdr/base/error.h>
#include <scenes/open_scene.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace cdr::viewer {

namespace {

constexpr double kMaxSoakSeconds = 86'400.0;

void addViewOptions(CLI::App& program, Arguments& arguments) {
    program
        .add_option("scene", arguments.scene,
                    fmt::format("{}, or a .gltf or .glb file", fmt::join(scenes::generatedScenes(), ", ")))
        ->capture_default_str();
    program.add_option("--seed", arguments.seed, "Seed of a random scene, and of a soak")
        ->capture_default_str();
    program
        .add_option("--technique", arguments.technique,
                    "Preset (standard, cdr, log, logcdr, reversed, anchored) or mapping/split")
        ->capture_default_str();
    program.add_option("--compare", arguments.compare,
                       "Two techniques, LEFT,RIGHT, with a divider between them");
    program
        .add_option(
            "--targets", arguments.targets,
            "How cascades reach the G-buffer: single, accumulate, pool, pool:LAYERS, layers or one-pass")
        ->capture_default_str();
    program.add_option("--format", arguments.format, "Depth buffer: d16, d24 or d32f");
    program.add_option("--threads", arguments.threads, "Threads that cull, bin and record")
        ->capture_default_str();
    program.add_flag("--play", arguments.plays, "Follow the scene's camera path from the start");
}

void addWindowOptions(CLI::App& program, Arguments& arguments) {
    program.add_option("--size", arguments.size, "WIDTHxHEIGHT of the window")->capture_default_str();
    program.add_option("--device", arguments.device, "Vulkan device by number or part of its name");
    program.add_flag("--validate", arguments.validate,
                     "Run under the Khronos validation layer; any message is a failure");
    program.add_flag("--vsync", arguments.waitsForDisplay, "Show frames at the display's pace");
    program.add_option("--ui-scale", arguments.uiScale, "Size of text; 1 is 96 dots per inch")
        ->check(CLI::Range(0.5, 4.0));
}

void addTestOptions(CLI::App& program, Arguments& arguments) {
    program.add_option("--frames", arguments.frames, "Quit after so many frames of the interface");
    program.add_option("--script", arguments.script, "Play input from FILE, one event a line");
    program.add_option("--screenshot", arguments.screenshot, "Write the window as PNG when it quits");
    program
        .add_option("--soak", arguments.soakSeconds,
                    "Play so many seconds' worth of random input, as fast as frames come, and quit")
        ->check(CLI::Range(1.0, kMaxSoakSeconds));
    program.add_flag("--statistics", arguments.statistics, "Print frame times when it quits");
}

} // namespace

ParsedArguments parseArguments(int argc, char** argv) {
    ParsedArguments parsed;
    CLI::App program("Look at scenes under two depth techniques at once. F1 in the window shows the keys.",
                     "cdr-viewer");
    const base::BuildInfo build = base::buildInfo();
    program.set_version_flag("--version", fmt::format("cdr-viewer {} ({})", build.version, build.commit));
    addViewOptions(program, parsed.arguments);
    addWindowOptions(program, parsed.arguments);
    addTestOptions(program, parsed.arguments);
    try {
        program.parse(argc, argv);
    } catch (const CLI::Success& success) {
        parsed.exitStatus = program.exit(success);
    } catch (const CLI::ParseError& error) {
        throw base::InputError(error.what());
    }
    return parsed;
}

} // namespace cdr::viewer
