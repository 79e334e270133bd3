#include <cli/commands.h>
#include <experiments/comparison_command.h>
#include <experiments/detail/detail.h>

#include <fmt/format.h>
#include <options/help_texts.h>
#include <options/parsed_option.h>
#include <output/columns.h>
#include <output/readable.h>
#include <program/build_info.h>

#include <string>
#include <vector>

namespace cdr::cli {

namespace {

struct DetailArguments {
    experiments::DetailOptions options;
    scene::GltfChoice choice;
    std::filesystem::path folder;
    std::filesystem::path state;
};

output::Columns<experiments::DetailResult> detailColumns() {
    using Result = experiments::DetailResult;
    const auto othersShare = [](const Result& result) {
        const double share = static_cast<double>(result.otherIds) / static_cast<double>(result.pixels);
        return fmt::format("{} %", output::percent(share));
    };
    return {{.key = "mode", .value = &Result::mode, .heading = "detail"},
            {.key = "frame_ms", .value = &Result::frameMs, .heading = "frame ms"},
            {.key = "record_ms", .value = &Result::recordMs},
            {.key = "execute_ms", .value = &Result::executeMs, .heading = "execute ms"},
            {.key = "execute_speedup", .value = &Result::speedup, .heading = "speed-up"},
            output::intervalColumn(&Result::speedup95),
            {.key = "triangles",
             .value = &Result::triangles,
             .heading = "triangles",
             .format = {"{}"},
             .before = "frame ms"},
            {.key = "flip", .value = &Result::flip, .heading = "FLIP"},
            {.key = "largest_flip", .value = &Result::largestFlip},
            {.key = "pixels", .value = &Result::pixels},
            {.key = "other_ids", .value = &Result::otherIds, .heading = "other objects", .text = othersShare},
            {.key = "cracks", .value = &Result::cracks, .heading = "cracks"}};
}

std::string detailPicture(const std::string& mode) {
    return mode + ".png";
}

std::string cracksName(const std::string& mode) {
    return mode + "_cracks.png";
}

/// The files that are written.
std::vector<std::string> detailFiles() {
    std::vector<std::string> files;
    for (const std::string& mode : experiments::detailModeNames()) {
        files.push_back(detailPicture(mode));
        files.push_back(cracksName(mode));
    }
    return files;
}

void run(Command& command, DetailArguments& arguments) {
    command.measuresTime();
    experiments::DetailOptions& options = arguments.options;
    visibility::requireUsable(visibility::Detail{.mode = visibility::DetailMode::perObject,
                                                 .pixels = options.drawing.detail.pixels});
    const PictureFolder folder(arguments.folder, command.files(), PictureFolder::oneOf(detailFiles()));
    scene::SceneSetup setup = command.openScene(options.scene, options.seed, arguments.choice);
    command.keepUnits(arguments.state);
    const experiments::DetailReport report =
        experiments::runDetail(command.device(), std::move(setup), options,
                               command.progressOf("frames of every level of detail"), command.ranks());
    command.endProgress();
    if (!command.ranks().isFirst()) {
        return;
    }

    const auto columns = detailColumns();
    const depth::Technique& technique = options.drawing.technique;
    command.console().table(output::tableOf(columns, report.results));
    command.console().line(
        fmt::format("\n{}; {} of {} triangles, {} levels and {} clusters made in {} ms; {} frames, {}x{}, {} "
                    "pixels of error, {} {}, {} threads; commit {}",
                    command.opened().text(), options.scene, report.sceneTriangles, report.meshLevels,
                    report.clusters, output::Readable{report.makeMs}, options.frames, options.drawing.width,
                    options.drawing.height, options.drawing.detail.pixels, nameOf(technique.mapping),
                    nameOf(technique.split), options.drawing.threads, program::buildInfo().commit));
    nlohmann::ordered_json settings = settingsOf(options, arguments.choice);
    settings.update({{"mapping", nameOf(technique.mapping)},
                     {"split", nameOf(technique.split)},
                     {"error_pixels", options.drawing.detail.pixels}});
    auto document = command.makeDocument(std::move(settings));
    for (const auto& result : report.results) {
        auto& row = document["results"].emplace_back(output::jsonOf(columns, result));
        folder.write("picture", detailPicture(result.mode), result.picture, row);
        folder.write("cracks_picture", cracksName(result.mode), result.cracked, row);
    }
    document["scene_triangles"] = report.sceneTriangles;
    document["levels"] = report.meshLevels;
    document["clusters"] = report.clusters;
    document["make_levels_ms"] = report.makeMs;
    command.writeDocument(document);
}

void addOptions(CLI::App& command, DetailArguments& arguments) {
    experiments::DetailOptions& options = arguments.options;
    addComparison(command, options, arguments.choice, arguments.folder);
    addState(command, arguments.state);
    addValue(command, "--pixels", options.drawing.detail.pixels,
             "Largest error on screen of a level of detail, in pixels");
    depth::Technique& technique = options.drawing.technique;
    technique.split = depth::SplitCount{5};
    options::addNamed(command, "--depth", technique.mapping, depth::parseMapping, options::mappingHelp());
    options::addNamed(command, "--split", technique.split, depth::parseSplit, options::kSplitHelp);
}

} // namespace

void addDetail(CLI::App& program, const GlobalOptions& global) {
    addCommand<DetailArguments>(
        program, global, "detail",
        "Measure savings and errors of levels of detail, chosen by object, by cascade (thesis chapter 3) or by cluster",
        addOptions, run, RankUse::all);
}

} // namespace cdr::cli
