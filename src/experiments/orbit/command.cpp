#include <cdr/base/file.h>
#include <cdr/image/codec.h>
#include <cli/commands.h>
#include <cli/console.h>
#include <experiments/gnuplot.h>
#include <experiments/orbit/orbit.h>
#include <experiments/wrong_pixels_columns.h>
#include <scenes/orbit/orbit.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>

namespace cdr::cli {

namespace {

struct OrbitArguments {
    experiments::OrbitOptions options;
    scenes::OrbitFiles files = scenes::orbitFiles();
    std::string size = "1280x720";
    std::vector<std::string> techniques; ///< all presets when empty
    std::filesystem::path folder;
    std::filesystem::path plot;
    OutputOptions output;
};

std::string fileName(const experiments::PictureResult& result) {
    std::string technique = result.technique;
    std::replace(technique.begin(), technique.end(), '/', '-'); // as in "anchored/fitted"
    return "orbit_" + technique;
}

void writePictures(const std::filesystem::path& folder,
                   const std::vector<experiments::PictureResult>& results, const std::string& device) {
    for (const experiments::PictureResult& result : results) {
        image::writeImage(folder / (fileName(result) + ".png"), result.picture);
        image::writeImage(folder / (fileName(result) + "_wrong.png"), result.heatMap);
    }
    image::writeImage(folder / "orbit_sheet.png",
                      experiments::makeContactSheet(
                          results, fmt::format("cdr orbit: paint 5 mm over the runway, seen from 420 km "
                                               "through {:.3g} degrees; red is wrong; {}",
                                               results.front().fovYDegrees, device)));
}

/// @param pictures of the last frame that were written.
experiments::Columns<experiments::OrbitResult>
orbitColumns(const std::vector<experiments::PictureResult>& pictures, std::uint32_t lastFrame) {
    using Result = experiments::OrbitResult;
    const auto named = [&pictures, lastFrame](const char* suffix) {
        return [&pictures, lastFrame, suffix](const Result& result) -> experiments::Json {
            const auto picture = std::find_if(pictures.begin(), pictures.end(), [&](const auto& each) {
                return result.frame == lastFrame && each.technique == result.technique;
            });
            return picture != pictures.end() ? experiments::Json(fileName(*picture) + suffix)
                                             : experiments::absent();
        };
    };
    return experiments::joined<Result>(
        {{{.key = "scene", .value = [](const Result&) { return "orbit"; }},
          {.key = "frame", .value = &Result::frame},
          {.key = "fov_degrees", .value = &Result::fovYDegrees},
          {.key = "technique", .value = &Result::technique},
          {.key = "cascades", .value = &Result::cascades}},
         experiments::columnsOf(&Result::wrong, experiments::wrongPixelsColumns()),
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
            rows.push_back({std::to_string(result.frame), fmt::format("{:.4f}", result.fovYDegrees)});
        }
        rows.back().push_back(fmt::format("{:.4f} %", 100.0 * result.wrong.fraction()));
    }
    console.table({header, rows});
}

void run(const GlobalOptions& global, OrbitArguments& arguments) {
    const PictureSize size = parseSize(arguments.size);
    arguments.options.width = size.width;
    arguments.options.height = size.height;
    for (const std::string& name : arguments.techniques) {
        arguments.options.techniques.push_back(depth::namedTechnique(name));
    }
    requireJsonWritable(arguments.output);
    if (!arguments.plot.empty()) {
        experiments::requirePlottable(arguments.plot);
    }
    const scene::SceneSetup setup = scenes::openOrbit(arguments.files);
    if (!arguments.folder.empty()) {
        base::makeFolder(arguments.folder);
    }
    const Session session(global);
    const Console console(global, arguments.output);
    const experiments::OrbitRun result =
        experiments::runOrbit(session.device(), setup, arguments.options,
                              [&](std::size_t done, std::size_t all, const std::string& what) {
                                  console.progress(done, all, what);
                              });
    console.endProgress();
    session.requireSilentValidation();

    printTable(console, result.results);
    console.line(fmt::format("\nshare of wrong pixels off edges; {}, {}x{}", describe(session.device()),
                             size.width, size.height));
    if (!arguments.folder.empty()) {
        writePictures(arguments.folder, result.last, session.device().info().name);
        console.line(fmt::format("pictures of the last frame in {}", arguments.folder.string()));
    }
    if (!arguments.plot.empty()) {
        experiments::writePlot(
            arguments.plot,
            experiments::orbitPlot(result.results, fmt::format("{}x{}, {}", size.width, size.height,
                                                               describe(session.device()))));
    }
    auto document = base::makeDocument("orbit", session.documentDevice(),
                                       {{"width", size.width},
                                        {"height", size.height},
                                        {"frames", arguments.options.frames},
                                        {"instances", setup.scene.instances.size()}});
    const auto written = arguments.folder.empty() ? std::vector<experiments::PictureResult>() : result.last;
    document["results"] =
        experiments::jsonOf(orbitColumns(written, result.results.back().frame), result.results);
    writeJson(arguments.output, document);
}

} // namespace

void addOrbit(CLI::App& program, const GlobalOptions& global) {
    CLI::App* command = program.add_subcommand(
        "orbit", "Zoom from a station's window to a runway 420 km below: which technique reads its numbers");
    auto arguments = std::make_shared<OrbitArguments>();
    command->add_option(
        "--data", arguments->files.folder,
        "Folder of earth-blue-marble.jpg and earth-topology.png; tools/setup.sh fetches them");
    command->add_option("--model", arguments->files.model,
                        "A .gltf or .glb file to park at the airport instead of the generated aircraft");
    command->add_option("--frames", arguments->options.frames, "Frames, spread over the path of 240")
        ->check(CLI::Range(1u, 240u))
        ->capture_default_str();
    command
        ->add_option("--techniques", arguments->techniques, "Techniques, a comma between them; all presets")
        ->delimiter(',');
    command->add_option("--size", arguments->size, "WIDTHxHEIGHT in pixels")->capture_default_str();
    command
        ->add_option("--threads", arguments->options.threads,
                     "Threads that cull, bin, record and cast the truth")
        ->capture_default_str();
    command->add_option("--out", arguments->folder,
                        "Folder for pictures of the last frame, what is wrong in them, and all on one sheet");
    command->add_option("--plot", arguments->plot,
                        "Draw wrong pixels over the lens into a .png or .svg file (needs gnuplot)");
    addJson(*command, arguments->output);
    command->callback([&global, arguments] { run(global, *arguments); });
}

} // namespace cdr::cli
