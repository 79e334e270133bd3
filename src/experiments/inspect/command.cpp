#include <cdr/base/format_error.h>
#include <cdr/image/codec.h>
#include <cdr/platform/file.h>
#include <cli/command.h>
#include <cli/commands.h>
#include <cli/exit_status.h>
#include <experiments/inspect/inspect.h>
#include <experiments/inspect/verdict.h>
#include <experiments/inspect/views.h>
#include <experiments/orbit/orbit.h>
#include <scenes/open_scene.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <options/help_texts.h>
#include <options/number_checks.h>
#include <options/parsed_option.h>
#include <output/columns.h>
#include <output/readable.h>
#include <output/sentence_parts.h>
#include <output/wrong_pixels_columns.h>

#include <algorithm>
#include <filesystem>
#include <optional>

namespace cdr::cli {

namespace {

using experiments::Inspection;

constexpr std::uint32_t kMaxViews = 10'000;
constexpr std::size_t kPairsShown = 10;
constexpr std::size_t kPairsWritten = 1000;

struct InspectArguments {
    std::string scene;
    experiments::InspectOptions options;
    depth::DepthFormat format = depth::DepthFormat::d32f;
    options::CameraOptions camera;
    std::uint32_t views = 8;
    scene::GltfChoice choice;
    std::uint64_t seed = scenes::kDefaultSeed;
    std::filesystem::path heatMap;
    std::optional<double> failAbove;
};

/// Spread over the recorded path, over the scene's own, or around a scene that has none.
std::vector<scene::Camera> camerasOf(const scene::SceneSetup& setup, const InspectArguments& arguments) {
    const scene::CameraPath& own = setup.path;
    options::CameraOptions options = arguments.camera;
    options.frames = arguments.views;
    std::vector<scene::Camera> cameras;
    if (!options.path.empty()) {
        const options::FrameCameras recorded(options);
        for (std::uint32_t frame = 0; frame < recorded.frames; ++frame) {
            cameras.push_back(recorded.at(own, frame));
        }
        return cameras;
    }
    const bool isStill = options.eye || options.target || options.direction || arguments.choice.camera;
    if (!isStill && own.frames == 1) {
        return experiments::viewsAround(setup.scene, options::overridden(own.at(0), options), arguments.views,
                                        options.up);
    }
    for (const std::uint32_t frame : experiments::zoomFrames(own.frames, isStill ? 1 : arguments.views)) {
        cameras.push_back(options::overridden(own.at(isStill ? 0 : frame), options));
    }
    return cameras;
}

output::Columns<experiments::InspectedTechnique> techniqueColumns() {
    using Row = experiments::InspectedTechnique;
    const output::CellFormat percent{.pattern = "{} %", .scale = 100.0};
    const auto ofInner = [](double (Row::*share)() const) {
        return [share](const Row& row) {
            return row.wrong.pixels > 0 ? output::Json((row.*share)()) : output::Json(nullptr);
        };
    };
    return output::joined<Row>(
        {{{.key = "technique", .value = &Row::name, .heading = "technique"},
          {.key = "format",
           .value = [](const Row& row) { return nameOf(row.technique.format); },
           .heading = "format"},
          {.key = "cascades", .value = &Row::cascades, .heading = "cascades"},
          {.key = "predicted_fraction",
           .value = ofInner(&Row::predictedFraction),
           .heading = "predicted wrong",
           .format = percent},
          {.key = "undecided_fraction",
           .value = ofInner(&Row::undecidedFraction),
           .heading = "undecided",
           .format = percent,
           .before = "measured wrong"}},
         output::columnsOf(&Row::wrong, output::wrongPixelsColumns({.share = "measured wrong"})),
         {{.key = "judged", .value = &Row::isJudged}}});
}

output::Columns<experiments::ObjectPair> pairColumns(const scene::Scene& scene, base::LengthUnit unit) {
    using Pair = experiments::ObjectPair;
    const auto name = [&scene](std::uint32_t Pair::*object) {
        return [&scene, object](const Pair& pair) { return experiments::nameOfObject(scene, pair.*object); };
    };
    const auto verdict = [](const Pair& pair) {
        return pair.isCoplanar() ? "coplanar" : pair.isSunk ? "sunk" : "";
    };
    return {{.key = "front", .value = name(&Pair::front), .heading = "in front"},
            {.key = "back", .value = name(&Pair::back), .heading = "behind it"},
            {.key = "front_index", .value = &Pair::front},
            {.key = "back_index", .value = &Pair::back},
            {.key = "pixels", .value = &Pair::pixels, .heading = "pixels"},
            {.key = "coplanar_pixels", .value = &Pair::coplanar},
            {.key = "gap", .value = &Pair::gapView, .heading = "gap", .format = {.unit = unit}},
            {.key = "at", .value = &Pair::atView, .heading = "at", .format = {.unit = unit}},
            {.key = "widest_gap", .value = &Pair::widestGapView},
            {.key = "finding", .value = verdict, .heading = "finding"}};
}

void print(const Command& command, const InspectArguments& arguments, const Inspection& inspection,
           const scene::Scene& scene) {
    const Console& console = command.console();
    std::vector<experiments::ObjectPair> shown = inspection.pairs;
    shown.resize(std::min(shown.size(), kPairsShown));
    const base::LengthUnit unit = command.unit();
    if (!shown.empty()) {
        console.line(fmt::format("{} of {} pairs of objects, nearest to each other first:", shown.size(),
                                 inspection.pairs.size()));
        console.table(output::tableOf(pairColumns(scene, unit), shown));
        console.line("");
    }
    console.table(output::tableOf(techniqueColumns(), inspection.techniques));
    console.line("");
    for (const std::string& line : experiments::explain(inspection, scene, [unit](double view) {
             return base::quantityText(view, unit, base::NumberStyle::plain);
         })) {
        console.line(line);
    }
    if (arguments.failAbove) {
        console.line(fmt::format(
            "{}: of the object pixels, {} % are wrong and {} % coplanar; at most {} % are allowed. Other pixels at edges are "
            "not judged and count as right.",
            nameOf(inspection.techniques[inspection.judged]), output::percent(inspection.wrongFraction()),
            output::percent(inspection.coplanarFraction()), output::percent(*arguments.failAbove)));
    }
}

void addResults(nlohmann::ordered_json& document, const Inspection& inspection, const scene::Scene& scene) {
    document["results"] = output::jsonOf(techniqueColumns(), inspection.techniques);
    std::vector<experiments::ObjectPair> written = inspection.pairs;
    written.resize(std::min(written.size(), kPairsWritten));
    document["pairs_found"] = inspection.pairs.size();
    document["pairs"] = output::jsonOf(pairColumns(scene, base::LengthUnit::none), written);
    document["coplanar_fraction"] = inspection.objectPixels > 0
                                        ? nlohmann::ordered_json(inspection.coplanarFraction())
                                        : nlohmann::ordered_json(nullptr);
    document["simplest"] =
        inspection.simplest ? output::jsonOf(techniqueColumns(), inspection.techniques[*inspection.simplest])
                            : nlohmann::ordered_json(nullptr);
    document["advice"] = experiments::explain(inspection, scene);
    document["advice_parts"] =
        output::sentenceParts(experiments::explain(inspection, scene, output::markedLength));
}

void run(Command& command, InspectArguments& arguments) {
    experiments::InspectOptions& options = arguments.options;
    options.allowedShare = arguments.failAbove.value_or(0.0);
    options.judged.technique.format = arguments.format;
    if (!arguments.heatMap.empty()) {
        if (platform::lowerExtension(arguments.heatMap) != ".png") {
            throw base::inputError("--heat-map: {} does not end in .png", arguments.heatMap.string());
        }
        command.files().writes("--heat-map", arguments.heatMap);
    }
    if (!arguments.camera.path.empty()) {
        command.reads(arguments.camera.path);
    }
    const scene::SceneSetup setup = command.openScene(arguments.scene, arguments.seed, arguments.choice);
    const std::vector<scene::Camera> cameras = camerasOf(setup, arguments);
    const Inspection inspection =
        experiments::runInspect(command.device(), setup.scene, cameras, options, command.progress());
    command.endProgress();

    print(command, arguments, inspection, setup.scene);
    command.console().line(fmt::format("\n{}; {} views of {}x{}", command.opened().text(), cameras.size(),
                                       options.drawing.width, options.drawing.height));
    if (!arguments.heatMap.empty()) {
        image::writeImage(arguments.heatMap, inspection.heatMap);
    }
    const bool fails =
        arguments.failAbove && (inspection.badFraction() > *arguments.failAbove || !inspection.couldJudge());
    auto document = command.makeDocument({{"scene", arguments.scene},
                                          {"views", cameras.size()},
                                          {"width", options.drawing.width},
                                          {"height", options.drawing.height},
                                          {"seed", arguments.seed},
                                          {"snap_bits", options.drawing.snapBits},
                                          {"snapping", nameOf(options.drawing.snapping)},
                                          {"technique", options.judged.name},
                                          {"format", nameOf(options.judged.technique.format)}});
    options::addChoiceJson(document["options"], arguments.choice);
    addResults(document, inspection, setup.scene);
    document["fail_above"] = arguments.failAbove;
    document["fails"] = fails;
    command.writeDocument(document);
    if (fails) {
        throw ExitStatus(ExitStatus::kFound);
    }
}

void addOptions(CLI::App& command, InspectArguments& arguments) {
    experiments::InspectOptions& options = arguments.options;
    command.add_option("scene", arguments.scene, options::sceneHelp())->required();
    options.judged = depth::namedTechnique("reversed");
    options::addParsed(command, "--technique", options.judged, depth::namedTechnique,
                       "Technique for --fail-above and --heat-map: " + options::techniqueHelp())
        ->default_str(options.judged.name)
        ->check(options::namesOne("technique"));
    options::addNamed(command, "--format", arguments.format, depth::parseDepthFormat,
                      "Format of the depth buffer for --technique: d16, d24 or d32f");
    addTechniques(command, options.techniques);
    addValue(command, "--frames", arguments.views,
             "Views, spread evenly over the camera path; around the model if it has none")
        ->check(CLI::Range(1u, kMaxViews));
    options::addCameraOptions(command, arguments.camera);
    options::addStillChoice(command, arguments.choice);
    command
        .add_option(
            "--fail-above", arguments.failAbove,
            "Exit with status 3 if a larger share of the pixels that show an object, 0 to 1, is wrong or "
            "coplanar, or if no view shows a surface to judge by; other pixels at edges are not judged and count as right")
        ->check(options::numberFrom(0.0, 1.0));
    options::addFile(
        command, "--heat-map", arguments.heatMap,
        "Write the worst view to FILE, .png: red is wrong, orange wrong at an edge, magenta coplanar");
    addSize(command, options.drawing.width, options.drawing.height);
    addThreads(command, options.drawing.threads);
    addSeed(command, arguments.seed);
    addSnapBits(command, options.drawing.snapBits);
    addSnapping(command, options.drawing.snapping);
}

} // namespace

void addInspect(CLI::App& program, const GlobalOptions& global) {
    addCommand<InspectArguments>(
        program, global, "inspect",
        "Name the objects of a scene that are too close together, and the simplest technique that draws them right",
        addOptions, run);
}

} // namespace cdr::cli
