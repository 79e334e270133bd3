#include "command.h"
#include "commands.h"
#include "forecast.h"
#include "rank_machine.h"

#include <cdr/base/enum_names.h>
#include <cdr/base/error.h>
#include <cdr/host/child_process.h>
#include <cdr/host/file.h>
#include <cdr/host/standard_streams.h>
#include <cdr/host/worker_pool.h>
#include <experiments/readable.h>
#include <experiments/units.h>
#include <report/folder.h>
#include <report/page.h>
#include <report/plan.h>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <ranks/one_process.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <ctime>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

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

/// Runs sections of a plan into a folder, on this rank, as one process does.
class SectionRunner {
  public:
    SectionRunner(const Command& command, const std::vector<report::Section>& plan, fs::path root,
                  double pace)
        : m_command(command),
          m_plan(plan),
          m_root(std::move(root)),
          m_forecast(plan, pace),
          m_outcomes(plan.size()) {}

    void sayPlan() const {
        sayNow(m_command.console(),
               fmt::format("{} sections, about {}", m_plan.size(), timeText(m_forecast.secondsLeft())));
    }

    SectionOutcome run(std::size_t section) {
        GlobalOptions inside = m_command.global();
        inside.ranks = &m_alone;
        inside.section = fmt::format("{}/{} {}, {} to go", m_done + 1, m_plan.size(), m_plan[section].name,
                                     timeText(m_forecast.secondsLeft()));
        if (inside.device == "each") {
            inside.device = dealtDevice(m_command.ranks().place());
        }
        return runSection(inside, m_plan[section], m_root);
    }

    /// On the first rank, in any order.
    void add(std::size_t section, SectionOutcome outcome) {
        const Console& console = m_command.console();
        console.endProgress();
        m_forecast.done(m_plan[section], outcome.seconds);
        sayNow(console, fmt::format("{}/{} {}: {} s{}", ++m_done, m_plan.size(), m_plan[section].name,
                                    experiments::Readable{outcome.seconds},
                                    outcome.failure.empty() ? "" : ", failed: " + outcome.failure));
        m_outcomes[section] = std::move(outcome);
    }

    /// By section.
    const std::vector<SectionOutcome>& outcomes() const { return m_outcomes; }

  private:
    const Command& m_command;
    const std::vector<report::Section>& m_plan;
    fs::path m_root;
    ranks::OneProcess m_alone;
    Forecast m_forecast;
    std::size_t m_done = 0;
    std::vector<SectionOutcome> m_outcomes;
};

experiments::Json packedOutcome(SectionOutcome outcome) {
    return {{"seconds", outcome.seconds},
            {"failure", std::move(outcome.failure)},
            {"document", std::move(outcome.document)}};
}

SectionOutcome unpackedOutcome(experiments::Json made) {
    return {.seconds = made.at("seconds").get<double>(),
            .failure = made.at("failure").get<std::string>(),
            .document = std::move(made.at("document"))};
}

/// Which sections measure time, or do not, in the order of the plan.
std::vector<std::size_t> sectionsThat(const std::vector<report::Section>& plan, bool areTimed) {
    std::vector<std::size_t> sections;
    for (std::size_t i = 0; i < plan.size(); ++i) {
        if (plan[i].isTimed == areTimed) {
            sections.push_back(i);
        }
    }
    return sections;
}

/// Ranks share the sections. Those that measure time are the first rank's, which runs them last, while the others wait.
/// @param keep called on the first rank after each.
void runSections(ranks::Ranks& ranks, const std::vector<report::Section>& plan, SectionRunner& runner,
                 const std::function<void()>& keep) {
    const std::vector<std::size_t> shared = sectionsThat(plan, false);
    experiments::forEachUnit(
        ranks, shared.size(), [&](std::size_t unit) { return packedOutcome(runner.run(shared[unit])); },
        [&](std::size_t unit, experiments::Json made) {
            runner.add(shared[unit], unpackedOutcome(std::move(made)));
            keep();
        });
    if (ranks.isFirst()) {
        for (const std::size_t section : sectionsThat(plan, true)) {
            runner.add(section, runner.run(section));
            keep();
        }
    }
}

/// The page, its data and the manifest, which it returns.
nlohmann::ordered_json writeReport(const Command& command, const report::PlanOptions& options,
                                   const std::vector<report::Section>& plan,
                                   const std::vector<SectionOutcome>& outcomes, const fs::path& root) {
    nlohmann::ordered_json manifest = makeManifest(command, options);
    nlohmann::ordered_json documents = nlohmann::ordered_json::object();
    for (std::size_t i = 0; i < plan.size(); ++i) {
        manifest["results"].push_back(describe(plan[i], outcomes[i], command.global()));
        documents[plan[i].name] = outcomes[i].document;
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

/// Runs the plan into the first rank's folder, and writes the report there. The manifest; null on other ranks.
/// @param folder of the first rank; null on others, which see it.
nlohmann::ordered_json fillFolder(Command& command, const report::PlanOptions& options,
                                  report::PendingFolder* folder) {
    std::string root;
    if (folder != nullptr) {
        root = fs::absolute(folder->temporary()).string();
        fs::create_directory(fs::path(root) / "data");
        if (!options.videos) {
            command.console().line("No videos: ffmpeg is not installed (Debian, Ubuntu: ffmpeg)");
        }
    }
    const host::Bytes shared = command.ranks().share({root.begin(), root.end()});
    root.assign(shared.begin(), shared.end());
    const std::vector<report::Section> plan = report::makePlan(options);
    const double pace = folder != nullptr ? measuredPace(command.device(), options.threads) : 1.0;
    SectionRunner runner(command, plan, root, pace);
    runner.sayPlan();
    runSections(command.ranks(), plan, runner, [&] { folder->keep(); });
    return folder != nullptr ? writeReport(command, options, plan, runner.outcomes(), root)
                             : nlohmann::ordered_json();
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

/// Writes the report; the manifest, which is null on other ranks than the first.
nlohmann::ordered_json makeReport(Command& command, const ReportArguments& arguments) {
    if (!command.ranks().isFirst()) {
        return fillFolder(command, arguments.plan, nullptr);
    }
    report::PendingFolder folder(arguments.folder);
    command.opened(); // without a device there is no report
    try {
        nlohmann::ordered_json manifest = fillFolder(command, arguments.plan, &folder);
        folder.commit();
        return manifest;
    } catch (const std::exception& error) {
        if (!folder.isKept()) {
            throw;
        }
        throw base::RunError(
            fmt::format("{}; what was measured is in {}", error.what(), folder.temporary().string()));
    }
}

void runReport(Command& command, ReportArguments& arguments) {
    report::requirePage();
    const host::Bytes hasVideos =
        command.ranks().share({host::isInstalled("ffmpeg") ? std::uint8_t{1} : std::uint8_t{0}});
    arguments.plan.videos = hasVideos.front() != 0;
    requireOutside(arguments.folder, command.output());
    const nlohmann::ordered_json manifest = makeReport(command, arguments);
    if (!command.ranks().isFirst()) {
        return;
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
        addReportOptions, runReport, RankUse::all);
}

} // namespace cdr::cli
