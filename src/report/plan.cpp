#include "plan.h"

#include "plan_table.h"

#include <cdr/base/format_error.h>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <program/child_process.h>

#include <algorithm>
#include <optional>

namespace cdr::report {

namespace {

/// A command of this program, as a shell takes it.
std::string lineOf(const std::vector<std::string>& words, std::string_view device) {
    std::string line = "cdr";
    if (!device.empty()) {
        line += " --device " + program::shellQuoted(device);
    }
    for (const std::string& word : words) {
        line += " " + program::shellQuoted(word);
    }
    return line;
}

/// An option's value; nothing where it is a flag.
std::optional<std::string> valueOf(const PlanOption& option, const PlanOptions& plan) {
    if (option.values.empty()) {
        return std::nullopt;
    }
    const std::size_t effort = option.values.size() > 1 ? static_cast<std::size_t>(plan.effort) : 0;
    const std::string& value = option.values.at(effort);
    if (value == kThreads) {
        return std::to_string(plan.threads);
    }
    return value == kSeed ? std::to_string(plan.seed) : value;
}

double secondsOf(const PlanRow& row, Effort effort) {
    constexpr double kSmallestShare = 1.0 / 50.0;
    return effort == Effort::full ? row.seconds.full
                                  : row.seconds.quick * (effort == Effort::quick ? 1.0 : kSmallestShare);
}

Section sectionOf(const PlanRow& row, const PlanOptions& plan) {
    Section section{.name = row.name,
                    .arguments = {row.command.empty() ? row.name : row.command},
                    .folderOption = row.out.option,
                    .folder = row.out.folder,
                    .isTimed = row.isTimed,
                    .expectedSeconds = secondsOf(row, plan.effort)};
    for (const PlanOption& option : row.options) {
        const std::optional<std::string> value = valueOf(option, plan);
        if (value == "") {
            continue;
        }
        if (!option.name.empty()) {
            section.arguments.push_back(option.name);
        }
        if (value) {
            section.arguments.push_back(*value);
        }
    }
    if (row.out.option == kVideos && !plan.videos) {
        section.folderOption.clear();
        section.folder.clear();
    }
    return section;
}

bool isNamedBy(const std::string& section, const std::string& name) {
    return section == name || section.starts_with(name + "-");
}

void requireSections(const std::vector<std::string>& names) {
    const auto& rows = planTable();
    for (const std::string& name : names) {
        if (std::ranges::none_of(rows, [&](const PlanRow& row) { return isNamedBy(row.name, name); })) {
            std::vector<std::string> known;
            std::ranges::transform(rows, std::back_inserter(known), &PlanRow::name);
            throw base::inputError("--sections: '{}' is not one of {}", name, fmt::join(known, ", "));
        }
    }
}

} // namespace

std::filesystem::path Section::jsonFile() const {
    return std::filesystem::path("data") / (name + ".json");
}

std::vector<std::string> Section::commandIn(const std::filesystem::path& root) const {
    std::vector<std::string> command = arguments;
    if (!folderOption.empty()) {
        command.insert(command.end(), {folderOption, (root / folder).string()});
    }
    command.insert(command.end(), {"--json", (root / jsonFile()).string()});
    return command;
}

std::vector<Section> makePlan(const PlanOptions& options) {
    requireSections(options.sections);
    const auto isWanted = [&](const PlanRow& row) {
        return options.sections.empty() ||
               std::any_of(options.sections.begin(), options.sections.end(),
                           [&](const std::string& name) { return isNamedBy(row.name, name); });
    };
    std::vector<Section> plan;
    for (const PlanRow& row : planTable()) {
        if (isWanted(row)) {
            plan.push_back(sectionOf(row, options));
        }
    }
    return plan;
}

std::string commandLine(const Section& section, std::string_view device) {
    return lineOf(section.commandIn(""), device);
}

std::string commandLine(const PlanOptions& options, std::string_view device) {
    std::vector<std::string> words{"report", fmt::format("--{}", kEfforts.nameOf(options.effort))};
    if (!options.sections.empty()) {
        words.insert(words.end(), {"--sections", fmt::format("{}", fmt::join(options.sections, ","))});
    }
    words.insert(words.end(), {"--threads", std::to_string(options.threads), "--seed",
                               std::to_string(options.seed), "-o", "."});
    return lineOf(words, device);
}

} // namespace cdr::report
