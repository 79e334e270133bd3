#include <cdr/host/file.h>
#include <cdr/host/trace.h>
#include <cdr/host/worker_pool.h>
#include <cdr/render/renderer.h>
#include <cli/commands.h>
#include <cli/console.h>
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
    std::string size = "1280x720";
    std::vector<std::string> modes;
    std::filesystem::path csv;
    std::filesystem::path plot;
    std::filesystem::path trace;
    OutputOptions output;
};

using Results = std::vector<experiments::TimingResult>;

nlohmann::ordered_json toJson(const experiments::TimingResult& result) {
    const std::optional<double>& thesis = result.mode.thesisPercent;
    const auto part = [&](double experiments::TimingParts::*value) {
        return result.parts ? nlohmann::ordered_json((*result.parts).*value)
                            : nlohmann::ordered_json(nullptr);
    };
    using Parts = experiments::TimingParts;
    return {{"mode", result.mode.preset},
            {"name", result.mode.name},
            {"targets", nameOf(result.mode.targets)},
            {"submission", nameOf(result.mode.submission)},
            {"batching", nameOf(result.mode.batching)},
            {"cascades", result.cascades},
            {"median_us", result.medianUs},
            {"p5_us", result.lowUs},
            {"p95_us", result.highUs},
            {"cull_bin_us", part(&Parts::cullAndBinUs)},
            {"record_us", part(&Parts::recordUs)},
            {"execute_us", part(&Parts::executeUs)},
            {"draws", part(&Parts::draws)},
            {"overhead_pct", result.overheadPercent},
            {"ci95", {result.overheadPercent95.low, result.overheadPercent95.high}},
            {"thesis_pct", thesis ? nlohmann::ordered_json(*thesis) : nlohmann::ordered_json(nullptr)}};
}

void printTable(const Console& console, const Results& results) {
    std::vector<std::vector<std::string>> rows;
    for (const auto& result : results) {
        const auto micros = [](double us) { return fmt::format("{:.0f}", us); };
        const auto part = [&](double experiments::TimingParts::*value) {
            return result.parts ? micros((*result.parts).*value) : std::string("-");
        };
        using Parts = experiments::TimingParts;
        rows.push_back(
            {result.mode.name, std::to_string(result.cascades), micros(result.medianUs),
             fmt::format("{:.0f}-{:.0f}", result.lowUs, result.highUs), part(&Parts::cullAndBinUs),
             part(&Parts::recordUs), part(&Parts::executeUs),
             fmt::format("{:+.2f} %", result.overheadPercent),
             fmt::format("{:+.2f} to {:+.2f}", result.overheadPercent95.low, result.overheadPercent95.high),
             result.mode.thesisPercent ? fmt::format("{:+.1f} %", *result.mode.thesisPercent) : ""});
    }
    console.table({"mode", "cascades", "frame us", "5-95 %", "cull+bin us", "record us", "execute us",
                   "overhead", "95 % interval", "thesis"},
                  rows);
}

void writeCsv(const std::filesystem::path& path, const Results& results) {
    std::string csv =
        "name,mode,targets,cascades,median_us,p5_us,p95_us,cull_bin_us,record_us,execute_us,draws,"
        "overhead_pct,ci95_low,ci95_high,thesis_pct\n";
    for (const auto& r : results) {
        const auto part = [&](double experiments::TimingParts::*value) {
            return r.parts ? fmt::format("{}", (*r.parts).*value) : std::string();
        };
        using Parts = experiments::TimingParts;
        csv += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", r.mode.name, r.mode.preset,
                           nameOf(r.mode.targets), r.cascades, r.medianUs, r.lowUs, r.highUs,
                           part(&Parts::cullAndBinUs), part(&Parts::recordUs), part(&Parts::executeUs),
                           part(&Parts::draws), r.overheadPercent, r.overheadPercent95.low,
                           r.overheadPercent95.high,
                           r.mode.thesisPercent ? fmt::format("{}", *r.mode.thesisPercent) : "");
    }
    host::writeText(path, csv);
}

/// What can be wrong with the arguments, before anything is made.
void checkArguments(TimingArguments& arguments) {
    const PictureSize size = parseSize(arguments.size);
    arguments.options.width = size.width;
    arguments.options.height = size.height;
    if (!arguments.modes.empty()) {
        arguments.options.modes = experiments::timingModesNamed(arguments.modes);
    }
    requireJsonWritable(arguments.output);
    for (const std::filesystem::path& path : {arguments.csv, arguments.trace}) {
        if (!path.empty()) {
            host::requireWritable(path);
        }
    }
    if (!arguments.plot.empty()) {
        experiments::requirePlottable(arguments.plot);
    }
}

nlohmann::ordered_json makeDocument(const Session& session, const TimingArguments& arguments,
                                    const Results& results) {
    const experiments::TimingOptions& options = arguments.options;
    auto document =
        host::makeDocument("timing", session.documentDevice(),
                           {{"width", options.width},
                            {"height", options.height},
                            {"frames", options.frames},
                            {"warm_up_frames", experiments::kWarmUpFrames},
                            {"threads", options.threads},
                            {"seed", options.seed},
                            {"scene", "64,000 unit cubes in a 400^3 field, 60 degrees, near 0.1, far "
                                      "100,000, one turn about y"},
                            {"frames_in_flight", options.framesInFlight},
                            {"mode", options.framesInFlight > 1 ? "throughput" : "latency"}});
    for (const auto& result : results) {
        document["results"].push_back(toJson(result));
    }
    document["noise_floor_pct"] = results.at(1).overheadPercent;
    document["noise_floor_ci95"] = toJson(results.at(1)).at("ci95");
    return document;
}

void run(const GlobalOptions& global, TimingArguments& arguments) {
    checkArguments(arguments);
    std::optional<host::Trace> trace;
    if (!arguments.trace.empty()) {
        arguments.options.trace = &trace.emplace(arguments.options.threads);
    }
    const Session session(global);
    const Console console(global, arguments.output);
    const Results results =
        experiments::runTiming(session.device(), arguments.options, [&](std::size_t done, std::size_t all) {
            console.progress(done, all, "frames of every mode");
        });
    console.endProgress();
    session.requireSilentValidation();

    printTable(console, results);
    console.line(fmt::format("\n{}; {} frames a mode after {} dropped, seed {}, {} threads, {}x{}; commit {}",
                             describe(session.device()), arguments.options.frames, experiments::kWarmUpFrames,
                             arguments.options.seed, arguments.options.threads, arguments.options.width,
                             arguments.options.height, host::buildInfo().commit));
    console.line(fmt::format("Noise floor, standard over itself: {:+.2f} %, 95 % {:+.2f} to {:+.2f}",
                             results.at(1).overheadPercent, results.at(1).overheadPercent95.low,
                             results.at(1).overheadPercent95.high));
    if (!arguments.csv.empty()) {
        writeCsv(arguments.csv, results);
    }
    if (!arguments.plot.empty()) {
        experiments::writePlot(arguments.plot, experiments::timingPlot(results, describe(session.device())));
    }
    if (trace) {
        trace->write(arguments.trace);
    }
    writeJson(arguments.output, makeDocument(session, arguments, results));
}

} // namespace

void addTiming(CLI::App& program, const GlobalOptions& global) {
    CLI::App* command = program.add_subcommand(
        "timing", "What each technique costs over standard, frame by frame (Figure 6.4)");
    auto arguments = std::make_shared<TimingArguments>();
    experiments::TimingOptions& options = arguments->options;
    command->add_option("--frames", options.frames, "Measured frames of every mode")
        ->check(CLI::Range(1u, kMaxFrames))
        ->capture_default_str();
    command->add_option("--size", arguments->size, "WIDTHxHEIGHT in pixels")->capture_default_str();
    command->add_option("--threads", options.threads, "Threads that cull, bin and record")
        ->check(CLI::Range(std::size_t{1}, host::WorkerPool::kMaxThreads))
        ->capture_default_str();
    command
        ->add_option("--in-flight", options.framesInFlight,
                     "Frames in flight: 1 times latency, as the thesis; more time throughput")
        ->check(CLI::Range(std::size_t{1}, render::kMaxFramesInFlight))
        ->capture_default_str();
    command->add_option("--seed", options.seed, "Seed of the scene, the orders and the bootstrap")
        ->capture_default_str();
    command
        ->add_option(
            "--modes", arguments->modes,
            "Only these beside standard, such as cdr-2,log,logcdr-5; also naive and standard/NAME with a "
            "batching or submission")
        ->delimiter(',');
    command->add_option("--csv", arguments->csv, "Write the results as CSV to FILE");
    command->add_option("--plot", arguments->plot, "Draw the figure into a .png or .svg file, by gnuplot");
    command->add_option("--trace", arguments->trace,
                        "Write the dropped frames as a trace for ui.perfetto.dev or chrome://tracing");
    addJson(*command, arguments->output);
    command->callback([&global, arguments] { run(global, *arguments); });
}

} // namespace cdr::cli
