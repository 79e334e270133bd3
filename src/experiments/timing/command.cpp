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
    if (arguments.memory) {
        requireAlone(ranks, "timing --memory");
    }
    if (!arguments.against.empty() && ranks.place().node) {
        throw base::InputError(
            "timing --against starts programs that would join this run of ranks: start it without mpirun");
    }
    const bool isPlain = arguments.against.empty() && !arguments.stages && !arguments.memory;
    if (!isPlain && (!arguments.csv.empty() || !arguments.trace.empty())) {
        throw base::InputError("--csv and --trace cannot be combined with --against, --stages or --memory");
    }
    if (!arguments.plot.empty() && (!arguments.against.empty() || arguments.memory)) {
        throw base::InputError("--plot cannot be combined with --against or --memory");
    }
    if (!isPlain && arguments.options.framesInFlight > 1) {
        throw base::InputError("--in-flight cannot be combined with --against, --stages or --memory");
    }
    if (!isPlain && arguments.options.scene != experiments::TimingOptions{}.scene) {
        throw base::InputError("--scene cannot be combined with --against, --stages or --memory");
    }
    if (!isPlain && !arguments.rivalsBeside.empty()) {
        throw base::InputError("--rivals cannot be combined with --against, --stages or --memory");
    }
    if (arguments.memory && (!arguments.modes.empty() || arguments.frames)) {
        throw base::InputError("--modes and --frames cannot be combined with --memory");
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

/// What checkArguments() refuses, in the words that help has for excludes().
void sayNotWith(CLI::App& command, const char* option, const char* others) {
    CLI::Option* found = command.get_option(option);
    found->description(fmt::format("{} (not with {})", found->get_description(), others));
}

void addOptions(CLI::App& command, TimingArguments& arguments) {
    experiments::TimingOptions& options = arguments.options;
    command.add_option("--frames", arguments.frames, "Measured frames of each mode")
        ->check(CLI::Range(1u, kMaxFrames))
        ->default_str(fmt::format("{}, or {} per run with --against, or {} with --stages", options.frames,
                                  kRunFrames, kStageFrames));
    addSize(command, options.width, options.height);
    addThreads(command, options.threads);
    command
        .add_option_function<std::string>(
            "--scene",
            [&options](const std::string& name) { options.scene = experiments::parseTimingScene(name); },
            fmt::format("Scene to draw: {}; only traffic moves",
                        fmt::join(experiments::timingSceneNames(), ", ")))
        ->default_str(std::string(nameOf(options.scene)));
    addValue(command, "--in-flight", options.framesInFlight,
             fmt::format("Frames in flight, 1 to {}: 1 measures latency, as the thesis does, more measure "
                         "throughput",
                         render::kMaxFramesInFlight))
        ->check(CLI::Range(std::size_t{1}, render::kMaxFramesInFlight));
    addSeed(command, options.seed);
    command
        .add_option(
            "--modes", arguments.modes,
            "Modes to measure beside standard, separated by commas, such as cdr-2,log,logcdr-5,naive,log-fragment. "
            "/NAME after a mode draws it with the batching, submission, surface or targets of that name, as render "
            "takes them; also /in-plane and /occlusion-culling")
        ->delimiter(',')
        ->default_str("all, or standard alone with --against or --stages");
    addRivalList(command, arguments.rivalsBeside, "none");
    CLI::Option* against =
        command.add_option("--against", arguments.against,
                           "Compare frame times with PROGRAM, another build of cdr; both run in turns");
    against->type_name("PROGRAM")->check(options::namesOne("program"));
    addValue(command, "--rounds", arguments.rounds,
             "Rounds; in each, this build runs twice and the other once")
        ->check(CLI::Range(1u, 1000u))
        ->needs(against);
    CLI::Option* stages = command.add_flag(
        "--stages", arguments.stages, "Measure what each stage of a frame costs, for standard and --modes");
    stages->excludes(against);
    command
        .add_flag("--memory", arguments.memory,
                  "Predict and measure the bytes of an instance, a draw and a pixel")
        ->excludes(against)
        ->excludes(stages)
        ->excludes(command.get_option("--threads"));
    addCsv(command, arguments.csv);
    addPlot(command, arguments.plot, "overheads over standard, or the stages of --stages,");
    addTrace(command, arguments.trace, "the frames before the measured ones");
    for (const char* option : {"--scene", "--in-flight", "--rivals", "--csv", "--trace"}) {
        sayNotWith(command, option, "--against, --stages or --memory");
    }
    for (const char* option : {"--frames", "--modes"}) {
        sayNotWith(command, option, "--memory");
    }
    sayNotWith(command, "--plot", "--against or --memory");
}

} // namespace

void addTiming(CLI::App& program, const GlobalOptions& global) {
    addCommand<TimingArguments>(
        program, global, "timing",
        "Measure the frame time of each technique, compared with standard (thesis Figure 6.4)", addOptions,
        run, RankUse::timed);
}

} // namespace cdr::cli
