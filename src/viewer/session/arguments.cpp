#include "arguments.h"

#include <CLI/CLI.hpp>
#include <cdr/base/format_error.h>
#include <cdr/image/picture_size.h>
#include <viewer/state/command_line.h>
#include <viewer/window/window.h>

#include <fmt/format.h>
#include <options/deform_choice.h>
#include <options/drawing_options.h>
#include <options/effect_options.h>
#include <options/help_format.h>
#include <options/help_texts.h>
#include <options/number_checks.h>
#include <options/parsed_option.h>
#include <program/build_info.h>

#include <memory>

namespace cdr::viewer {

namespace {

void addViewOptions(CLI::App& program, Arguments& arguments) {
    options::addValue(program, "scene", arguments.settings.scene, options::sceneHelp());
    options::addSeed(program, arguments.settings.seed);
    options::addColours(program, arguments.colours);
    options::addLayers(program, arguments.layers);
    CLI::Option* technique =
        options::addParsed(program, "--technique", arguments.technique, depth::parseTechnique,
                           "Show one picture with this technique: " + options::techniqueHelp());
    options::addParsed(program, "--compare", arguments.compare, parsePair,
                       "Show two techniques with a divider between them")
        ->type_name("LEFT,RIGHT")
        ->default_str(kCompared)
        ->excludes(technique);
    options::addTargets(program, arguments.settings.drawing.targets);
    options::addDepthFormat(program, arguments.format);
    options::addThreads(program, arguments.settings.drawing.threads);
    program.add_flag("--play", arguments.plays, "Play the scene's camera path when the window opens");
}

/// What a line of `cdr render` says besides, as the viewer copies it.
void addRenderLine(CLI::App& program, Arguments& arguments) {
    program.option_defaults()->group("As in cdr render");
    options::addTechniqueParts(program, arguments.parts);
    options::addSubmission(program, arguments.settings.drawing);
    options::addSnapping(program, arguments.settings.drawing.snapping);
    options::addDetail(program, arguments.settings.drawing.detail);
    options::addEffectOptions(program, arguments.settings.drawing, arguments.settings.choice);
    options::addStereoOptions(program, arguments.settings.views);
    options::addParsed(program, "--aov", arguments.settings.view, viewOfAov,
                       "What the picture shows: color, cascade, distance, id or wrong")
        ->default_str("color");
    options::addFile(
        program, "-o,--output", arguments.output,
        "Writes no file. The window starts as render draws it: without panels, in the thesis' colours");
    program.option_defaults()->group("Options");
}

/// What the copied command line says of the camera.
void addPlace(CLI::App& program, Arguments& arguments) {
    program.option_defaults()->group("Camera");
    program.add_option("--frame", arguments.camera.frame,
                       "First frame of the scene's camera path, or of a moving scene");
    options::addCameraOptions(program, arguments.camera);
    options::addSceneChoice(program, arguments.settings.choice);
    options::addAnimationChoice(program, arguments.settings.choice);
    options::addDeform(program, arguments.settings.deform);
    options::addTextureMemory(program, arguments.settings.choice.textureMiB);
    options::addPointRadius(program, arguments.settings.choice.pointRadius);
    program.option_defaults()->group("Options");
}

void addWindowOptions(CLI::App& program, Arguments& arguments) {
    options::addParsed(program, "--size", arguments.size, parseWindowSize,
                       "Size of the window in pixels; with -o, of an eye's picture")
        ->type_name("WIDTHxHEIGHT")
        ->default_str("1280x720 at 96 dots per inch");
    program.add_option("--device", arguments.device, options::kDeviceHelp);
    program.add_flag("--validate", arguments.validate, options::kValidateHelp);
    program.add_flag("--vsync", arguments.waitsForDisplay, "Limit frames to the refresh rate of the display");
    options::addNamed(program, "--unit", arguments.unit, base::parseLengthUnit, options::kUnitHelp);
    program
        .add_option("--ui-scale", arguments.uiScale, "Size of the text, 0.5 to 4; 1 is for 96 dots per inch")
        ->check(options::numberFrom(0.5, 4.0));
}

void addMeasuringOptions(CLI::App& program, Arguments& arguments) {
    program.add_option("--frames", arguments.frames, "Quit after this many frames of the window");
    options::addFile(program, "--screenshot", arguments.screenshot,
                     "Write the window as PNG to FILE on quitting");
    program.add_flag("--statistics", arguments.statistics, "Print frame times on quitting");
}

} // namespace

std::array<depth::Technique, 2> parsePair(std::string_view text) {
    const std::size_t first = text.find(',');
    if (first == std::string_view::npos) {
        throw base::inputError("--compare must be LEFT,RIGHT, not '{}'", text.substr(0, 60));
    }
    for (std::size_t comma = first; comma != std::string_view::npos; comma = text.find(',', comma + 1)) {
        const auto left =
            depth::tryParseTechnique(text.substr(0, comma)); // its parameters may have commas too
        const auto right = depth::tryParseTechnique(text.substr(comma + 1));
        if (left && right) {
            return {*left, *right};
        }
    }
    return {depth::parseTechnique(text.substr(0, first)), depth::parseTechnique(text.substr(first + 1))};
}

PictureExtent parseWindowSize(std::string_view text) {
    const auto size = image::parsePictureSize(text);
    constexpr auto kMax = static_cast<std::uint32_t>(kMaxWindowSide);
    if (!size || size->width > kMax || size->height > kMax) {
        throw base::inputError("size must be WIDTHxHEIGHT, 1 to {}, such as 1280x720, not '{}'",
                               kMaxWindowSide, text.substr(0, 60));
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
    CLI::App program("Show a scene with two depth techniques at once. F1 in the window shows the keys.",
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
