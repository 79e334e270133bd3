#include "arguments.h"

#include <CLI/CLI.hpp>
#include <cdr/base/enum_names.h>
#include <cdr/base/error.h>
#include <cdr/host/worker_pool.h>
#include <cdr/render/targets/targets_choice.h>
#include <scenes/open_scene.h>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <options/help_format.h>
#include <options/number_checks.h>
#include <program/build_info.h>

#include <memory>

namespace cdr::viewer {

namespace {

void addViewOptions(CLI::App& program, Arguments& arguments) {
    program
        .add_option("scene", arguments.scene,
                    fmt::format("{}, or a .gltf or .glb file", fmt::join(scenes::generatedScenes(), ", ")))
        ->capture_default_str();
    program.add_option("--seed", arguments.seed, "Seed of a random scene")
        ->check(options::wholeNumber())
        ->capture_default_str();
    options::addColours(program, arguments.colours);
    options::addLayers(program, arguments.layers);
    CLI::Option* technique = program.add_option(
        "--technique", arguments.technique,
        "One picture: a preset (standard, cdr, log, logcdr, reversed, anchored) or mapping/split");
    program
        .add_option("--compare", arguments.compare, "Two techniques, LEFT,RIGHT, with a divider between them")
        ->capture_default_str()
        ->excludes(technique);
    program
        .add_option("--targets", arguments.targets,
                    "How cascades reach the G-buffer, pool as pool:LAYERS too: " +
                        base::listNames(render::kTargetsKinds))
        ->capture_default_str();
    program.add_option("--format", arguments.format, "Depth buffer: d16, d24 or d32f");
    program.add_option("--threads", arguments.threads, "Threads that cull, bin and record")
        ->check(CLI::Range(std::size_t{1}, host::WorkerPool::kMaxThreads))
        ->capture_default_str();
    program.add_flag("--play", arguments.plays, "Follow the scene's camera path from the start");
}

/// What a line of `cdr render` says besides, as the viewer copies it.
void addRenderLine(CLI::App& program, Arguments& arguments) {
    program.option_defaults()->group("As cdr render takes it");
    program.add_option("--depth", arguments.depth, "Depth mapping, instead of a technique");
    program.add_option("--split", arguments.split, "How cascades are cut, instead of a technique");
    program.add_option("--submission", arguments.submission, "secondaries, primaries or gpu-driven")
        ->capture_default_str();
    program.add_option("--batching", arguments.batching, "per-object, push-constants or instanced")
        ->capture_default_str();
    program
        .add_option("--snapping", arguments.snapping, "How vertices get to sub-pixels: by-device or in-plane")
        ->capture_default_str();
    program
        .add_option("--detail", arguments.detail,
                    "none, object[:PIXELS], cascade[:PIXELS] or cluster[:PIXELS]")
        ->capture_default_str();
    options::addEffectOptions(program, arguments.effects);
    options::addStereoOptions(program, arguments.views);
    program.add_option("--aov", arguments.aov, "View: color, cascade, distance, id or wrong")
        ->capture_default_str();
    program.add_option("-o,--output", arguments.output,
                       "Not written: the panels hide, and the thesis' colours stay");
    program.option_defaults()->group("Options");
}

/// What the copied command line says of the camera.
void addPlace(CLI::App& program, Arguments& arguments) {
    program.option_defaults()->group("Camera");
    program.add_option("--frame", arguments.camera.frame, "Frame at which a scene that moves begins")
        ->check(options::wholeNumber());
    options::addCameraOptions(program, arguments.camera);
    options::addSceneChoice(program, arguments.choice);
    options::addAnimationChoice(program, arguments.choice);
    options::addTextureMemory(program, arguments.choice.textureMiB);
    options::addPointRadius(program, arguments.choice.pointRadius);
    program.option_defaults()->group("Options");
}

void addWindowOptions(CLI::App& program, Arguments& arguments) {
    program.add_option("--size", arguments.size, "WIDTHxHEIGHT of the window")->capture_default_str();
    program.add_option("--device", arguments.device, "Vulkan device by number or part of its name");
    program.add_flag("--validate", arguments.validate,
                     "Run under the Khronos validation layer; any message is a failure");
    program.add_flag("--vsync", arguments.waitsForDisplay, "Show frames at the display's pace");
    program
        .add_option("--unit", arguments.unit, "Unit of lengths: auto, um, mm, m, km, or none for scene units")
        ->capture_default_str();
    program.add_option("--ui-scale", arguments.uiScale, "Size of text; 1 is 96 dots per inch")
        ->check(options::numberFrom(0.5, 4.0));
}

void addMeasuringOptions(CLI::App& program, Arguments& arguments) {
    program.add_option("--frames", arguments.frames, "Quit after so many frames of the interface")
        ->check(options::wholeNumber());
    program.add_option("--screenshot", arguments.screenshot, "Write the window as PNG when it quits");
    program.add_flag("--statistics", arguments.statistics, "Print frame times when it quits");
}

} // namespace

void addViewerOptions(CLI::App& program, Arguments& arguments) {
    const program::BuildInfo build = program::buildInfo();
    program.formatter(std::make_shared<options::HelpFormat>());
    program.set_version_flag("--version",
                             fmt::format("{} {} ({})", program.get_name(), build.version, build.commit));
    addViewOptions(program, arguments);
    addPlace(program, arguments);
    addRenderLine(program, arguments);
    addWindowOptions(program, arguments);
    addMeasuringOptions(program, arguments);
}

std::optional<int> parseViewer(int argc, char** argv, Arguments& arguments) {
    CLI::App program("Look at scenes under two depth techniques at once. F1 in the window shows the keys.",
                     "cdr-viewer");
    addViewerOptions(program, arguments);
    arguments.isFirstUse = argc <= 1;
    return parse(program, argc, argv);
}

std::optional<int> parse(CLI::App& program, int argc, char** argv) {
    try {
        program.parse(argc, argv);
    } catch (const CLI::Success& success) {
        return program.exit(success);
    } catch (const CLI::ParseError& error) {
        throw base::InputError(error.what());
    }
    return std::nullopt;
}

} // namespace cdr::viewer
