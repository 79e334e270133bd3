#include <cdr/base/format_error.h>
#include <cli/command.h>
#include <cli/commands.h>
#include <cli/picture_folder.h>
#include <experiments/pictures/pictures.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <options/parsed_option.h>
#include <output/wrong_pixels_columns.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>

namespace cdr::cli {

namespace {

constexpr const char* kSheet = "contact_sheet.png";

struct PicturesArguments {
    experiments::PicturesOptions options;
    std::vector<std::string> scenes{"cubes", "afc"};
    std::filesystem::path folder = "out";
};

/// Name of a result's files, without what the kinds of file add.
std::string stemOf(const experiments::PictureResult& result) {
    std::string stem = fmt::format("{}_{}", result.scene, result.technique);
    std::replace(stem.begin(), stem.end(), '/', '-'); // as in "anchored/fitted"
    return stem;
}

output::Columns<experiments::PictureResult> pictureColumns() {
    using Result = experiments::PictureResult;
    const auto named = [](const char* suffix) {
        return [suffix](const Result& result) { return stemOf(result) + suffix; };
    };
    return output::joined<Result>(
        {{{.key = "scene", .value = &Result::scene, .heading = "scene"},
          {.key = "technique", .value = &Result::technique, .heading = "technique"},
          {.key = "fov_degrees", .value = &Result::fovYDegrees},
          {.key = "frames", .value = &Result::frames, .heading = "frames"}},
         output::columnsOf(&Result::wrong,
                           output::wrongPixelsColumns({.pixels = "inner pixels",
                                                       .wrong = "wrong",
                                                       .share = "wrong share",
                                                       .overlapShare = "where objects overlap"})),
         {{.key = "flips", .value = &Result::flips},
          {.key = "picture", .value = named(".png")},
          {.key = "heat_map", .value = named("_wrong.png")}}});
}

void writePictures(const PictureFolder& folder, const std::vector<experiments::PictureResult>& results,
                   const std::string& device) {
    for (const auto& result : results) {
        folder.write(stemOf(result) + ".png", result.picture);
        folder.write(stemOf(result) + "_wrong.png", result.heatMap);
    }
    folder.write(kSheet,
                 experiments::makeContactSheet(
                     results, "cdr pictures: share of wrong pixels; red is wrong, orange wrong on an edge; " +
                                  device));
}

/// Which files of a folder may be one of the pictures, by their names. What scenes are called is not known yet.
std::function<bool(const std::string& name)> writtenBy(const std::vector<depth::NamedTechnique>& techniques) {
    std::vector<std::string> ends;
    for (const depth::NamedTechnique& technique : techniques) {
        ends.push_back(PictureFolder::nameInFolder("_" + technique.name + ".png"));
        ends.push_back(PictureFolder::nameInFolder("_" + technique.name + "_wrong.png"));
    }
    return [ends](const std::string& name) {
        return name == kSheet ||
               std::ranges::any_of(ends, [&](const std::string& end) { return name.ends_with(end); });
    };
}

/// base::InputError for scenes or techniques whose pictures would have one name.
std::vector<scene::SceneSetup> openScenes(Command& command, const PicturesArguments& arguments) {
    std::map<std::string, std::string> stems;
    const auto require = [&](const std::string& stem, const std::string& what) {
        const auto [other, isNew] = stems.try_emplace(stem, what);
        if (!isNew) {
            throw base::inputError("{} and {} would both be written as {}", other->second, what, stem);
        }
    };
    std::vector<scene::SceneSetup> scenes;
    for (const std::string& name : arguments.scenes) {
        scenes.push_back(command.openScene(name, arguments.options.seed));
        require(scenes.back().scene.name + "_*.png", name);
    }
    return scenes;
}

void run(Command& command, PicturesArguments& arguments) {
    const experiments::PicturesOptions& options = arguments.options;
    const PictureFolder folder(arguments.folder, command.files(), writtenBy(options.techniques));
    std::vector<scene::SceneSetup> scenes = openScenes(command, arguments);
    const auto results =
        experiments::runPictures(command.device(), std::move(scenes), options, command.progress());
    command.endProgress();

    writePictures(folder, results, command.device().info().name);
    const auto columns = pictureColumns();
    command.console().table(output::tableOf(columns, results));
    command.console().line(fmt::format("\n{}; {} frames per row, seed {}; pictures in {}, all on {}",
                                       command.opened().text(), options.frames, options.seed,
                                       folder.path().string(), (folder.path() / kSheet).string()));
    auto document = command.makeDocument({{"width", options.drawing.width},
                                          {"height", options.drawing.height},
                                          {"frames", options.frames},
                                          {"seed", options.seed},
                                          {"snap_bits", options.drawing.snapBits},
                                          {"snapping", nameOf(options.drawing.snapping)}});
    document["results"] = output::jsonOf(columns, results);
    command.writeDocument(document);
}

void addOptions(CLI::App& command, PicturesArguments& arguments) {
    experiments::PicturesOptions& options = arguments.options;
    options::addFolder(command, "--out", arguments.folder, "Folder for the pictures")->capture_default_str();
    addList(command, "--scenes", arguments.scenes, "Scenes to render, separated by commas");
    addTechniques(command, options.techniques);
    addSize(command, options.drawing.width, options.drawing.height);
    addFrames(command, options.frames, "Frames of each scene, spread evenly over its camera path");
    addThreads(command, options.drawing.threads);
    addSeed(command, options.seed);
    addSnapBits(command, options.drawing.snapBits);
    addSnapping(command, options.drawing.snapping);
}

} // namespace

void addPictures(CLI::App& program, const GlobalOptions& global) {
    addCommand<PicturesArguments>(
        program, global, "pictures",
        "Write a picture of each technique, and its wrong pixels (thesis Figures 6.1 to 6.3)", addOptions,
        run);
}

} // namespace cdr::cli
