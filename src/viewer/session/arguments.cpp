#include "arguments.h"

#include <CLI/CLI.hpp>
#include <cdr/base/error.h>
#include <cdr/image/picture_size.h>
#include <viewer/state/command_line.h>
#include <viewer/window/window.h>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <options/effect_options.h>
#include <options/help_format.h>
#include <options/number_checks.h>
#include <options/parsed_option.h>
#include <program/build_info.h>

#include <memory>

namespace cdr::viewer {

namespace {

void addViewOptions(CLI::App& program, Arguments& arguments) {
    program
        .add_option("scene", arguments.scene,
                    fmt::format("{}, or a .gltf or .glb file", fmt::join(scenes::generatedScenes(), ", ")))
        ->capture_default_str();
    options::addSeed(program, arguments.seed, "Seed of a random scene");
    options::addColours(program, arguments.colours);
    options::addLayers(program, arguments.layers);
    CLI::Option* technique = options::addParsed(
        program, "--technique", arguments.technique, depth::parseTechnique,
        "One picture: a preset (standard, cdr, log, logcdr, reversed, anchored) or mapping/split");
    options::addParsed(program, "--compare", arguments.compare, parsePair,
                       "Two techniques, LEFT,RIGHT, with a divider between them")
        ->default_str(kCompared)
        ->excludes(technique);
    options::addTargets(program, arguments.drawing.targets);
    options::addDepthFormat(program, arguments.format);
    options::addThreads(program, arguments.drawing.threads);
    program.add_flag("--play", arguments.plays, "Follow the scene's camera path from the start");
}

/// What a line of `cdr render` says besides, as the viewer copies it.
void addRenderLine(CLI::App& program, Arguments& arguments) {
    program.option_defaults()->group("As cdr render takes it");
    options::addTechniqueParts(program, arguments.parts);
    options::addSubmission(program, arguments.drawing);
    options::addSnapping(program, arguments.drawing.snapping);
    options::addDetail(program, arguments.drawing.detail);
    options::addEffectOptions(program, arguments.drawing, arguments.choice);
    options::addStereoOptions(program, arguments.views);
    options::addParsed(program, "--aov", arguments.view, viewOfAov,
                       "View: color, cascade, distance, id or wrong")
        ->default_str("color");
    program.add_option("-o,--output", arguments.output,
                       "Not written: the panels hide, and the thesis' colours stay");
    program.option_defaults()->group("Options");
}

/// What the copied command line says of the camera.
void addPlace(CLI::App& program, Arguments& arguments) {
    program.option_defaults()->group("Camera");
    program
        .add_option("--frame", arguments.camera.frame,
                    "Frame at which a moving scene, or its camera path, begins")
        ->check(options::wholeNumber());
    options::addCameraOptions(program, arguments.camera);
    options::addSceneChoice(program, arguments.choice);
    options::addAnimationChoice(program, arguments.choice);
    options::addDeform(program, arguments.deform);
    options::addTextureMemory(program, arguments.choice.textureMiB);
    options::addPointRadius(program, arguments.choice.pointRadius);
    program.option_defaults()->group("Options");
}

void addWindowOptions(CLI::App& program, Arguments& arguments) {
    options::addParsed(program, "--size", arguments.size, parseWindowSize, "WIDTHxHEIGHT of the window")
        ->default_str(fmt::format("{}x{}", arguments.size.width, arguments.size.height));
    program.add_option("--device", arguments.device, "Vulkan device by number or part of its name");
    program.add_flag("--validate", arguments.validate,
                     "Run under the Khronos validation layer; any message is a failure");
    program.add_flag("--vsync", arguments.waitsForDisplay, "Show frames at the display's pace");
    options::addNamed(program, "--unit", arguments.unit, base::parseLengthUnit,
                      "Unit of lengths: auto, um, mm, m, km, or none for scene units");
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

std::array<depth::Technique, 2> parsePair(std::string_view text) {
    const std::size_t comma = text.find(',');
    if (comma == std::string_view::npos) {
        throw base::InputError(fmt::format("--compare must be LEFT,RIGHT, not '{}'", text.substr(0, 60)));
    }
    return {depth::parseTechnique(text.substr(0, comma)), depth::parseTechnique(text.substr(comma + 1))};
}

PictureExtent parseWindowSize(std::string_view text) {
    const auto size = image::parsePictureSize(text);
    constexpr auto kMax = static_cast<std::uint32_t>(kMaxWindowSide);
    if (!size || size->width > kMax || size->height > kMax) {
        throw base::InputError(fmt::format("size must be WIDTHxHEIGHT, 1 to {}, such as 1280x720, not '{}'",
                                           kMaxWindowSide, text.substr(0, 60)));
    }
    return {.width = size->width, .height = size->height};
}

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
    options::takeDecimals(program);
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
