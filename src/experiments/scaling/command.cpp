#include <cdr/base/error.h>
#include <cdr/host/file.h>
#include <cli/commands.h>
#include <cli/console.h>
#include <experiments/gnuplot.h>
#include <experiments/scaling/scaling.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>

namespace cdr::cli {

namespace {

struct ScalingArguments {
    experiments::ScalingOptions options;
    std::string size = "640x360";
    std::vector<std::string> targets;
    std::vector<std::string> submissions;
    std::filesystem::path csv;
    std::filesystem::path plot;
    OutputOptions output;
};

nlohmann::ordered_json toJson(const experiments::ScalingPoint& point) {
    return {{"targets", nameOf(point.targets)},
            {"submission", nameOf(point.submission)},
            {"cascades", point.cascades},
            {"threads", point.threads},
            {"cubes", point.cubes},
            {"draws", point.draws},
            {"cull_ms", point.cull.medianMs},
            {"bin_ms", point.bin.medianMs},
            {"record_ms", point.record.medianMs},
            {"record_ns_per_draw", point.recordNsPerDraw()},
            {"execute_ms", point.execute.medianMs},
            {"frame_ms", point.frame.medianMs},
            {"speedup", point.recordSpeedUp},
            {"efficiency", point.efficiency()},
            {"cull_bin_speedup", point.cullAndBinSpeedUp},
            {"frame_speedup", point.frameSpeedUp},
            {"spread",
             {{"cull", point.cull.spread},
              {"bin", point.bin.spread},
              {"record", point.record.spread},
              {"execute", point.execute.spread},
              {"frame", point.frame.spread}}},
            {"hash", point.hash},
            {"same_image", point.sameImage}};
}

nlohmann::ordered_json toJson(const experiments::ScalingFit& fit) {
    nlohmann::ordered_json json{{"targets", nameOf(fit.targets)},    {"submission", nameOf(fit.submission)},
                                {"cascades", fit.cascades},          {"cubes", fit.cubes},
                                {"amdahl_serial_fraction", nullptr}, {"usl_contention", nullptr},
                                {"usl_coherence", nullptr}};
    if (fit.serialFraction) {
        json["amdahl_serial_fraction"] = *fit.serialFraction;
    }
    if (fit.universal) {
        json["usl_contention"] = fit.universal->contention;
        json["usl_coherence"] = fit.universal->coherence;
    }
    return json;
}

void printTables(const Console& console, const experiments::ScalingResult& result) {
    std::vector<std::vector<std::string>> rows;
    for (const auto& p : result.points) {
        const auto ms = [](const experiments::Spread& time) { return fmt::format("{:.3f}", time.medianMs); };
        rows.push_back({std::string(nameOf(p.targets)), std::string(nameOf(p.submission)),
                        std::to_string(p.cascades), std::to_string(p.draws), std::to_string(p.threads),
                        ms(p.cull), ms(p.bin), ms(p.record), fmt::format("{:.0f} %", 100.0 * p.record.spread),
                        fmt::format("{:.0f}", p.recordNsPerDraw()), ms(p.execute), ms(p.frame),
                        fmt::format("{:.2f}", p.recordSpeedUp), fmt::format("{:.2f}", p.efficiency()),
                        p.sameImage ? "same" : "DIFFERS"});
    }
    console.table({"targets", "submission", "cascades", "draws", "threads", "cull ms", "bin ms", "record ms",
                   "+-", "ns/draw", "execute ms", "frame ms", "speed-up", "efficiency", "image"},
                  rows);
    rows.clear();
    for (const auto& fit : result.fits) {
        rows.push_back({std::string(nameOf(fit.targets)), std::string(nameOf(fit.submission)),
                        std::to_string(fit.cascades), std::to_string(fit.cubes),
                        fit.serialFraction ? fmt::format("{:.3f}", *fit.serialFraction) : "",
                        fit.universal ? fmt::format("{:.3f}", fit.universal->contention) : "",
                        fit.universal ? fmt::format("{:.4f}", fit.universal->coherence) : ""});
    }
    console.line("\nHow recording scales, fitted:");
    console.table({"targets", "submission", "cascades", "cubes", "serial fraction (Amdahl)",
                   "contention (USL)", "coherence (USL)"},
                  rows);
}

void writeCsv(const std::filesystem::path& path, const experiments::ScalingResult& result) {
    std::string csv =
        "targets,submission,cascades,threads,cubes,draws,cull_ms,bin_ms,record_ms,record_spread,"
        "record_ns_per_draw,execute_ms,frame_ms,speedup,efficiency,cull_bin_speedup,frame_speedup,"
        "hash,same_image\n";
    for (const auto& p : result.points) {
        csv += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", nameOf(p.targets),
                           nameOf(p.submission), p.cascades, p.threads, p.cubes, p.draws, p.cull.medianMs,
                           p.bin.medianMs, p.record.medianMs, p.record.spread, p.recordNsPerDraw(),
                           p.execute.medianMs, p.frame.medianMs, p.recordSpeedUp, p.efficiency(),
                           p.cullAndBinSpeedUp, p.frameSpeedUp, p.hash, p.sameImage);
    }
    host::writeText(path, csv);
}

/// What can be wrong with the arguments, before anything is made.
void checkArguments(ScalingArguments& arguments) {
    const PictureSize size = parseSize(arguments.size);
    arguments.options.width = size.width;
    arguments.options.height = size.height;
    if (!arguments.targets.empty()) {
        arguments.options.targets.clear();
        for (const std::string& name : arguments.targets) {
            arguments.options.targets.push_back(render::parseTargets(name));
        }
    }
    if (!arguments.submissions.empty()) {
        arguments.options.submissions.clear();
        for (const std::string& name : arguments.submissions) {
            arguments.options.submissions.push_back(render::parseSubmission(name));
        }
    }
    experiments::requireUsable(arguments.options);
    requireJsonWritable(arguments.output);
    if (!arguments.csv.empty()) {
        host::requireWritable(arguments.csv);
    }
    if (!arguments.plot.empty()) {
        experiments::requirePlottable(arguments.plot);
    }
}

void writeResults(const Session& session, const ScalingArguments& arguments,
                  const experiments::ScalingResult& result) {
    const experiments::ScalingOptions& options = arguments.options;
    if (!arguments.csv.empty()) {
        writeCsv(arguments.csv, result);
    }
    if (!arguments.plot.empty()) {
        experiments::writePlot(arguments.plot, experiments::scalingPlot(result, describe(session.device())));
    }
    auto document =
        host::makeDocument("scaling", session.documentDevice(),
                           {{"width", options.width},
                            {"height", options.height},
                            {"repeats", options.repeats},
                            {"placement", options.placement == host::Placement::pinned ? "pinned" : "free"},
                            {"seed", options.seed}});
    auto& fits = host::addSection(document, "fits");
    for (const auto& point : result.points) {
        document["results"].push_back(toJson(point));
    }
    for (const auto& fit : result.fits) {
        fits.push_back(toJson(fit));
    }
    writeJson(arguments.output, document);
}

void run(const GlobalOptions& global, ScalingArguments& arguments) {
    checkArguments(arguments);
    const Session session(global);
    const Console console(global, arguments.output);
    const experiments::ScalingResult result = experiments::runScaling(
        session.device(), arguments.options, [&](std::size_t done, std::size_t all, const std::string& what) {
            console.progress(done, all, what);
        });
    console.endProgress();
    session.requireSilentValidation();

    printTables(console, result);
    console.line(fmt::format(
        "\n{}; medians of {} frames a point, +- the quartiles' distance, seed {}, {}x{}; commit {}",
        describe(session.device()), arguments.options.repeats, arguments.options.seed,
        arguments.options.width, arguments.options.height, host::buildInfo().commit));
    writeResults(session, arguments, result);
    const auto differs = std::find_if(result.points.begin(), result.points.end(),
                                      [](const auto& point) { return !point.sameImage; });
    if (differs != result.points.end()) {
        throw base::RunError(
            fmt::format("{} targets, {} cascades, {} draws: {} threads draw another image than one",
                        nameOf(differs->targets), differs->cascades, differs->draws, differs->threads));
    }
}

} // namespace

void addScaling(CLI::App& program, const GlobalOptions& global) {
    CLI::App* command =
        program.add_subcommand("scaling", "How culling, binning and recording scale with threads");
    auto arguments = std::make_shared<ScalingArguments>();
    experiments::ScalingOptions& options = arguments->options;
    command->add_option("--draws", options.draws, "Numbers of cubes, such as 1000,50000")
        ->delimiter(',')
        ->capture_default_str();
    command
        ->add_option("--threads", options.threads,
                     "Numbers of threads, such as 1,2,4; 1 joins in any case (default: to twice the CPUs)")
        ->delimiter(',');
    command->add_option("--targets", arguments->targets, "Kinds of targets (default: all)")->delimiter(',');
    command
        ->add_option("--submissions", arguments->submissions,
                     "How draws reach the device: secondaries, primaries (the control; both by default), "
                     "gpu-driven")
        ->delimiter(',');
    command->add_flag_callback(
        "--free", [&options] { options.placement = host::Placement::free; },
        "Let the kernel place threads, instead of pinning each to a CPU");
    command->add_option("--cascades", options.cascades, "Numbers of cascades")
        ->delimiter(',')
        ->capture_default_str();
    command->add_option("--repeats", options.repeats, "Timed frames of each point")->capture_default_str();
    command->add_option("--size", arguments->size, "WIDTHxHEIGHT in pixels")->capture_default_str();
    command->add_option("--seed", options.seed, "Seed of the scene")->capture_default_str();
    command->add_option("--csv", arguments->csv, "Write the results as CSV to FILE");
    command->add_option("--plot", arguments->plot, "Plot into a .png or .svg file, by gnuplot");
    addJson(*command, arguments->output);
    command->callback([&global, arguments] { run(global, *arguments); });
}

} // namespace cdr::cli
