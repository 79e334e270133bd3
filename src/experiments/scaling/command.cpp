#include <cdr/base/enum_names.h>
#include <cdr/base/format_error.h>
#include <cdr/platform/file.h>
#include <cli/command.h>
#include <cli/commands.h>
#include <experiments/scaling/rank_command.h>
#include <experiments/scaling/scaling.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <options/parsed_option.h>
#include <output/columns.h>
#include <output/gnuplot.h>
#include <program/build_info.h>

#include <algorithm>
#include <filesystem>

namespace cdr::cli {

namespace {

struct ScalingArguments {
    experiments::ScalingOptions options;
    std::filesystem::path csv;
    std::filesystem::path plot;
    RankSweepArguments ranks;
};

output::Columns<experiments::ScalingVariant> variantColumns() {
    using Variant = experiments::ScalingVariant;
    return {{.key = "targets",
             .value = [](const Variant& variant) { return nameOf(variant.targets); },
             .heading = "targets"},
            {.key = "submission",
             .value = [](const Variant& variant) { return nameOf(variant.submission); },
             .heading = "submission"},
            {.key = "cascades", .value = &Variant::cascades, .heading = "cascades"}};
}

output::Columns<experiments::ScalingPoint> pointColumns() {
    using Point = experiments::ScalingPoint;
    const auto median = [](experiments::Spread Point::*time) {
        return [time](const Point& point) { return (point.*time).medianMs; };
    };
    const auto spreads = [](const Point& point) -> output::Json {
        return {{"cull", point.cull.spread},
                {"bin", point.bin.spread},
                {"record", point.record.spread},
                {"execute", point.execute.spread},
                {"frame", point.frame.spread}};
    };
    return output::joined<Point>(
        {output::columnsOf(&Point::variant, variantColumns()),
         {{.key = "threads", .value = &Point::threads, .heading = "threads"},
          {.key = "cubes", .value = &Point::cubes},
          {.key = "draws", .value = &Point::draws, .heading = "draws", .before = "threads"},
          {.key = "cull_ms", .value = median(&Point::cull), .heading = "cull ms"},
          {.key = "bin_ms", .value = median(&Point::bin), .heading = "bin ms"},
          {.key = "record_ms", .value = median(&Point::record), .heading = "record ms"},
          {.value = [](const Point& point) { return point.record.spread; },
           .heading = "+-",
           .format = {"{} %", 100.0}},
          {.key = "record_ns_per_draw", .value = &Point::recordNsPerDraw, .heading = "ns/draw"},
          {.key = "execute_ms", .value = median(&Point::execute), .heading = "execute ms"},
          {.key = "frame_ms", .value = median(&Point::frame), .heading = "frame ms"},
          {.key = "speedup", .value = &Point::recordSpeedUp, .heading = "speed-up"},
          {.key = "efficiency", .value = &Point::efficiency, .heading = "efficiency"},
          {.key = "cull_bin_speedup", .value = &Point::cullAndBinSpeedUp},
          {.key = "frame_speedup", .value = &Point::frameSpeedUp},
          {.key = "spread", .value = spreads},
          {.key = "hash", .value = &Point::hash},
          {.key = "same_image",
           .value = &Point::sameImage,
           .heading = "image",
           .text = [](const Point& point) { return point.sameImage ? "same" : "DIFFERS"; }}}});
}

output::Columns<experiments::ScalingFit> fitColumns() {
    using Fit = experiments::ScalingFit;
    const auto universal = [](double measure::UniversalScalability::*part) {
        return [part](const Fit& fit) {
            return fit.universal ? output::Json((*fit.universal).*part) : output::Json(nullptr);
        };
    };
    return output::joined<Fit>({output::columnsOf(&Fit::variant, variantColumns()),
                                {{.key = "cubes", .value = &Fit::cubes, .heading = "cubes"},
                                 {.key = "amdahl_serial_fraction",
                                  .value = &Fit::serialFraction,
                                  .heading = "serial fraction (Amdahl)"},
                                 {.key = "usl_contention",
                                  .value = universal(&measure::UniversalScalability::contention),
                                  .heading = "contention (USL)"},
                                 {.key = "usl_coherence",
                                  .value = universal(&measure::UniversalScalability::coherence),
                                  .heading = "coherence (USL)"}}});
}

void printTables(const Console& console, const experiments::ScalingResult& result) {
    console.table(output::tableOf(pointColumns(), result.points));
    console.line("\nHow recording scales, fitted:");
    console.table(output::tableOf(fitColumns(), result.fits));
}

void writeScalingCsv(const std::filesystem::path& path, const output::Json& points) {
    platform::writeText(
        path, output::csvOf({"targets", "submission", "cascades", "threads", "cubes", "draws", "cull_ms",
                             "bin_ms", "record_ms", "record_spread=/spread/record", "record_ns_per_draw",
                             "execute_ms", "frame_ms", "speedup", "efficiency", "cull_bin_speedup",
                             "frame_speedup", "hash", "same_image"},
                            points));
}

/// What can be wrong with the arguments, before anything is made.
void checkArguments(ScalingArguments& arguments, CommandFiles& files) {
    experiments::requireUsable(arguments.options);
    files.mayWrite("--csv", arguments.csv);
    files.mayPlot(arguments.plot);
}

void writeResults(Command& command, const ScalingArguments& arguments,
                  const experiments::ScalingResult& result) {
    const experiments::ScalingOptions& options = arguments.options;
    const output::Json points = output::jsonOf(pointColumns(), result.points);
    if (!arguments.csv.empty()) {
        writeScalingCsv(arguments.csv, points);
    }
    if (!arguments.plot.empty()) {
        output::writePlot(arguments.plot, experiments::scalingPlot(result, command.opened().text()));
    }
    auto document = command.makeDocument(
        {{"width", options.width},
         {"height", options.height},
         {"repeats", options.repeats},
         {"placement", options.placement == platform::Placement::pinned ? "pinned" : "free"},
         {"seed", options.seed}});
    document["results"] = points;
    document["fits"] = output::jsonOf(fitColumns(), result.fits);
    command.writeDocument(document);
}

/// Ranks divide one number of cubes.
experiments::RankSweepOptions rankOptionsOf(const ScalingArguments& arguments) {
    experiments::RankSweepOptions options{.cascades = arguments.options.cascades,
                                          .repeats = arguments.options.repeats,
                                          .seed = arguments.options.seed};
    if (arguments.options.draws != experiments::ScalingOptions{}.draws) {
        if (arguments.options.draws.size() != 1) {
            throw base::InputError("scaling --ranks and --project take one number of --draws");
        }
        options.cubes = arguments.options.draws.front();
    }
    return options;
}

void run(Command& command, ScalingArguments& arguments) {
    command.measuresTime();
    if (arguments.ranks.nodes > 0) {
        experiments::RankSweepOptions options = rankOptionsOf(arguments);
        options.sizes = {{.width = arguments.options.width, .height = arguments.options.height}};
        requireUsable(options);
        runProjection(command, options, arguments.ranks);
        return;
    }
    if (arguments.ranks.isAsked) {
        runRankSweep(command, rankOptionsOf(arguments), arguments.ranks);
        return;
    }
    requireAlone(command.ranks(), "scaling without --ranks or --project");
    checkArguments(arguments, command.files());
    const experiments::ScalingOptions& options = arguments.options;
    const experiments::ScalingResult result =
        experiments::runScaling(command.device(), options, command.progress());
    command.endProgress();

    printTables(command.console(), result);
    command.console().line(fmt::format(
        "\n{}; medians of {} frames per row, +- the distance between the quartiles, seed {}, {}x{}; commit {}",
        command.opened().text(), options.repeats, options.seed, options.width, options.height,
        program::buildInfo().commit));
    writeResults(command, arguments, result);
    const auto differs = std::find_if(result.points.begin(), result.points.end(),
                                      [](const auto& point) { return !point.sameImage; });
    if (differs != result.points.end()) {
        throw base::runError(
            "{} targets, {} cascades, {} draws: the image of {} threads differs from that of one",
            nameOf(differs->variant.targets), differs->variant.cascades, differs->draws, differs->threads);
    }
}

/// Ranks are measured without what only threads have.
void excludeThreadOptions(CLI::App& command) {
    CLI::Option* ranks = command.get_option("--ranks");
    CLI::Option* project = command.get_option("--project");
    for (const char* name : {"--threads", "--targets", "--submissions", "--free", "--csv", "--plot"}) {
        ranks->excludes(command.get_option(name));
        project->excludes(command.get_option(name));
    }
    ranks->excludes(project)->excludes(command.get_option("--size"));
    project->excludes(command.get_option("--cascades"));
    command.get_option("--heights")->needs(ranks);
    command.get_option("--frames")->needs(project);
}

void addOptions(CLI::App& command, ScalingArguments& arguments) {
    experiments::ScalingOptions& options = arguments.options;
    addList(command, "--draws", options.draws, "Numbers of cubes to measure, separated by commas");
    command
        .add_option("--threads", options.threads,
                    "Numbers of CPU threads to measure, separated by commas; 1 is always added")
        ->delimiter(',')
        ->default_str("up to twice the CPUs");
    options::addParsedList(command, "--targets", options.targets, render::parseTargets,
                           "Kinds of targets to measure, separated by commas: " +
                               base::listNames(render::kTargetsKinds))
        ->default_str("all");
    options::addParsedList(command, "--submissions", options.submissions, render::parseSubmission,
                           "How draws are submitted, separated by commas: secondaries, primaries, gpu-driven")
        ->default_str("secondaries,primaries");
    command.add_flag_callback(
        "--free", [&options] { options.placement = platform::Placement::free; },
        "Do not bind each thread to a CPU: the operating system chooses");
    addList(command, "--cascades", options.cascades, "Numbers of cascades to measure, separated by commas");
    addValue(command, "--repeats", options.repeats, kRepeatsHelp);
    addSize(command, options.width, options.height);
    addSeed(command, options.seed);
    addRankSweepOptions(command, arguments.ranks);
    addCsv(command, arguments.csv);
    addPlot(command, arguments.plot, "recording times over threads");
    excludeThreadOptions(command);
}

} // namespace

void addScaling(CLI::App& program, const GlobalOptions& global) {
    addCommand<ScalingArguments>(
        program, global, "scaling",
        "Measure how frame times scale with CPU threads, or with the ranks of an MPI run", addOptions, run,
        RankUse::all);
}

} // namespace cdr::cli
