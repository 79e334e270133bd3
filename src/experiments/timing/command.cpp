#include <cdr/host/file.h>
#include <cdr/host/trace.h>
#include <cdr/host/worker_pool.h>
#include <cdr/render/renderer.h>
#include <cli/command.h>
#include <cli/commands.h>
#include <experiments/columns.h>
#include <experiments/gnuplot.h>
#include <experiments/timing/timing.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <optional>

namespace cdr::cli {

namespace {

struct TimingArguments {
    experiments::TimingOptions options;
    std::vector<std::string> modes;
    std::filesystem::path csv;
    std::filesystem::path plot;
    std::filesystem::path trace;
};

using Results = std::vector<experiments::TimingResult>;

/// A part of a frame; null for frames in flight.
auto partOf(double experiments::TimingParts::*part) {
    return [part](const experiments::TimingResult& result) {
        return result.parts ? experiments::Json((*result.parts).*part) : experiments::Json(nullptr);
    };
}

experiments::Columns<experiments::TimingResult> timingColumns() {
    using Result = experiments::TimingResult;
    using Parts = experiments::TimingParts;
    const experiments::CellFormat micros{.pattern = "{:.0f}", .missing = "-"};
    const auto range = [](const Result& result) {
        return fmt::format("{:.0f}-{:.0f}", result.lowUs, result.highUs);
    };
    return {
        {.key = "mode", .value = [](const Result& result) { return result.mode.preset; }},
        {.key = "name", .value = [](const Result& result) { return result.mode.name; }, .heading = "mode"},
        {.key = "targets", .value = [](const Result& result) { return nameOf(result.mode.targets); }},
        {.key = "submission", .value = [](const Result& result) { return nameOf(result.mode.submission); }},
        {.key = "batching", .value = [](const Result& result) { return nameOf(result.mode.batching); }},
        {.key = "surface", .value = [](const Result& result) { return nameOf(result.mode.surface); }},
        {.key = "cascades", .value = &Result::cascades, .heading = "cascades"},
        {.key = "median_us", .value = &Result::medianUs, .heading = "frame us", .format = micros},
        {.key = "p5_us", .value = &Result::lowUs, .heading = "5-95 %", .text = range},
        {.key = "p95_us", .value = &Result::highUs},
        {.key = "cull_bin_us",
         .value = partOf(&Parts::cullAndBinUs),
         .heading = "cull+bin us",
         .format = micros},
        {.key = "record_us", .value = partOf(&Parts::recordUs), .heading = "record us", .format = micros},
        {.key = "execute_us", .value = partOf(&Parts::executeUs), .heading = "execute us", .format = micros},
        {.key = "draws", .value = partOf(&Parts::draws)},
        {.key = "overhead_pct",
         .value = &Result::overheadPercent,
         .heading = "overhead",
         .format = {"{:+.2f} %"}},
        {.key = "ci95",
         .value = [](const Result& result) { return experiments::jsonOf(result.overheadPercent95); },
         .heading = "95 % interval",
         .format = {"{:+.2f} to {:+.2f}"}},
        {.key = "thesis_pct",
         .value = [](const Result& result) { return experiments::finiteOrNull(result.mode.thesisPercent); },
         .heading = "thesis",
         .format = {"{:+.1f} %"}}};
}

void writeCsv(const std::filesystem::path& path, const experiments::Json& rows) {
    host::writeText(path, experiments::csvOf({"name",
                                              "mode",
                                              "targets",
                                              "cascades",
                                              "median_us",
                                              "p5_us",
                                              "p95_us",
                                              "cull_bin_us",
                                              "record_us",
                                              "execute_us",
                                              "draws",
                                              "overhead_pct",
                                              {"ci95_low", "/ci95/0"},
                                              {"ci95_high", "/ci95/1"},
                                              "thesis_pct"},
                                             rows));
}

/// What can be wrong with the arguments, before anything is made.
void checkArguments(TimingArguments& arguments, CommandFiles& files) {
    if (!arguments.modes.empty()) {
        arguments.options.modes = experiments::timingModesNamed(arguments.modes);
    }
    if (!arguments.csv.empty()) {
        files.writes("--csv", arguments.csv);
    }
    if (!arguments.trace.empty()) {
        files.writes("--trace", arguments.trace);
    }
    if (!arguments.plot.empty()) {
        experiments::requirePlottable(arguments.plot);
        files.writes("--plot", arguments.plot);
    }
}

nlohmann::ordered_json makeDocument(const Command& command, const TimingArguments& arguments,
                                    const Results& results) {
    const experiments::TimingOptions& options = arguments.options;
    auto document =
        command.makeDocument({{"width", options.width},
                              {"height", options.height},
                              {"frames", options.frames},
                              {"warm_up_frames", experiments::kWarmUpFrames},
                              {"threads", options.threads},
                              {"seed", options.seed},
                              {"scene", "64,000 unit cubes in a 400^3 field, 60 degrees, near 0.1, far "
                                        "100,000, one turn about y"},
                              {"frames_in_flight", options.framesInFlight},
                              {"mode", options.framesInFlight > 1 ? "throughput" : "latency"}});
    document["results"] = experiments::jsonOf(timingColumns(), results);
    document["noise_floor_pct"] = results.at(1).overheadPercent;
    document["noise_floor_ci95"] = experiments::jsonOf(results.at(1).overheadPercent95);
    return document;
}

void run(Command& command, TimingArguments& arguments) {
    checkArguments(arguments, command.files());
    experiments::TimingOptions& options = arguments.options;
    std::optional<host::Trace> trace;
    if (!arguments.trace.empty()) {
        options.trace = &trace.emplace(options.threads);
    }
    const Results results =
        experiments::runTiming(command.device(), options, command.progressOf("frames of every mode"));
    command.endProgress();

    const Console& console = command.console();
    const std::string device = command.opened().text();
    console.table(experiments::tableOf(timingColumns(), results));
    console.line(fmt::format("\n{}; {} frames a mode after {} dropped, seed {}, {} threads, {}x{}; commit {}",
                             device, options.frames, experiments::kWarmUpFrames, options.seed,
                             options.threads, options.width, options.height, host::buildInfo().commit));
    console.line(fmt::format("Noise floor, standard over itself: {:+.2f} %, 95 % {:+.2f} to {:+.2f}",
                             results.at(1).overheadPercent, results.at(1).overheadPercent95.low,
                             results.at(1).overheadPercent95.high));
    if (!arguments.csv.empty()) {
        writeCsv(arguments.csv, experiments::jsonOf(timingColumns(), results));
    }
    if (!arguments.plot.empty()) {
        experiments::writePlot(arguments.plot, experiments::timingPlot(results, device));
    }
    if (trace) {
        trace->write(arguments.trace);
    }
    command.writeDocument(makeDocument(command, arguments, results));
}

void addOptions(CLI::App& command, TimingArguments& arguments) {
    experiments::TimingOptions& options = arguments.options;
    addFrames(command, options.frames, "Measured frames of every mode");
    addSize(command, options.width, options.height);
    addThreads(command, options.threads, "Threads that cull, bin and record");
    command
        .add_option("--in-flight", options.framesInFlight,
                    "Frames in flight: 1 times latency, as the thesis; more time throughput")
        ->check(CLI::Range(std::size_t{1}, render::kMaxFramesInFlight))
        ->capture_default_str();
    addSeed(command, options.seed, "Seed of the scene, the orders and the bootstrap");
    command
        .add_option("--modes", arguments.modes,
                    "Only these beside standard, such as cdr-2,log,logcdr-5; also naive and standard/NAME "
                    "with a batching, submission or surface")
        ->delimiter(',');
    command.add_option("--csv", arguments.csv, "Write the results as CSV to FILE");
    command.add_option("--plot", arguments.plot, "Draw the figure into a .png or .svg file, by gnuplot");
    command.add_option("--trace", arguments.trace,
                       "Write the dropped frames as a trace for ui.perfetto.dev or chrome://tracing");
}

} // namespace

void addTiming(CLI::App& program, const GlobalOptions& global) {
    addCommand<TimingArguments>(program, global, "timing",
                                "What each technique costs over standard, frame by frame (Figure 6.4)",
                                addOptions, run);
}

} // namespace cdr::cli
