#include "timing_command.h"

#include <cdr/base/error.h>
#include <cdr/platform/process.h>
#include <experiments/timing/tables.h>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <output/columns.h>
#include <program/build_info.h>

namespace cdr::cli {

namespace {

/// What the other build and this one are run with.
std::vector<std::string> runArguments(const Command& command, const TimingArguments& arguments) {
    const experiments::TimingOptions& options = arguments.options;
    std::vector<std::string> all{"--quiet"};
    if (const std::string& device = command.global().device; !device.empty()) {
        all.insert(all.end(), {"--device", device});
    }
    if (command.global().validate) {
        all.emplace_back("--validate");
    }
    all.insert(all.end(),
               {"timing", "--frames", std::to_string(arguments.frames.value_or(kRunFrames)), "--size",
                fmt::format("{}x{}", options.width, options.height), "--threads",
                std::to_string(options.threads), "--seed", std::to_string(options.seed), "--modes",
                arguments.modes.empty() ? "standard" : fmt::format("{}", fmt::join(arguments.modes, ","))});
    return all;
}

} // namespace

void timeAgainst(const Command& command, const TimingArguments& arguments) {
    const std::optional<std::filesystem::path> own = platform::ownProgram();
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

} // namespace cdr::cli
