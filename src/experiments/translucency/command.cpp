#include <cdr/base/file.h>
#include <cdr/image/codec.h>
#include <cli/commands.h>
#include <cli/console.h>
#include <experiments/columns.h>
#include <experiments/translucency/translucency.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <filesystem>

namespace cdr::cli {

namespace {

constexpr std::size_t kMostRepeats = 10'000;

struct TranslucencyArguments {
    experiments::TranslucencyExperiment experiment;
    std::string size = "640x360";
    std::string mapping = "anchored";
    std::uint64_t memoryMiB = render::TranslucencyOptions{}.mostBytes >> 20u;
    std::filesystem::path folder;
    OutputOptions output;
};

/// Of a result's files.
std::string stemOf(const experiments::TranslucencyResult& result) {
    return fmt::format("{}_{}", nameOf(result.stats.method), result.cascades);
}

experiments::Columns<experiments::TranslucencyResult> translucencyColumns() {
    using Result = experiments::TranslucencyResult;
    using Difference = measure::LayerDifference;
    using Stats = render::TranslucencyStats;
    const experiments::Columns<Difference> differences{
        {.key = "pixels", .value = &Difference::translucent},
        {.key = "max_error", .value = &Difference::largestError, .heading = "max error"},
        {.key = "mean_error", .value = &Difference::meanError, .heading = "mean error", .format = {"{:.3f}"}},
        {.key = "within_one_step",
         .value = &Difference::withinFraction,
         .heading = "within 1/255",
         .format = {"{:.3f} %", 100.0}},
        {.key = "counted_pixels", .value = &Difference::pixels},
        {.key = "miscounted", .value = &Difference::miscounted, .heading = "miscounted"}};
    const experiments::Columns<Stats> stats{{.key = "draws", .value = &Stats::draws, .heading = "draws"},
                                            {.key = "fragments", .value = &Stats::fragments}};
    const auto mebibytes = [](const Result& result) {
        return fmt::format("{:.1f}", static_cast<double>(result.stats.bytes) / 0x1p20);
    };
    return experiments::joined<Result>(
        {{{.key = "method",
           .value = [](const Result& result) { return nameOf(result.stats.method); },
           .heading = "method"},
          {.key = "technique", .value = &Result::technique},
          {.key = "cascades", .value = &Result::cascades, .heading = "cascades"}},
         experiments::columnsOf(&Result::difference, differences),
         experiments::columnsOf(&Result::stats, stats),
         {{.key = "bytes",
           .value = [](const Result& result) { return result.stats.bytes; },
           .heading = "MiB",
           .text = mebibytes},
          {.key = "execute_ms", .value = &Result::executeMs, .heading = "execute ms", .format = {"{:.1f}"}},
          {.key = "note", .value = [](const Result& result) { return result.stats.note; }}}});
}

void writePictures(const std::filesystem::path& folder, const experiments::TranslucencyResults& all) {
    image::writeImage(folder / "truth.png", all.truth);
    for (const experiments::TranslucencyResult& result : all.results) {
        const std::string stem = stemOf(result);
        image::writeImage(folder / (stem + ".png"), result.picture);
        image::writeImage(folder / (stem + "_error.png"),
                          experiments::errorPicture(result.picture, all.truth));
    }
}

void run(const GlobalOptions& global, TranslucencyArguments& arguments) {
    experiments::TranslucencyExperiment& experiment = arguments.experiment;
    const PictureSize size = parseSize(arguments.size);
    experiment.width = size.width;
    experiment.height = size.height;
    experiment.mapping = depth::parseMapping(arguments.mapping);
    experiment.mostBytes = arguments.memoryMiB << 20u;
    requireJsonWritable(arguments.output);
    if (!arguments.folder.empty()) {
        base::makeFolder(arguments.folder);
    }
    const Session session(global);
    const Console console(global, arguments.output);
    const experiments::TranslucencyResults all =
        experiments::runTranslucency(session.device(), experiment, [&](std::size_t done, std::size_t steps) {
            console.progress(done, steps, experiment.scene);
        });
    console.endProgress();
    session.requireSilentValidation();

    const auto columns = translucencyColumns();
    console.table(experiments::tableOf(columns, all.results));
    for (const experiments::TranslucencyResult& result : all.results) {
        if (!result.stats.note.empty()) {
            console.line(fmt::format("{} cascades drawn weighted: {}", result.cascades, result.stats.note));
        }
    }
    console.line(fmt::format("\n{}; {}, {}x{}, mapping {}, {} repeats interleaved, median; errors in 8-bit "
                             "steps of the worst channel, off silhouettes",
                             describe(session.device()), experiment.scene, size.width, size.height,
                             arguments.mapping, experiment.repeats));
    if (!arguments.folder.empty()) {
        writePictures(arguments.folder, all);
    }
    auto document = base::makeDocument("translucency", session.documentDevice(),
                                       {{"scene", experiment.scene},
                                        {"width", size.width},
                                        {"height", size.height},
                                        {"mapping", arguments.mapping},
                                        {"threads", experiment.threads},
                                        {"repeats", experiment.repeats},
                                        {"seed", experiment.seed}});
    for (const experiments::TranslucencyResult& result : all.results) {
        document["results"].push_back(experiments::jsonOf(columns, result));
        if (!arguments.folder.empty()) {
            document["results"].back()["picture"] = stemOf(result) + ".png";
            document["results"].back()["error_picture"] = stemOf(result) + "_error.png";
        }
    }
    writeJson(arguments.output, document);
}

} // namespace

void addTranslucency(CLI::App& program, const GlobalOptions& global) {
    CLI::App* command = program.add_subcommand(
        "translucency", "Translucent surfaces across cascades against a float64 sorted truth");
    auto arguments = std::make_shared<TranslucencyArguments>();
    experiments::TranslucencyExperiment& experiment = arguments->experiment;
    command->add_option("scene", experiment.scene, "Scene with translucent surfaces")->capture_default_str();
    command->add_option("--size", arguments->size, "WIDTHxHEIGHT in pixels")->capture_default_str();
    command->add_option("--depth", arguments->mapping, "Depth mapping of the cascades")
        ->capture_default_str();
    command->add_option("--cascades", experiment.cascades, "How many cascades, a comma between them")
        ->delimiter(',')
        ->capture_default_str();
    command->add_option("--repeats", experiment.repeats, "Timed frames of each; 0 times nothing")
        ->check(CLI::Range(std::size_t{0}, kMostRepeats))
        ->capture_default_str();
    command->add_option("--threads", experiment.threads, "Threads that cull, bin, record and cast the truth")
        ->capture_default_str();
    command->add_option("--translucency-memory", arguments->memoryMiB, "Most MiB for sorted fragments")
        ->check(CLI::Range(std::uint64_t{1}, kMostTranslucencyMiB))
        ->capture_default_str();
    command->add_option("--seed", experiment.seed, "Seed of the scene")->capture_default_str();
    command->add_option("--out", arguments->folder,
                        "Folder for pictures and their errors, eight times as bright");
    addJson(*command, arguments->output);
    command->callback([&global, arguments] { run(global, *arguments); });
}

} // namespace cdr::cli
