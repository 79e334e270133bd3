#include "command.h"
#include "commands.h"
#include "forecast.h"
#include "report_sections.h"

#include <cdr/base/format_error.h>
#include <cdr/platform/file.h>
#include <report/folder.h>
#include <report/manifest.h>
#include <report/page.h>
#include <report/plan.h>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <options/parsed_option.h>
#include <output/document.h>
#include <program/child_process.h>

#include <cstdint>
#include <ctime>
#include <filesystem>
#include <string>
#include <vector>

namespace cdr::cli {

void addExperiments(CLI::App& program, const GlobalOptions& global) {
    for (AddCommand* add : {addPrecision, addPictures, addFlicker, addProbe, addAdvise, addTiming, addScaling,
                            addDetail, addCoplanar, addTranslucency, addShadows, addEffects, addFocus,
                            addOrbit, addInspect, addModels, addRivals}) {
        add(program, global);
    }
}

namespace {

namespace fs = std::filesystem;

struct ReportArguments {
    report::PlanOptions plan;
    fs::path folder = "report";
    fs::path state;
};

nlohmann::ordered_json describe(const report::Section& section, const output::Json& outcome,
                                const GlobalOptions& global) {
    const bool hasDocument = !outcome.at("document").is_null();
    return {{"section", section.name},
            {"command", report::commandLine(section, global.device)},
            {"seconds", outcome.at("seconds")},
            {"folder", section.folder},
            {"json", hasDocument ? output::Json(section.jsonFile().generic_string()) : output::Json(nullptr)},
            {"failure", outcome.at("failure")}};
}

nlohmann::ordered_json makeManifest(const Command& command, const report::PlanOptions& options) {
    nlohmann::ordered_json manifest =
        command.makeDocument({{"effort", report::kEfforts.nameOf(options.effort)},
                              {"threads", options.threads},
                              {"seed", options.seed},
                              {"sections", options.sections}});
    const std::string& device = command.global().device;
    if (!device.empty()) {
        manifest["options"]["device"] = device;
    }
    manifest["command_line"] = report::commandLine(options, device);
    manifest["videos"] = options.videos;
    manifest["made_at"] = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
    return manifest;
}

/// The page, its data and the manifest, which it returns.
nlohmann::ordered_json writeReport(const Command& command, const report::PlanOptions& options,
                                   const std::vector<report::Section>& plan,
                                   const std::vector<output::Json>& outcomes, const fs::path& root) {
    nlohmann::ordered_json manifest = makeManifest(command, options);
    nlohmann::ordered_json documents = nlohmann::ordered_json::object();
    for (std::size_t i = 0; i < plan.size(); ++i) {
        manifest["results"].push_back(describe(plan[i], outcomes[i], command.global()));
        documents[plan[i].name] = outcomes[i].at("document");
    }
    report::writePage(root);
    report::writeData(root, {{"report", manifest}, {"sections", documents}});
    manifest["files"] = nlohmann::ordered_json::array();
    for (const fs::path& file : report::filesUnder(root)) {
        manifest["files"].push_back(file.generic_string());
    }
    output::writeDocument(root / report::kManifest, manifest);
    return manifest;
}

/// Runs the plan into the first rank's folder, and writes the report there. The manifest; null on other ranks.
/// @param folder of the first rank; null on others, which see it.
nlohmann::ordered_json fillFolder(Command& command, const report::PlanOptions& options,
                                  report::PendingFolder* folder) {
    std::string root;
    if (folder != nullptr) {
        root = fs::absolute(folder->temporary()).string();
        if (runs::KeptRanks* kept = command.keptRanks(); kept != nullptr) {
            takeUpSections(*kept, root);
        }
        fs::create_directory(fs::path(root) / "data");
        if (!options.videos) {
            command.console().line("No videos: ffmpeg is not installed (Debian, Ubuntu: ffmpeg)");
        }
    }
    const platform::Bytes shared = command.ranks().share({root.begin(), root.end()});
    root.assign(shared.begin(), shared.end());
    const std::vector<report::Section> plan = report::makePlan(options);
    const double pace = folder != nullptr ? measuredPace(command.device(), options.threads) : 1.0;
    SectionRunner runner(command, plan, root, pace);
    runner.runAll([&] { folder->keep(); });
    return folder != nullptr ? writeReport(command, options, plan, runner.outcomes(), root)
                             : nlohmann::ordered_json();
}

/// base::InputError when a file lies in the report, which holds nothing but its own files.
void requireOutside(const fs::path& folder, const fs::path& file) {
    if (file.empty() || file == "-") {
        return;
    }
    const fs::path inside = platform::wholePath(file).lexically_relative(platform::wholePath(folder));
    if (!inside.empty() && *inside.begin() != "..") {
        throw base::inputError(
            "{}: lies in the folder of the report, which may only hold files of the report", file.string());
    }
}

/// Writes the report; the manifest, which is null on other ranks than the first.
nlohmann::ordered_json makeReport(Command& command, const ReportArguments& arguments) {
    if (!command.ranks().isFirst()) {
        return fillFolder(command, arguments.plan, nullptr);
    }
    const std::string state = arguments.state.empty() ? "" : platform::wholePath(arguments.state).string();
    report::PendingFolder folder(arguments.folder, state);
    command.opened(); // without a device there is no report
    try {
        nlohmann::ordered_json manifest = fillFolder(command, arguments.plan, &folder);
        folder.commit();
        return manifest;
    } catch (const std::exception& error) {
        if (!folder.isKept()) {
            throw;
        }
        throw base::runError("{}; what was measured is in {}", error.what(), folder.temporary().string());
    }
}

void runReport(Command& command, ReportArguments& arguments) {
    report::requirePage();
    report::makePlan(arguments.plan); // refuses an unknown section before all else
    const platform::Bytes hasVideos =
        command.ranks().share({program::isInstalled("ffmpeg") ? std::uint8_t{1} : std::uint8_t{0}});
    arguments.plan.videos = hasVideos.front() != 0;
    requireOutside(arguments.folder, command.output().json.value_or(""));
    requireOutside(arguments.folder, arguments.state);
    command.readsEarth(scenes::orbitFiles()); // for sections that open it on some rank
    command.keepUnits(arguments.state, arguments.plan.videos ? "videos" : "");
    const nlohmann::ordered_json manifest = makeReport(command, arguments);
    if (!command.ranks().isFirst()) {
        return;
    }
    command.console().line(fmt::format("Open {}", (arguments.folder / "index.html").string()));
    command.writeDocument(manifest);
    for (const auto& row : manifest.at("results")) {
        if (!row.at("failure").is_null()) {
            throw base::runError("{}: {}; the rest of the report is written",
                                 row.at("section").get<std::string>(), row.at("failure").get<std::string>());
        }
    }
}

void addReportOptions(CLI::App& command, ReportArguments& arguments) {
    const auto effort = [&](const char* name, report::Effort value, const char* help) {
        return command.add_flag_callback(
            name, [&arguments, value] { arguments.plan.effort = value; }, help);
    };
    CLI::Option* quick =
        effort("--quick", report::Effort::quick, "Render a few frames per experiment, in minutes (default)");
    CLI::Option* full =
        effort("--full", report::Effort::full, "Render as many frames as the thesis, in hours");
    CLI::Option* smallest =
        effort("--smallest", report::Effort::smallest, "Render as little as possible, to test the page");
    quick->excludes(full)->excludes(smallest);
    full->excludes(smallest);
    options::addFolder(command, "-o,--out", arguments.folder,
                       "Folder of the report; an older report is replaced")
        ->capture_default_str();
    command
        .add_option("--sections", arguments.plan.sections,
                    "Sections to write, separated by commas, such as precision,shadows,certificates-orbit")
        ->delimiter(',')
        ->default_str("all");
    addThreads(command, arguments.plan.threads);
    addSeed(command, arguments.plan.seed);
    addState(command, arguments.state);
}

} // namespace

void addReport(CLI::App& program, const GlobalOptions& global) {
    addCommand<ReportArguments>(
        program, global, "report",
        "Run all experiments but models, and write a page that opens offline and shows the thesis' results too",
        addReportOptions, runReport, RankUse::all);
}

} // namespace cdr::cli
