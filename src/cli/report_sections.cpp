#include "report_sections.h"

#include "commands.h"
#include "rank_machine.h"

#include <cdr/base/error.h>
#include <cdr/platform/file.h>
#include <cdr/platform/standard_streams.h>
#include <cdr/platform/stopwatch.h>
#include <report/folder.h>

#include <fmt/format.h>
#include <output/readable.h>
#include <program/sha256.h>
#include <runs/units.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <utility>

namespace cdr::cli {

namespace {

namespace fs = std::filesystem;
using output::Json;

constexpr std::uintmax_t kMaxJsonBytes = 200'000'000;

/// Runs the very command that the page prints.
void runCommand(const GlobalOptions& global, std::vector<std::string> command) {
    CLI::App program;
    program.require_subcommand(1);
    addRender(program, global);
    addExperiments(program, global);
    std::reverse(command.begin(), command.end()); // as CLI11 takes them
    program.parse(std::move(command));
}

/// Of a file that can be read.
std::optional<std::string> digestIn(const fs::path& root, const fs::path& file) {
    try {
        return program::digestOfFile(root / file, std::numeric_limits<std::uintmax_t>::max()).sha256;
    } catch (const base::InputError&) {
        return std::nullopt;
    }
}

/// By name, the digests of the files that a section has written.
Json filesOf(const report::Section& section, const fs::path& root) {
    std::vector<fs::path> files{section.jsonFile()};
    if (const fs::path folder = root / section.folder; !section.folder.empty()) {
        if (fs::is_directory(folder)) {
            for (const fs::path& file : report::filesUnder(folder)) {
                files.push_back(section.folder / file);
            }
        } else {
            files.emplace_back(section.folder);
        }
    }
    Json digests = Json::object();
    for (const fs::path& file : files) {
        if (fs::exists(root / file)) {
            digests[file.generic_string()] = digestIn(root, file);
        }
    }
    return digests;
}

/// A section that fails (a format the device lacks, a disk that is full) leaves the others their page.
Json runSection(const GlobalOptions& global, const report::Section& section, const fs::path& root) {
    Json outcome{{"seconds", 0.0}, {"failure", nullptr}, {"document", nullptr}};
    const platform::Stopwatch watch;
    try {
        runCommand(global, section.commandIn(root));
    } catch (const std::exception& error) {
        outcome["failure"] = error.what();
    }
    outcome["seconds"] = watch.seconds();
    if (const fs::path json = root / section.jsonFile(); fs::exists(json)) {
        outcome["document"] = Json::parse(platform::readFile(json, kMaxJsonBytes));
    }
    outcome["files"] = filesOf(section, root);
    return outcome;
}

/// At once, into files and pipes too.
void sayNow(const Console& console, const std::string& line) {
    console.line(line);
    platform::flushStandardOutput();
}

} // namespace

SectionRunner::SectionRunner(Command& command, const std::vector<report::Section>& plan, fs::path root,
                             double pace)
    : m_command(command),
      m_plan(plan),
      m_root(std::move(root)),
      m_forecast(plan, pace),
      m_outcomes(plan.size()) {
    sayNow(command.console(),
           fmt::format("{} sections, about {}", plan.size(), timeText(m_forecast.secondsLeft())));
}

void SectionRunner::runAll(const std::function<void()>& keep) {
    const auto runOf = [&](const std::vector<std::size_t>& sections) {
        return [&](std::size_t unit) { return run(sections[unit]); };
    };
    const auto addOf = [&](const std::vector<std::size_t>& sections) {
        return [&](std::size_t unit, Json made) {
            add(sections[unit], std::move(made));
            keep();
        };
    };
    std::vector<std::size_t> shared; // by all ranks; the others measure time
    std::vector<std::size_t> timed;
    for (std::size_t i = 0; i < m_plan.size(); ++i) {
        (m_plan[i].isTimed ? timed : shared).push_back(i);
    }
    runs::forEachUnit(m_command.ranks(), shared.size(), runOf(shared), addOf(shared));
    runs::forEachUnit(m_command.ranks(), timed.size(), runOf(timed), addOf(timed),
                      &ranks::Ranks::forEachUnitOnFirst);
}

Json SectionRunner::run(std::size_t section) {
    GlobalOptions inside = m_command.global();
    inside.ranks = &m_alone;
    inside.section = fmt::format("{}/{} {}, {} to go", m_done + 1, m_plan.size(), m_plan[section].name,
                                 timeText(m_forecast.secondsLeft()));
    inside.device = deviceOf(inside.device, m_command.ranks().place());
    return runSection(inside, m_plan[section], m_root);
}

/// On the first rank, in any order.
void SectionRunner::add(std::size_t section, Json outcome) {
    const Console& console = m_command.console();
    console.endProgress();
    const auto seconds = outcome.at("seconds").get<double>();
    const Json& failure = outcome.at("failure");
    m_forecast.done(m_plan[section], seconds);
    sayNow(console, fmt::format("{}/{} {}: {} s{}", ++m_done, m_plan.size(), m_plan[section].name,
                                output::Readable{seconds},
                                failure.is_null() ? "" : ", failed: " + failure.get<std::string>()));
    m_outcomes[section] = std::move(outcome);
}

void takeUpSections(runs::KeptRanks& kept, const fs::path& root) {
    std::set<std::string> own;
    kept.keepOnly([&](std::size_t, const platform::Bytes& made) {
        const Json outcome = Json::from_cbor(made);
        const auto& files = outcome.at("files").get_ref<const Json::object_t&>();
        const bool stands =
            outcome.at("failure").is_null() && std::all_of(files.begin(), files.end(), [&](const auto& file) {
                const std::optional<std::string> digest = digestIn(root, file.first);
                return digest && file.second == *digest;
            });
        for (const auto& [name, digest] : files) {
            if (stands) {
                own.insert(name);
            }
        }
        return stands;
    });
    for (const fs::path& file : report::filesUnder(root)) {
        if (!own.contains(file.generic_string())) {
            fs::remove(root / file);
        }
    }
}

} // namespace cdr::cli
