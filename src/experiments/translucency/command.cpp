#include <cli/command.h>
#include <cli/commands.h>
#include <cli/picture_folder.h>
#include <experiments/translucency/translucency.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <options/help_texts.h>
#include <options/parsed_option.h>
#include <options/scene_options.h>
#include <output/columns.h>
#include <output/readable.h>

#include <filesystem>
#include <string>
#include <vector>

namespace cdr::cli {

namespace {

constexpr std::size_t kMaxRepeats = 10'000;

struct TranslucencyArguments {
    experiments::TranslucencyExperiment experiment;
    scene::GltfChoice choice; ///< the moment of a file's animation
    std::uint64_t memoryMiB = render::TranslucencyOptions{}.maxBytes >> 20u;
    std::filesystem::path folder;
    std::filesystem::path state;
};

constexpr const char* kTruth = "truth.png";

/// Of the files of a method over so many cascades.
std::string stemOf(render::Translucency method, unsigned cascades) {
    return fmt::format("{}_{}", nameOf(method), cascades);
}

std::string stemOf(const experiments::TranslucencyResult& result) {
    return stemOf(result.stats.method, result.cascades);
}

/// The files that may be written.
std::vector<std::string> translucencyFiles(const std::vector<unsigned>& cascades) {
    std::vector<std::string> files{kTruth};
    for (const unsigned count : cascades) {
        for (const render::Translucency method : render::kTranslucencies) {
            files.push_back(stemOf(method, count) + ".png");
            files.push_back(stemOf(method, count) + "_error.png");
        }
    }
    return files;
}

output::Columns<experiments::TranslucencyResult> translucencyColumns() {
    using Result = experiments::TranslucencyResult;
    using Difference = measure::LayerDifference;
    using Stats = render::TranslucencyStats;
    const output::Columns<Difference> differences{
        {.key = "pixels", .value = &Difference::translucent},
        {.key = "max_error", .value = &Difference::largestError, .heading = "max error"},
        {.key = "mean_error", .value = &Difference::meanError, .heading = "mean error"},
        {.key = "within_one_step",
         .value = &Difference::withinFraction,
         .heading = "within 1/255",
         .format = {"{} %", 100.0}},
        {.key = "counted_pixels", .value = &Difference::pixels},
        {.key = "miscounted", .value = &Difference::miscounted, .heading = "miscounted"}};
    const output::Columns<Stats> stats{{.key = "draws", .value = &Stats::draws, .heading = "draws"},
                                       {.key = "fragments", .value = &Stats::fragments}};
    const auto mebibytes = [](const Result& result) {
        return fmt::format("{}", output::Readable{static_cast<double>(result.stats.bytes) / 0x1p20});
    };
    return output::joined<Result>(
        {{{.key = "method",
           .value = [](const Result& result) { return nameOf(result.stats.method); },
           .heading = "method"},
          {.key = "technique", .value = &Result::technique},
          {.key = "cascades", .value = &Result::cascades, .heading = "cascades"}},
         output::columnsOf(&Result::difference, differences),
         output::columnsOf(&Result::stats, stats),
         {{.key = "bytes",
           .value = [](const Result& result) { return result.stats.bytes; },
           .heading = "MiB",
           .text = mebibytes},
          {.key = "execute_ms",
           .value = &Result::executeMs,
           .heading = "execute ms",
           .format = {.missing = "-"}},
          {.key = "note", .value = &Result::note}}});
}

void writePictures(const PictureFolder& folder, const experiments::TranslucencyResults& all) {
    folder.write(kTruth, all.truth);
    for (const experiments::TranslucencyResult& result : all.results) {
        folder.write(stemOf(result) + ".png", result.picture);
        folder.write(stemOf(result) + "_error.png", experiments::errorPicture(result.picture, all.truth));
    }
}

void print(Command& command, const experiments::TranslucencyExperiment& experiment,
           const experiments::TranslucencyResults& all) {
    command.console().table(output::tableOf(translucencyColumns(), all.results));
    for (const experiments::TranslucencyResult& result : all.results) {
        if (result.stats.refusal) {
            command.console().line(
                fmt::format("{} cascades drawn weighted: {}", result.cascades, result.note));
        }
    }
    command.console().line(fmt::format(
        "\n{}; {}, {}x{}, mapping {}, {}; errors in 8-bit steps of the worst channel, except at "
        "silhouettes",
        command.opened().text(), experiment.scene, experiment.width, experiment.height,
        nameOf(experiment.mapping),
        experiment.repeats > 0 ? fmt::format("medians of {} interleaved frames", experiment.repeats)
                               : "no times"));
}

nlohmann::ordered_json documentOf(Command& command, const TranslucencyArguments& arguments,
                                  const experiments::TranslucencyResults& all, const PictureFolder& folder) {
    const experiments::TranslucencyExperiment& experiment = arguments.experiment;
    nlohmann::ordered_json document = command.makeDocument({{"scene", experiment.scene},
                                                            {"width", experiment.width},
                                                            {"height", experiment.height},
                                                            {"mapping", nameOf(experiment.mapping)},
                                                            {"threads", experiment.threads},
                                                            {"repeats", experiment.repeats},
                                                            {"seed", experiment.seed}});
    options::addChoiceJson(document["options"], arguments.choice);
    const auto columns = translucencyColumns();
    for (const experiments::TranslucencyResult& result : all.results) {
        document["results"].push_back(output::jsonOf(columns, result));
        if (folder.isWanted()) {
            document["results"].back()["picture"] = stemOf(result) + ".png";
            document["results"].back()["error_picture"] = stemOf(result) + "_error.png";
        }
    }
    return document;
}

void run(Command& command, TranslucencyArguments& arguments) {
    command.measuresTime();
    experiments::TranslucencyExperiment& experiment = arguments.experiment;
    experiment.maxBytes = arguments.memoryMiB << 20u;
    const PictureFolder folder(arguments.folder, command.files(),
                               PictureFolder::oneOf(translucencyFiles(experiment.cascades)));
    std::vector<std::string> numbers;
    for (const unsigned cascades : experiment.cascades) {
        numbers.push_back(fmt::format("--cascades {}", cascades));
    }
    requireDistinct(numbers);
    experiment.keepsPictures = folder.isWanted();
    const scene::SceneSetup setup = command.openScene(experiment.scene, experiment.seed, arguments.choice);
    command.keepUnits(arguments.state);
    const experiments::TranslucencyResults all = experiments::runTranslucency(
        command.device(), setup, experiment, command.progressOf(experiment.scene), command.ranks());
    command.endProgress();
    if (!command.ranks().isFirst()) {
        return;
    }

    print(command, experiment, all);
    if (folder.isWanted()) { // else there is nothing to write
        writePictures(folder, all);
    }
    command.writeDocument(documentOf(command, arguments, all, folder));
}

void addOptions(CLI::App& command, TranslucencyArguments& arguments) {
    experiments::TranslucencyExperiment& experiment = arguments.experiment;
    addValue(command, "scene", experiment.scene,
             "A generated scene with translucent surfaces, or a .gltf or .glb file");
    options::addMoment(command, arguments.choice);
    addSize(command, experiment.width, experiment.height);
    options::addNamed(command, "--depth", arguments.experiment.mapping, depth::parseMapping,
                      options::mappingHelp());
    addList(command, "--cascades", experiment.cascades,
            "Numbers of cascades to measure, separated by commas");
    addValue(command, "--repeats", experiment.repeats, std::string(kRepeatsHelp) + "; 0 measures no times")
        ->check(CLI::Range(std::size_t{0}, kMaxRepeats));
    addThreads(command, experiment.threads);
    addValue(command, "--translucency-memory", arguments.memoryMiB, options::kTranslucencyMemoryHelp)
        ->check(CLI::Range(std::uint64_t{1}, kMaxTranslucencyMiB));
    addSeed(command, experiment.seed);
    addState(command, arguments.state);
    options::addFolder(command, "--out", arguments.folder,
                       "Folder for the pictures and their errors, at eight times the brightness");
}

} // namespace

void addTranslucency(CLI::App& program, const GlobalOptions& global) {
    addCommand<TranslucencyArguments>(
        program, global, "translucency",
        "Measure the errors of translucent surfaces in several cascades, compared with a float64 reference",
        addOptions, run, RankUse::all);
}

} // namespace cdr::cli
