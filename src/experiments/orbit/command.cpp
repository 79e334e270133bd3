#include <cli/command.h>
#include <cli/commands.h>
#include <cli/picture_folder.h>
#include <experiments/orbit/orbit.h>
#include <experiments/rivals/needs_command.h>
#include <experiments/rivals/row_columns.h>
#include <scenes/orbit/orbit.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <options/parsed_option.h>
#include <output/gnuplot.h>
#include <output/readable.h>
#include <output/wrong_pixels_columns.h>

#include <algorithm>
#include <filesystem>
#include <optional>

namespace cdr::cli {

namespace {

struct OrbitArguments {
    experiments::OrbitOptions options;
    scenes::OrbitFiles files = scenes::orbitFiles();
    std::filesystem::path folder;
    std::filesystem::path plot;
    std::filesystem::path state;
};

constexpr const char* kWindowPicture =
    "orbit_window.png"; ///< what the station's window shows before the zoom

std::string fileName(const experiments::PictureResult& result, const char* suffix) {
    return PictureFolder::nameInFolder("orbit_" + result.technique + suffix);
}

void writePictures(const PictureFolder& folder, const std::vector<experiments::PictureResult>& results,
                   const image::ImageRgba8& window, const std::string& device) {
    if (!window.pixels.empty()) {
        folder.write(kWindowPicture, window);
    }
    for (const experiments::PictureResult& result : results) {
        folder.write(fileName(result, ".png"), result.picture);
        folder.write(fileName(result, "_wrong.png"), result.heatMap);
    }
    folder.write("orbit_sheet.png",
                 experiments::makeContactSheet(
                     results, fmt::format("cdr orbit: paint 5 mm over the runway, seen from "
                                          "420 km through {} degrees; share of wrong pixels, in red; {}",
                                          output::Readable{results.front().fovYDegrees}, device)));
}

/// @param pictures of the last frame that were written.
output::Columns<experiments::OrbitResult>
orbitColumns(const std::vector<experiments::PictureResult>& pictures, std::uint32_t lastFrame) {
    using Result = experiments::OrbitResult;
    const auto named = [&pictures, lastFrame](const char* suffix) {
        return [&pictures, lastFrame, suffix](const Result& result) -> output::Json {
            const auto picture = std::find_if(pictures.begin(), pictures.end(), [&](const auto& each) {
                return result.frame == lastFrame && each.technique == result.technique;
            });
            return picture != pictures.end() ? output::Json(fileName(*picture, suffix)) : output::absent();
        };
    };
    return output::joined<Result>(
        {{{.key = "scene", .value = [](const Result&) { return "orbit"; }},
          {.key = "frame", .value = &Result::frame},
          {.key = "fov_degrees", .value = &Result::fovYDegrees},
          {.key = "technique", .value = &Result::technique},
          experiments::rivalColumn(&Result::isRival),
          {.key = "cascades", .value = &Result::cascades}},
         output::columnsOf(&Result::wrong, output::wrongPixelsColumns()),
         {{.key = "picture", .value = named(".png")}, {.key = "heat_map", .value = named("_wrong.png")}}});
}

/// A row per frame, a column per technique.
void printTable(const Console& console, const std::vector<experiments::OrbitResult>& results) {
    std::vector<std::string> header{"frame", "degrees"};
    std::vector<std::vector<std::string>> rows;
    for (const experiments::OrbitResult& result : results) {
        if (result.frame == results.front().frame) {
            header.push_back(result.technique);
        }
        if (rows.empty() || rows.back().front() != std::to_string(result.frame)) {
            rows.push_back(
                {std::to_string(result.frame), fmt::format("{}", output::Readable{result.fovYDegrees})});
        }
        const std::optional<double> wrong = result.wrong.fraction();
        rows.back().push_back(wrong ? fmt::format("{} %", output::percent(*wrong)) : std::string());
    }
    console.table({header, rows});
}

void run(Command& command, OrbitArguments& arguments) {
    experiments::OrbitOptions& options = arguments.options;
    const PictureFolder folder(arguments.folder, command.files(), [](const std::string& name) {
        return name.starts_with("orbit_") && name.ends_with(".png");
    });
    options.keepsPictures = folder.isWanted();
    command.files().mayPlot(arguments.plot);
    command.readsEarth(arguments.files);
    arguments.files.limits = scene::limitsOf(command.modelChoice());
    const scene::OpenedScene opened = scenes::openOrbit(arguments.files);
    const scene::SceneSetup& setup = opened.setup;
    command.note(arguments.files.model.string(), opened.notes);
    command.keepUnits(arguments.state);
    const experiments::OrbitRun result =
        experiments::runOrbit(command.device(), setup, options, command.progress(), command.ranks());
    command.endProgress();
    if (!command.ranks().isFirst()) {
        return;
    }

    const Console& console = command.console();
    const std::string device = command.opened().text();
    printTable(console, result.results);
    printNeeds(console, options.rivalsBeside);
    console.line(fmt::format("\nShare of wrong pixels, except at edges; {}, {}x{}", device,
                             options.drawing.width, options.drawing.height));
    const bool hasWindow = !result.window.pixels.empty();
    if (folder.isWanted()) {
        writePictures(folder, result.last, result.window, command.device().info().name);
        console.line(fmt::format("pictures of {} in {}",
                                 hasWindow ? "the first and the last frame" : "the last frame",
                                 folder.path().string()));
    }
    if (!arguments.plot.empty()) {
        output::writePlot(arguments.plot, experiments::orbitPlot(
                                              result.results, fmt::format("{}x{}, {}", options.drawing.width,
                                                                          options.drawing.height, device)));
    }
    auto document = command.makeDocument({{"width", options.drawing.width},
                                          {"height", options.drawing.height},
                                          {"frames", options.frames},
                                          {"snap_bits", options.drawing.snapBits},
                                          {"instances", setup.scene.instances.size()}});
    if (folder.isWanted()) {
        document["window_picture"] = hasWindow ? output::Json(kWindowPicture) : output::Json(nullptr);
    }
    const auto written = folder.isWanted() ? result.last : std::vector<experiments::PictureResult>();
    document["results"] = output::jsonOf(orbitColumns(written, result.results.back().frame), result.results);
    addNeeds(document, options.rivalsBeside);
    command.writeDocument(document);
}

void addOptions(CLI::App& command, OrbitArguments& arguments) {
    experiments::OrbitOptions& options = arguments.options;
    options::addFolder(
        command, "--data", arguments.files.folder,
        "Folder with earth-blue-marble.jpg and earth-topology.png, which tools/setup.sh downloads");
    options::addFile(command, "--model", arguments.files.model,
                     "Model to park at the airport, .gltf or .glb, instead of the generated aircraft");
    addFrames(command, options.frames, "Frames, spread evenly over the 240 frames of the path", 240);
    addTechniques(command, options.techniques);
    addRivalList(command, options.rivalsBeside, "none");
    addState(command, arguments.state);
    addSize(command, options.drawing.width, options.drawing.height);
    addThreads(command, options.drawing.threads);
    addSnapBits(command, options.drawing.snapBits);
    options::addFolder(
        command, "--out", arguments.folder,
        "Folder for pictures of the first and the last frame, their wrong pixels, and one sheet of all");
    addPlot(command, arguments.plot, "wrong pixels over the field of view");
}

} // namespace

void addOrbit(CLI::App& program, const GlobalOptions& global) {
    addCommand<OrbitArguments>(
        program, global, "orbit",
        "Zoom from a space station to a runway 420 km below, and count the wrong pixels of each technique",
        addOptions, run, RankUse::all);
}

} // namespace cdr::cli
