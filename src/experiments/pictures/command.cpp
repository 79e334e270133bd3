#include <cdr/base/file.h>
#include <cdr/image/codec.h>
#include <cli/commands.h>
#include <cli/console.h>
#include <experiments/pictures/pictures.h>
#include <experiments/wrong_pixels_columns.h>
#include <scenes/open_scene.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>

namespace cdr::cli {

namespace {

struct PicturesArguments {
    experiments::PicturesOptions options;
    std::string size = "1280x720";
    std::vector<std::string> techniques; ///< all presets when empty
    std::filesystem::path folder = "out";
    OutputOptions output;
};

/// Name of a result's files, without what the kinds of file add.
std::string stemOf(const experiments::PictureResult& result) {
    std::string stem = fmt::format("{}_{}", result.scene, result.technique);
    std::replace(stem.begin(), stem.end(), '/', '-'); // as in "anchored/fitted"
    return stem;
}

experiments::Columns<experiments::PictureResult> pictureColumns() {
    using Result = experiments::PictureResult;
    const auto named = [](const char* suffix) {
        return [suffix](const Result& result) { return stemOf(result) + suffix; };
    };
    return experiments::joined<Result>(
        {{{.key = "scene", .value = &Result::scene, .heading = "scene"},
          {.key = "technique", .value = &Result::technique, .heading = "technique"},
          {.key = "fov_degrees", .value = &Result::fovYDegrees},
          {.key = "frames", .value = &Result::frames, .heading = "frames"}},
         experiments::columnsOf(&Result::wrong,
                                experiments::wrongPixelsColumns({.pixels = "inner pixels",
                                                                 .wrong = "wrong",
                                                                 .share = "wrong share",
                                                                 .overlapShare = "where objects overlap"})),
         {{.key = "flips", .value = &Result::flips},
          {.key = "picture", .value = named(".png")},
          {.key = "heat_map", .value = named("_wrong.png")}}});
}

void run(const GlobalOptions& global, PicturesArguments& arguments) {
    const PictureSize size = parseSize(arguments.size);
    arguments.options.width = size.width;
    arguments.options.height = size.height;
    for (const std::string& name : arguments.techniques) {
        arguments.options.techniques.push_back(depth::namedTechnique(name));
    }
    requireJsonWritable(arguments.output);
    base::makeFolder(arguments.folder);
    const Session session(global);
    const Console console(global, arguments.output);
    const auto results = experiments::runPictures(
        session.device(), arguments.options, [&](std::size_t done, std::size_t all, const std::string& what) {
            console.progress(done, all, what);
        });
    console.endProgress();
    session.requireSilentValidation();

    const std::string device = describe(session.device());
    for (const auto& result : results) {
        const std::string stem = stemOf(result);
        image::writeImage(arguments.folder / (stem + ".png"), result.picture);
        image::writeImage(arguments.folder / (stem + "_wrong.png"), result.heatMap);
    }
    const std::filesystem::path sheet = arguments.folder / "contact_sheet.png";
    image::writeImage(sheet, experiments::makeContactSheet(
                                 results, "cdr pictures: red is wrong, orange wrong on an edge; " +
                                              session.device().info().name));
    const auto columns = pictureColumns();
    console.table(experiments::tableOf(columns, results));
    console.line(fmt::format("\n{}; {} frames a row, seed {}; pictures in {}, all on {}", device,
                             arguments.options.frames, arguments.options.seed, arguments.folder.string(),
                             sheet.string()));

    auto document = base::makeDocument("pictures", session.documentDevice(),
                                       {{"width", size.width},
                                        {"height", size.height},
                                        {"frames", arguments.options.frames},
                                        {"seed", arguments.options.seed}});
    document["results"] = experiments::jsonOf(columns, results);
    writeJson(arguments.output, document);
}

} // namespace

void addPictures(CLI::App& program, const GlobalOptions& global) {
    CLI::App* command = program.add_subcommand(
        "pictures", "One picture per technique with its wrong pixels (Figures 6.1 to 6.3)");
    auto arguments = std::make_shared<PicturesArguments>();
    command->add_option("--out", arguments->folder, "Folder for the pictures")->capture_default_str();
    command->add_option("--scenes", arguments->options.scenes, "Scenes, a comma between them")
        ->delimiter(',')
        ->capture_default_str();
    command
        ->add_option("--techniques", arguments->techniques, "Techniques, a comma between them; all presets")
        ->delimiter(',');
    command->add_option("--size", arguments->size, "WIDTHxHEIGHT in pixels")->capture_default_str();
    command
        ->add_option("--frames", arguments->options.frames, "Frames per scene, spread over its camera path")
        ->check(CLI::Range(1u, kMaxFrames))
        ->capture_default_str();
    command
        ->add_option("--threads", arguments->options.threads,
                     "Threads that cull, bin, record and cast the truth")
        ->capture_default_str();
    command->add_option("--seed", arguments->options.seed, "Seed of the random scenes")
        ->capture_default_str();
    addJson(*command, arguments->output);
    command->callback([&global, arguments] { run(global, *arguments); });
}

} // namespace cdr::cli
