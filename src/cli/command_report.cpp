#include "command.h"
#include "commands.h"
#include "forecast.h"

#include <cdr/base/enum_names.h>
#include <cdr/base/error.h>
#include <cdr/host/child_process.h>
#include <cdr/host/file.h>
#include <cdr/host/standard_streams.h>
#include <cdr/host/worker_pool.h>
#include <experiments/readable.h>
#include <report/folder.h>
#include <report/page.h>
#include <report/plan.h>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <filesystem>

namespace cdr::cli {

void addExperiments(CLI::App& program, const GlobalOptions& global) {
    addPrecision(program, global);
    addPictures(program, global);
    addFlicker(program, global);
    addProbe(program, global);
    addAdvise(program, global);
    addTiming(program, global);
    addScaling(program, global);
    addDetail(program, global);
    addCoplanar(program, global);
    addTranslucency(program, global);
    addShadows(program, global);
    addEffects(program, global);
    addFocus(program, global);
    addOrbit(program, global);
    addInspect(program, global);
}

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMaxJsonBytes = 200'000'000;

struct ReportArguments {
    report::PlanOptions plan;
    fs::path folder = "report";
};

/// What one section came to.
struct SectionOutcome {
    double seconds = 0.0;
    std::string failure;             ///< empty when it went well
    nlohmann::ordered_json document; ///< null when there is none
};

/// Runs the very command that the page prints.
void runCommand(const GlobalOptions& global, std::vector<std::string> command) {
    CLI::App program;
    program.require_subcommand(1);
    addExperiments(program, global);
    std::reverse(command.begin(), command.end()); // as CLI11 takes them
    program.parse(std::move(command));
}

/// A section that fails (a format the device lacks, a disk that is full) leaves the others their page.
SectionOutcome runSection(const GlobalOptions& global, const report::Section& section, const fs::path& root) {
    SectionOutcome outcome;
    const auto start = std::chrono::steady_clock::now();
    try {
        runCommand(global, section.commandIn(root));
    } catch (const std::exception& error) {
        outcome.failure = error.what();
    }
    outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (const fs::path json = root / section.jsonFile(); fs::exists(json)) {
        outcome.document = nlohmann::ordered_json::parse(host::readFile(json, kMaxJsonBytes));
    }
    return outcome;
}

nlohmann::ordered_json describe(const report::Section& section, const SectionOutcome& outcome,
                                const GlobalOptions& global) {
    nlohmann::ordered_json row{{"section", section.name},
                               {"command", report::commandLine(section, global.device)},
                               {"seconds", outcome.seconds},
                               {"folder", section.folder},
                               {"json", nullptr},
                               {"failure", nullptr}};
    if (!outcome.document.is_null()) {
        row["json"] = section.jsonFile().generic_string();
    }
    if (!outcome.failure.empty()) {
        row["failure"] = outcome.failure;
    }
    return row;
}

constexpr base::EnumNames<report::Effort, 3> kEfforts{"effort", {"smallest", "quick", "full"}};

nlohmann::ordered_json makeManifest(const Command& command, const report::PlanOptions& options) {
    nlohmann::ordered_json manifest = command.makeDocument(
        {{"effort", kEfforts.nameOf(options.effort)}, {"threads", options.threads}, {"seed", options.seed}});
    manifest["videos"] = options.videos;
    manifest["made_at"] = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
    return manifest;
}

/// At once, into files and pipes too.
void sayNow(const Console& console, const std::string& line) {
    console.line(line);
    host::flushStandardOutput();
}

/// Runs the plan into a folder; the results and the page's data go there too.
nlohmann::ordered_json fillFolder(Command& command, const ReportArguments& arguments,
                                  report::PendingFolder& folder) {
    const GlobalOptions& global = command.global();
    const Console& console = command.console();
    const fs::path& root = folder.temporary();
    const std::vector<report::Section> plan = report::makePlan(arguments.plan);
    nlohmann::ordered_json manifest = makeManifest(command, arguments.plan);
    nlohmann::ordered_json documents = nlohmann::ordered_json::object();
    fs::create_directory(root / "data");
    Forecast forecast(plan, measuredPace(command.device(), arguments.plan.threads));
    if (!arguments.plan.videos) {
        console.line("No videos: ffmpeg is not installed (Debian, Ubuntu: ffmpeg)");
    }
    sayNow(console, fmt::format("{} sections, about {}", plan.size(), timeText(forecast.secondsLeft())));
    for (std::size_t i = 0; i < plan.size(); ++i) {
        const report::Section& section = plan[i];
        GlobalOptions inside = global;
        inside.section = fmt::format("{}/{} {}, {} to go", i + 1, plan.size(), section.name,
                                     timeText(forecast.secondsLeft()));
        const SectionOutcome outcome = runSection(inside, section, root);
        folder.keep();
        console.endProgress();
        forecast.done(section, outcome.seconds);
        sayNow(console, fmt::format("{}/{} {}: {} s{}", i + 1, plan.size(), section.name,
                                    experiments::Readable{outcome.seconds},
                                    outcome.failure.empty() ? "" : ", failed: " + outcome.failure));
        manifest["results"].push_back(describe(section, outcome, global));
        documents[section.name] = outcome.document;
    }
    report::writePage(root);
    report::writeData(root, {{"report", manifest}, {"sections", documents}});
    manifest["files"] = nlohmann::ordered_json::array();
    for (const fs::path& file : report::filesUnder(root)) {
        manifest["files"].push_back(file.generic_string());
    }
    host::writeDocument(root / report::kManifest, manifest);
    return manifest;
}

/// base::InputError when --json names a file in the report, which holds nothing but its own files.
void requireOutside(const fs::path& folder, const OutputOptions& output) {
    if (!output.json || *output.json == "-") {
        return;
    }
    const fs::path inside = fs::weakly_canonical(fs::absolute(*output.json))
                                .lexically_relative(fs::weakly_canonical(fs::absolute(folder)));
    if (!inside.empty() && *inside.begin() != "..") {
        throw base::InputError(
            fmt::format("{}: lies in the report, which holds its own files alone", output.json->string()));
    }
}

void runReport(Command& command, ReportArguments& arguments) {
    report::requirePage();
    arguments.plan.videos = host::isInstalled("ffmpeg");
    requireOutside(arguments.folder, command.output());
    report::PendingFolder folder(arguments.folder);
    command.opened(); // without a device there is no report
    nlohmann::ordered_json manifest;
    try {
        manifest = fillFolder(command, arguments, folder);
        folder.commit();
    } catch (const std::exception& error) {
        if (!folder.isKept()) {
            throw;
        }
        throw base::RunError(
            fmt::format("{}; what was measured is in {}", error.what(), folder.temporary().string()));
    }
    command.console().line(fmt::format("Open {}", (arguments.folder / "index.html").string()));
    command.writeDocument(manifest);
    for (const auto& row : manifest.at("results")) {
        if (!row.at("failure").is_null()) {
            throw base::RunError(fmt::format("{}: {}; the report says so too",
                                             row.at("section").get<std::string>(),
                                             row.at("failure").get<std::string>()));
        }
    }
}

void addReportOptions(CLI::App& command, ReportArguments& arguments) {
    const auto effort = [&](const char* name, report::Effort value, const char* help) {
        return command.add_flag_callback(
            name, [&arguments, value] { arguments.plan.effort = value; }, help);
    };
    CLI::Option* quick = effort("--quick", report::Effort::quick, "A few frames of each: minutes (default)");
    CLI::Option* full = effort("--full", report::Effort::full, "The thesis' own numbers of frames: hours");
    CLI::Option* smallest =
        effort("--smallest", report::Effort::smallest, "As little as fills a page, for its tests");
    quick->excludes(full)->excludes(smallest);
    full->excludes(smallest);
    command.add_option("-o,--out", arguments.folder, "Folder of the report; an older report is replaced")
        ->capture_default_str();
    addThreads(command, arguments.plan.threads, "Threads that cull, bin, record and cast the truth");
    addSeed(command, arguments.plan.seed, "Seed of everything random");
}

} // namespace

void addReport(CLI::App& program, const GlobalOptions& global) {
    addCommand<ReportArguments>(
        program, global, "report",
        "Every experiment in one folder with a page that opens offline, the thesis beside it",
        addReportOptions, runReport);
}

} // namespace cdr::cli
