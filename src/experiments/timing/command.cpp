#include <cdr/base/error.h>
#include <cdr/host/file.h>
#include <cdr/host/process.h>
#include <cdr/host/trace.h>
#include <cdr/host/worker_pool.h>
#include <cdr/render/renderer.h>
#include <cli/command.h>
#include <cli/commands.h>
#include <experiments/rivals/needs_command.h>
#include <experiments/timing/tables.h>
#include <experiments/timing/timing.h>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
#include <output/columns.h>
#include <output/gnuplot.h>
#include <output/readable.h>
#include <program/build_info.h>

#include <filesystem>
#include <optional>

namespace cdr::cli {

namespace {

struct TimingArguments {
    program::MachineState machine; ///< before anything is timed
    experiments::TimingOptions options;
    std::vector<std::string> modes;
    std::filesystem::path csv;
    std::filesystem::path plot;
    std::filesystem::path trace;
    std::filesystem::path against;
    std::uint32_t rounds = experiments::AgainstOptions{}.rounds;
    std::vector<rivals::NamedRival> rivalsBeside;
    bool stages = false;
    bool memory = false;
    std::optional<std::uint32_t> frames; ///< none: what suits what is timed
};

/// Frames of each run of a build, and of each mode whose stages are measured.
constexpr std::uint32_t kRunFrames = 40;
constexpr std::uint32_t kStageFrames = 100;

using Results = std::vector<experiments::TimingResult>;

/// A part of a frame; null for frames in flight.
auto partOf(double experiments::TimingParts::*part) {
    return [part](const experiments::TimingResult& result) {
        return result.parts ? output::Json((*result.parts).*part) : output::Json(nullptr);
    };
}

/// The device's own time; null where it has no clock, and for frames in flight.
output::Json deviceTimeOf(const experiments::TimingResult& result) {
    return output::finiteOrNull(result.parts ? result.parts->deviceUs : std::nullopt);
}

/// How a mode renders; null where ids alone are drawn.
template <typename Part>
auto howOf(Part experiments::TimingMode::*part) {
    return [part](const experiments::TimingResult& result) {
        return result.mode.idsAlone ? output::Json(nullptr) : output::Json(nameOf(result.mode.*part));
    };
}

/// @param floor standard over itself.
output::Columns<experiments::TimingResult> timingColumns(const measure::Interval& floor) {
    using Result = experiments::TimingResult;
    using Mode = experiments::TimingMode;
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
        {.key = "targets", .value = howOf(&Mode::targets)},
        {.key = "submission", .value = howOf(&Mode::submission)},
        {.key = "batching", .value = howOf(&Mode::batching)},
        {.key = "surface", .value = howOf(&Mode::surface)},
        {.key = "snapping", .value = howOf(&Mode::snapping)},
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
        output::intervalColumn(&Result::overheadPercent95, "{:+} to {:+}"),
        {.key = "seen",
         .value = isSeen,
         .heading = "seen",
         .text =
             [isSeen](const Result& result) {
                 const output::Json seen = isSeen(result);
                 return std::string(seen.is_boolean() ? (seen.get<bool>() ? "yes" : "no") : "");
             }},
        {.key = "thesis_pct",
         .value = [](const Result& result) { return output::finiteOrNull(result.mode.thesisPercent); },
         .heading = "thesis",
         .format = {"{:+} %"}}};
}

void writeTimingCsv(const std::filesystem::path& path, const output::Json& rows) {
    host::writeText(path, output::csvOf({"name",
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
                                         "thesis_pct",
                                         "device_us"},
                                        rows));
}

/// What can be wrong with the arguments, before anything is made.
void checkArguments(TimingArguments& arguments, CommandFiles& files, const ranks::Ranks& ranks) {
    if (!arguments.against.empty() || arguments.memory) {
        requireAlone(ranks, arguments.memory ? "timing --memory" : "timing --against");
    }
    const bool isPlain = arguments.against.empty() && !arguments.stages && !arguments.memory;
    if (!isPlain && (!arguments.csv.empty() || !arguments.trace.empty())) {
        throw base::InputError("--csv and --trace go with none of --against, --stages and --memory");
    }
    if (!arguments.plot.empty() && (!arguments.against.empty() || arguments.memory)) {
        throw base::InputError("--plot goes with neither --against nor --memory");
    }
    if (!isPlain && arguments.options.framesInFlight > 1) {
        throw base::InputError("--in-flight goes with none of --against, --stages and --memory");
    }
    if (!isPlain && arguments.options.scene != experiments::TimingOptions{}.scene) {
        throw base::InputError("--scene goes with none of --against, --stages and --memory");
    }
    if (!isPlain && !arguments.rivalsBeside.empty()) {
        throw base::InputError("--rivals goes with none of --against, --stages and --memory");
    }
    if (!arguments.modes.empty()) {
        arguments.options.modes = experiments::timingModesNamed(arguments.modes);
    }
    const auto rivalModes = experiments::rivalTimingModes(arguments.rivalsBeside);
    arguments.options.modes.insert(arguments.options.modes.end(), rivalModes.begin(), rivalModes.end());
    if (!arguments.csv.empty()) {
        files.writes("--csv", arguments.csv);
    }
    if (!arguments.trace.empty()) {
        files.writes("--trace", arguments.trace);
    }
    if (!arguments.plot.empty()) {
        output::requirePlottable(arguments.plot);
        files.writes("--plot", arguments.plot);
    }
}

const char* describeScene(const experiments::TimingOptions& options) {
    if (options.scene == experiments::TimingScene::city) {
        return "1,000,000 boxes of houses and streets, seen from a street, 60 degrees, near 0.2, far 8,000";
    }
    return options.scene == experiments::TimingScene::traffic
               ? "100,000 cubes that move, from 1 to 10,000,000 units away, one turn about y"
               : "64,000 unit cubes in a 400^3 field, 60 degrees, near 0.1, far 100,000, one turn about y";
}

nlohmann::ordered_json makeDocument(const Command& command, const TimingArguments& arguments,
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

/// What the other build and this one are run with.
std::vector<std::string> runArguments(const Command& command, const TimingArguments& arguments) {
    const experiments::TimingOptions& options = arguments.options;
    std::vector<std::string> all{"--quiet"};
    if (const std::string device = textOf(command.global().device); !device.empty()) {
        all.insert(all.end(), {"--device", device});
    }
    all.insert(all.end(),
               {"timing", "--frames", std::to_string(arguments.frames.value_or(kRunFrames)), "--size",
                fmt::format("{}x{}", options.width, options.height), "--threads",
                std::to_string(options.threads), "--seed", std::to_string(options.seed), "--modes",
                arguments.modes.empty() ? "standard" : fmt::format("{}", fmt::join(arguments.modes, ","))});
    return all;
}

void runAgainst(const Command& command, const TimingArguments& arguments) {
    const std::optional<std::filesystem::path> own = host::ownProgram();
    if (!own) {
        throw base::RunError("--against: this system does not tell which file this program is");
    }
    const experiments::AgainstOptions options{.here = *own,
                                              .against = arguments.against,
                                              .arguments = runArguments(command, arguments),
                                              .rounds = arguments.rounds,
                                              .seed = arguments.options.seed};
    const experiments::AgainstReport report =
        experiments::runAgainst(options, command.progressOf("runs of both builds"));
    command.endProgress();
    command.console().table(output::tableOf(experiments::againstColumns(), report.comparisons));
    command.console().line(fmt::format(
        "\n{} (driver {}); {} rounds of {} frames a mode, in turns; commit {} over {}; {}", report.device,
        report.driver, options.rounds, arguments.frames.value_or(kRunFrames), program::buildInfo().commit,
        report.againstCommit, experiments::machineText(arguments.machine)));
    auto document = command.makeDocument({{"against", options.against.string()},
                                          {"against_commit", report.againstCommit},
                                          {"rounds", options.rounds},
                                          {"frames", arguments.frames.value_or(kRunFrames)},
                                          {"arguments", options.arguments}});
    document["device"]["name"] = report.device;
    document["device"]["driver"] = report.driver;
    document["machine"] = experiments::machineJson(arguments.machine);
    document["results"] = output::jsonOf(experiments::againstColumns(), report.comparisons);
    command.writeDocument(document);
}

void runStages(Command& command, const TimingArguments& arguments) {
    experiments::TimingOptions options = arguments.options;
    options.frames = arguments.frames.value_or(kStageFrames);
    // Standard is there once: its second mode, the noise floor, is left out.
    std::vector<experiments::TimingMode> modes{options.modes.front()};
    if (!arguments.modes.empty()) {
        modes.insert(modes.end(), options.modes.begin() + 2, options.modes.end());
    }
    auto rows = output::Json::array();
    auto measuredBy = output::Json::array();
    runs::TimedRanks ranks(command.ranks());
    std::vector<experiments::ModeStages> plotted;
    for (const experiments::TimingMode& mode : modes) {
        options.modes = {mode};
        const std::vector<experiments::StageCost> stages = experiments::runStages(
            command.device(), options, command.progressOf("frames of " + mode.name), ranks);
        command.endProgress();
        if (!ranks.isFirst()) {
            continue;
        }
        for (output::Json row : ranks.measuredBy("frames")) {
            row["mode"] = mode.name;
            measuredBy.push_back(std::move(row));
        }
        const auto columns = experiments::stageColumns(mode.name);
        command.console().table(output::tableOf(columns, stages));
        for (const output::Json& row : output::jsonOf(columns, stages)) {
            rows.push_back(row);
        }
        plotted.push_back({mode.name, stages});
    }
    if (!ranks.isFirst()) {
        return;
    }
    if (!arguments.plot.empty()) {
        output::writePlot(arguments.plot, experiments::stagesPlot(plotted, command.opened().text()));
    }
    command.console().line(fmt::format("\n{}; {} frames of each variant in turns; {}",
                                       command.opened().text(), options.frames,
                                       experiments::machineText(arguments.machine)));
    auto document = command.makeDocument({{"width", options.width},
                                          {"height", options.height},
                                          {"frames", options.frames},
                                          {"threads", options.threads},
                                          {"seed", options.seed}});
    document["machine"] = experiments::machineJson(arguments.machine);
    document["results"] = rows;
    runs::addMeasuredBy(document, command.ranks(), measuredBy);
    command.writeDocument(document);
}

void measureMemory(Command& command, const TimingArguments& arguments) {
    const experiments::MemoryOptions options{
        .width = arguments.options.width, .height = arguments.options.height, .seed = arguments.options.seed};
    const std::vector<experiments::MemoryCost> costs = experiments::measureMemory(command.device(), options);
    command.endProgress();
    command.console().table(output::tableOf(experiments::memoryColumns(), costs));
    command.console().line(fmt::format(
        "\n{}; {} instances over half as many, {}x{} over half the width; {} cascades",
        command.opened().text(), 2 * options.instances, 2 * options.width, options.height, options.cascades));
    auto document = command.makeDocument({{"width", options.width},
                                          {"height", options.height},
                                          {"instances", options.instances},
                                          {"cascades", options.cascades},
                                          {"seed", options.seed}});
    document["results"] = output::jsonOf(experiments::memoryColumns(), costs);
    command.writeDocument(document);
}

void timeModes(Command& command, TimingArguments& arguments) {
    experiments::TimingOptions& options = arguments.options;
    options.frames = arguments.frames.value_or(options.frames);
    std::optional<host::Trace> trace;
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
    console.table(output::tableOf(timingColumns(results.at(1).overheadPercent95), results));
    console.line(fmt::format("\n{}; {} frames a mode after {} dropped, seed {}, {} threads, {}x{}; commit {}",
                             device, options.frames, experiments::kWarmUpFrames, options.seed,
                             options.threads, options.width, options.height, program::buildInfo().commit));
    console.line(experiments::machineText(arguments.machine));
    const experiments::TimingResult& again = results.at(1);
    console.line(fmt::format("Noise floor, standard over itself: {:+} %, 95 % {:+} to {:+}",
                             output::Readable{again.overheadPercent},
                             output::Readable{again.overheadPercent95.low},
                             output::Readable{again.overheadPercent95.high}));
    if (!arguments.rivalsBeside.empty()) {
        printNeeds(console, arguments.rivalsBeside);
        console.line(
            "\nRivals and standard/ids draw ids and distances, and shade nothing. Overheads of rivals are over "
            "standard/ids.");
    }
    if (!arguments.csv.empty()) {
        writeTimingCsv(arguments.csv,
                       output::jsonOf(timingColumns(results.at(1).overheadPercent95), results));
    }
    if (!arguments.plot.empty()) {
        output::writePlot(arguments.plot, experiments::timingPlot(results, device));
    }
    if (trace) {
        trace->write(arguments.trace);
    }
    auto document = makeDocument(command, arguments, results);
    runs::addMeasuredBy(document, command.ranks(),
                        ranks.measuredBy(options.framesInFlight > 1 ? "runs" : "frames"));
    addNeeds(document, arguments.rivalsBeside);
    command.writeDocument(document);
}

void run(Command& command, TimingArguments& arguments) {
    checkArguments(arguments, command.files(), command.ranks());
    arguments.machine = program::machineState();
    if (!arguments.against.empty()) {
        runAgainst(command, arguments);
    } else if (arguments.stages) {
        runStages(command, arguments);
    } else if (arguments.memory) {
        measureMemory(command, arguments);
    } else {
        timeModes(command, arguments);
    }
}

void addOptions(CLI::App& command, TimingArguments& arguments) {
    experiments::TimingOptions& options = arguments.options;
    command
        .add_option(
            "--frames", arguments.frames,
            fmt::format("Measured frames of every mode: {} unless given, {} a run with --against, {} with "
                        "--stages",
                        options.frames, kRunFrames, kStageFrames))
        ->check(CLI::Range(1u, kMaxFrames));
    addSize(command, options.width, options.height);
    addThreads(command, options.threads, "Threads that cull, bin and record");
    command
        .add_option_function<std::string>(
            "--scene",
            [&options](const std::string& name) { options.scene = experiments::parseTimingScene(name); },
            fmt::format("{}; traffic moves", fmt::join(experiments::timingSceneNames(), ", ")))
        ->default_str(std::string(nameOf(options.scene)));
    command
        .add_option("--in-flight", options.framesInFlight,
                    "Frames in flight: 1 measures latency, as the thesis does; more measure throughput")
        ->check(CLI::Range(std::size_t{1}, render::kMaxFramesInFlight))
        ->capture_default_str();
    addSeed(command, options.seed, "Seed of the scene, the orders and the bootstrap");
    command
        .add_option(
            "--modes", arguments.modes,
            "Only these beside standard, such as cdr-2,log,logcdr-5; also naive and log-fragment. Behind each "
            "may stand /NAME of batchings, submissions, surfaces and targets, /in-plane and /occlusion-culling")
        ->delimiter(',');
    addRivalList(command, arguments.rivalsBeside, "none");
    CLI::Option* against = command.add_option(
        "--against", arguments.against,
        "Run this build and PROGRAM, another build, in turns, and say how their times differ, if they do");
    command
        .add_option("--rounds", arguments.rounds, "Rounds of runs, two of this build and one of the other")
        ->check(CLI::Range(1u, 1000u))
        ->needs(against)
        ->capture_default_str();
    CLI::Option* stages = command.add_flag("--stages", arguments.stages,
                                           "What each stage of a frame costs, of standard and --modes");
    stages->excludes(against);
    command
        .add_flag("--memory", arguments.memory,
                  "Bytes of an instance, a draw and a pixel, predicted and measured")
        ->excludes(against)
        ->excludes(stages);
    command.add_option("--csv", arguments.csv, "Write the results as CSV to FILE");
    command.add_option("--plot", arguments.plot, "Draw the figure into a .png or .svg file, by gnuplot");
    command.add_option("--trace", arguments.trace,
                       "Write the dropped frames as a trace for ui.perfetto.dev or chrome://tracing");
}

} // namespace

void addTiming(CLI::App& program, const GlobalOptions& global) {
    addCommand<TimingArguments>(program, global, "timing",
                                "What each technique costs over standard, frame by frame (Figure 6.4)",
                                addOptions, run, RankUse::timed);
}

} // namespace cdr::cli
