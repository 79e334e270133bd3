#include <cli/commands.h>
#include <experiments/comparison_command.h>
#include <experiments/focus/focus.h>

#include <fmt/format.h>
#include <options/help_texts.h>
#include <options/parsed_option.h>
#include <output/columns.h>
#include <output/readable.h>
#include <program/build_info.h>

#include <string>

namespace cdr::cli {

namespace {

struct FocusArguments {
    experiments::FocusOptions options;
    scene::GltfChoice choice;
    std::filesystem::path folder;
};

output::Columns<experiments::FocusResult> focusColumns() {
    using Result = experiments::FocusResult;
    const auto megapixels = [](const Result& result) {
        return fmt::format("{}", output::Readable{static_cast<double>(result.pixels) / 1e6});
    };
    return {{.key = "mode", .value = &Result::mode, .heading = "lens"},
            {.key = "frame_ms", .value = &Result::frameMs, .heading = "frame ms"},
            {.key = "execute_ms", .value = &Result::executeMs, .heading = "execute ms"},
            {.key = "execute_speedup", .value = &Result::speedup, .heading = "speed-up"},
            output::intervalColumn(&Result::speedup95),
            {.key = "pixels",
             .value = &Result::pixels,
             .heading = "megapixels",
             .text = megapixels,
             .before = "frame ms"},
            {.key = "flip", .value = &Result::flip, .heading = "FLIP"},
            {.key = "rmse", .value = &Result::rmse, .heading = "RMSE"}};
}

output::Columns<experiments::FocusCascade> cascadeColumns() {
    using Cascade = experiments::FocusCascade;
    return {{.key = "near", .value = &Cascade::nearView},
            {.key = "far", .value = &Cascade::farView},
            {.key = "scale", .value = &Cascade::scale}};
}

std::string focusPicture(const std::string& mode) {
    return mode + ".png";
}

void run(Command& command, FocusArguments& arguments) {
    experiments::FocusOptions& options = arguments.options;
    requireUsable(options.lens);
    const PictureFolder folder(arguments.folder, command.files(),
                               PictureFolder::oneOf(experiments::focusModeNames(), focusPicture));
    const scene::SceneSetup setup = command.openScene(options.scene, options.seed, arguments.choice);
    runs::TimedRanks ranks(command.ranks());
    const experiments::FocusReport report = experiments::runFocus(
        command.device(), setup, options, command.progressOf("frames through the lens"), ranks);
    command.endProgress();
    if (!ranks.isFirst()) {
        return;
    }

    const auto columns = focusColumns();
    command.console().table(output::tableOf(columns, report.results));
    for (const auto& cascade : report.cascades) {
        command.console().line(fmt::format(
            "Cascade from {0} to {1}: each pixel covers {2}x{2} of the picture.",
            output::Readable{cascade.nearView}, output::Readable{cascade.farView}, cascade.scale));
    }
    command.console().line(fmt::format(
        "\n{}; {}, {} frames, {}x{}, in focus at {}, lens diameter {}, {} cameras, {}, {} threads; "
        "commit {}",
        command.opened().text(), options.scene, options.frames, options.drawing.width, options.drawing.height,
        options.lens.distance, options.lens.aperture, options.cameras, nameOf(options.mapping),
        options.drawing.threads, program::buildInfo().commit));
    nlohmann::ordered_json settings = settingsOf(options, arguments.choice);
    settings.update({{"mapping", nameOf(options.mapping)},
                     {"split", options.split ? nameOf(*options.split) : "circles"},
                     {"distance", options.lens.distance},
                     {"aperture", options.lens.aperture},
                     {"cameras", options.cameras}});
    auto document = command.makeDocument(std::move(settings));
    for (const auto& result : report.results) {
        auto& row = document["results"].emplace_back(output::jsonOf(columns, result));
        folder.write("picture", focusPicture(result.mode), result.picture, row);
    }
    document["cascades"] = output::jsonOf(cascadeColumns(), report.cascades);
    runs::addMeasuredBy(document, command.ranks(), ranks.measuredBy("frames"));
    command.writeDocument(document);
}

void addOptions(CLI::App& command, FocusArguments& arguments) {
    experiments::FocusOptions& options = arguments.options;
    addComparison(command, options, arguments.choice, arguments.folder);
    addValue(command, "--distance", options.lens.distance, "Distance in focus, in scene units");
    addValue(command, "--aperture", options.lens.aperture, "Diameter of the lens, in scene units");
    addValue(command, "--cameras", options.cameras,
             "Cameras spread over the lens, whose pictures are averaged into the reference")
        ->check(CLI::Range(1u, 4096u));
    options::addNamed(command, "--depth", options.mapping, depth::parseMapping, options::mappingHelp());
    options::addParsed(command, "--split", options.split, depth::parseSplit, options::kSplitHelp)
        ->default_str("where circles of confusion double");
}

} // namespace

void addFocus(CLI::App& program, const GlobalOptions& global) {
    addCommand<FocusArguments>(
        program, global, "focus",
        "Measure what depth of field saves if blurred cascades have fewer pixels, and its errors (thesis chapter 3)",
        addOptions, run, RankUse::timed);
}

} // namespace cdr::cli
