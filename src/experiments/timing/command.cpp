#include "timing_command.h"

#include <cdr/base/error.h>
#include <cdr/platform/worker_pool.h>
#include <cdr/render/render_options.h>
#include <cli/commands.h>
#include <experiments/timing/tables.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace cdr::cli {

namespace {

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
    if (arguments.memory && (!arguments.modes.empty() || arguments.frames)) {
        throw base::InputError("--modes and --frames do not go with --memory");
    }
    if (!arguments.modes.empty()) {
        arguments.options.modes = experiments::timingModesNamed(arguments.modes);
    }
    const auto rivalModes = experiments::rivalTimingModes(arguments.rivalsBeside);
    arguments.options.modes.insert(arguments.options.modes.end(), rivalModes.begin(), rivalModes.end());
    files.mayWrite("--csv", arguments.csv);
    files.mayWrite("--trace", arguments.trace);
    files.mayPlot(arguments.plot);
}

void run(Command& command, TimingArguments& arguments) {
    checkArguments(arguments, command.files(), command.ranks());
    arguments.machine = program::machineState();
    if (!arguments.against.empty()) {
        timeAgainst(command, arguments);
    } else if (arguments.stages) {
        timeStages(command, arguments);
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
