#include "timing_command.h"

#include <cdr/platform/file.h>
#include <cdr/platform/trace.h>
#include <experiments/rivals/needs_command.h>
#include <experiments/timing/tables.h>

#include <fmt/format.h>
#include <output/columns.h>
#include <output/gnuplot.h>
#include <output/readable.h>
#include <program/build_info.h>

namespace cdr::cli {

namespace {

using Results = std::vector<experiments::TimingResult>;

/// A part of a frame; null for frames in flight.
auto partOf(double experiments::TimingParts::*part) {
    return [part](const experiments::TimingResult& result) {
        return result.parts ? output::Json((*result.parts).*part) : output::Json(nullptr);
    };
}

/// The device's own time; null where it has no clock, and for frames in flight.
std::optional<double> deviceTimeOf(const experiments::TimingResult& result) {
    return result.parts ? result.parts->deviceUs : std::nullopt;
}

/// How a mode renders; null where ids alone are drawn.
template <typename Part>
auto howOf(Part render::RenderOptions::*part) {
    return [part](const experiments::TimingResult& result) {
        return result.mode.idsAlone ? output::Json(nullptr) : output::Json(nameOf(result.mode.drawing.*part));
    };
}

/// @param floor standard over itself
output::Columns<experiments::TimingResult> timingColumns(const std::optional<measure::Interval>& floor) {
    using Result = experiments::TimingResult;
    using Drawing = render::RenderOptions;
    using Parts = experiments::TimingParts;
    const output::CellFormat micros{.missing = "-"};
    // The overheads of rivals are over another mode, whose noise is not measured.
    const auto isSeen = [floor](const Result& result) {
        return result.mode.idsAlone ? output::absent()
                                    : output::Json(experiments::liesApart(result.overheadPercent95, floor));
    };
    const auto range = [](const Result& result) {
        return fmt::format("{} to {}", output::Readable{result.lowUs}, output::Readable{result.highUs});
    };
    return {
        {.key = "mode", .value = [](const Result& result) { return result.mode.preset; }},
        {.key = "name", .value = [](const Result& result) { return result.mode.name; }, .heading = "mode"},
        {.key = "rival",
         .value =
             [](const Result& result) {
                 return result.mode.isRival() ? output::Json(true) : output::absent();
             }},
        {.key = "targets", .value = howOf(&Drawing::targets)},
        {.key = "submission", .value = howOf(&Drawing::submission)},
        {.key = "batching", .value = howOf(&Drawing::batching)},
        {.key = "surface", .value = howOf(&Drawing::surface)},
        {.key = "snapping", .value = howOf(&Drawing::snapping)},
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
        {.key = "device_us", .value = deviceTimeOf},
        {.key = "draws", .value = partOf(&Parts::draws)},
        {.key = "over",
         .value =
             [](const Result& result) {
                 return result.mode.isRival() ? output::Json(result.over) : output::absent();
             }},
        {.key = "overhead_pct",
         .value = &Result::overheadPercent,
         .heading = "overhead",
         .format = {"{:+} %"}},
        output::intervalColumn(&Result::overheadPercent95, {.pattern = "{:+} to {:+}"}),
        {.key = "seen",
         .value = isSeen,
         .heading = "seen",
         .text =
             [isSeen](const Result& result) {
                 const output::Json seen = isSeen(result);
                 return std::string(seen.is_boolean() ? (seen.get<bool>() ? "yes" : "no") : "");
             }},
        {.key = "thesis_pct",
         .value = [](const Result& result) { return result.mode.thesisPercent; },
         .heading = "thesis",
         .format = {"{:+} %"}}};
}

void writeTimingCsv(const std::filesystem::path& path, const output::Json& rows) {
    platform::writeText(path,
                        output::csvOf({"name", "mode", "targets", "cascades", "median_us", "p5_us", "p95_us",
                                       "cull_bin_us", "record_us", "execute_us", "draws", "overhead_pct",
                                       "ci95_low=/ci95/0", "ci95_high=/ci95/1", "thesis_pct", "device_us"},
                                      rows));
}

const char* describeScene(const experiments::TimingOptions& options) {
    if (options.scene == experiments::TimingScene::city) {
        return "1,000,000 boxes of houses and streets, seen from a street, 60 degrees, near 0.2, far 8,000";
    }
    return options.scene == experiments::TimingScene::traffic
               ? "100,000 cubes that move, from 1 to 10,000,000 units away, one turn about y"
               : "64,000 unit cubes in a 400^3 field, 60 degrees, near 0.1, far 100,000, one turn about y";
}

/// @param again standard over itself
std::string noiseFloorLine(const experiments::TimingResult& again) {
    const auto& interval = again.overheadPercent95;
    return fmt::format("Noise floor, the difference of two runs of standard: {:+} %, {}",
                       output::Readable{again.overheadPercent},
                       interval ? fmt::format("95 % interval {:+} to {:+}", output::Readable{interval->low},
                                              output::Readable{interval->high})
                                : fmt::format("too few samples for a 95 % interval, {} are needed",
                                              measure::kMinIntervalSamples));
}

nlohmann::ordered_json timingDocument(const Command& command, const TimingArguments& arguments,
                                      const Results& results) {
    const experiments::TimingOptions& options = arguments.options;
    auto document = command.makeDocument({{"width", options.width},
                                          {"height", options.height},
                                          {"frames", options.frames},
                                          {"warm_up_frames", experiments::kWarmUpFrames},
                                          {"threads", options.threads},
                                          {"seed", options.seed},
                                          {"scene", describeScene(options)},
                                          {"frames_in_flight", options.framesInFlight},
                                          {"mode", options.framesInFlight > 1 ? "throughput" : "latency"}});
    document["machine"] = experiments::machineJson(arguments.machine);
    document["results"] = output::jsonOf(timingColumns(results.at(1).overheadPercent95), results);
    document["noise_floor_pct"] = results.at(1).overheadPercent;
    document["noise_floor_ci95"] = output::jsonOf(results.at(1).overheadPercent95);
    return document;
}

} // namespace

void timeModes(Command& command, TimingArguments& arguments) {
    experiments::TimingOptions& options = arguments.options;
    options.frames = arguments.frames.value_or(options.frames);
    std::optional<platform::Trace> trace;
    runs::TimedRanks ranks(command.ranks());
    if (!arguments.trace.empty() && ranks.isFirst()) {
        options.trace = &trace.emplace(options.threads);
    }
    const Results results =
        experiments::runTiming(command.device(), options, command.progressOf("frames of every mode"), ranks);
    command.endProgress();
    if (!ranks.isFirst()) {
        return;
    }

    const Console& console = command.console();
    const std::string device = command.opened().text();
    const auto columns = timingColumns(results.at(1).overheadPercent95);
    console.table(output::tableOf(columns, results));
    console.line(fmt::format(
        "\n{}; {} frames per mode after {} that are not measured, seed {}, {} threads, {}x{}; commit {}",
        device, options.frames, experiments::kWarmUpFrames, options.seed, options.threads, options.width,
        options.height, program::buildInfo().commit));
    console.line(experiments::machineText(arguments.machine));
    console.line(noiseFloorLine(results.at(1)));
    if (!arguments.rivalsBeside.empty()) {
        printNeeds(console, arguments.rivalsBeside);
        console.line(
            "\nRivals and standard/ids draw ids and distances, and shade nothing. Overheads of rivals are over "
            "standard/ids.");
    }
    if (!arguments.csv.empty()) {
        writeTimingCsv(arguments.csv, output::jsonOf(columns, results));
    }
    if (!arguments.plot.empty()) {
        output::writePlot(arguments.plot, experiments::timingPlot(results, device));
    }
    if (trace) {
        trace->write(arguments.trace);
    }
    auto document = timingDocument(command, arguments, results);
    runs::addMeasuredBy(document, command.ranks(),
                        ranks.measuredBy(options.framesInFlight > 1 ? "runs" : "frames"));
    addNeeds(document, arguments.rivalsBeside);
    command.writeDocument(document);
}

} // namespace cdr::cli
