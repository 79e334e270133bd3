#include "against.h"

#include "timing_document.h"

#include <cdr/base/format_error.h>
#include <cdr/platform/file.h>

#include <fmt/format.h>
#include <output/readable.h>
#include <program/child_process.h>
#include <runs/shuffled_order.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace cdr::experiments {

namespace {

namespace fs = std::filesystem;

double childCpuUs() {
    rusage usage{};
    getrusage(RUSAGE_CHILDREN, &usage);
    const auto microseconds = [](const timeval& time) {
        return 1e6 * static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec);
    };
    return microseconds(usage.ru_utime) + microseconds(usage.ru_stime);
}

/// What a run said, and its CPU time.
struct Run {
    TimingDocument document;
    double cpuUs = 0.0;
};

TimingDocument documentIn(const fs::path& json, const fs::path& program) {
    const platform::Bytes bytes = platform::readFile(json, kMaxTimingBytes);
    return readTimingDocument({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, program.string());
}

Run runOnce(const fs::path& program, const AgainstOptions& options, const fs::path& json) {
    std::vector<std::string> arguments{program.string()};
    arguments.insert(arguments.end(), options.arguments.begin(), options.arguments.end());
    arguments.emplace_back(
        "--json"); // to standard output: a file that it opened itself could outlive this process
    const double before = childCpuUs();
    program::ChildProcess(arguments, {.file = json}).finish();
    Run run{.document = {}, .cpuUs = childCpuUs() - before};
    run.document = documentIn(json, program);
    return run;
}

/// Modes by name in the order of the results, then the whole run.
std::vector<std::pair<std::string, double>> timesOf(const Run& run) {
    auto times = run.document.medianUs;
    times.emplace_back(kWholeRun, run.cpuUs);
    return times;
}

double timeOf(const Run& run, const std::string& name, const fs::path& program) {
    for (const auto& [mode, us] : timesOf(run)) {
        if (mode == name) {
            return us;
        }
    }
    throw base::InputError(program.string() + " does not time the mode " + name);
}

void requireSameDevice(const Run& here, const Run& against, const fs::path& program) {
    for (const auto part : {&TimingDocument::device, &TimingDocument::driver}) {
        const std::string& ours = here.document.*part;
        const std::string& theirs = against.document.*part;
        if (ours != theirs) {
            throw base::inputError("{} draws with another device: {} instead of {}", program.string(), theirs,
                                   ours);
        }
    }
}

} // namespace

Comparison compare(const BuildTimes& times, std::uint64_t seed) {
    const std::size_t rounds = times.hereUs.size();
    if (rounds == 0 || times.againUs.size() != rounds || times.againstUs.size() != rounds) {
        throw base::InputError("a comparison needs a time of each build from every round");
    }
    std::vector<double> ratios;
    std::vector<double> noise;
    for (std::size_t round = 0; round < rounds; ++round) {
        ratios.push_back(times.hereUs[round] / times.againstUs[round]);
        noise.push_back(times.againUs[round] / times.hereUs[round]);
    }
    Comparison comparison{.name = times.name,
                          .hereUs = measure::median(times.hereUs),
                          .againstUs = measure::median(times.againstUs),
                          .ratio = measure::median(ratios),
                          .ratio95 = measure::bootstrapMedian(ratios, seed)};
    const std::optional<measure::Interval> noise95 = measure::bootstrapMedian(noise, seed);
    if (comparison.ratio95 && noise95) {
        comparison.noisePercent =
            100.0 * std::max(std::abs(noise95->low - 1.0), std::abs(noise95->high - 1.0));
        comparison.isSeen = !comparison.ratio95->contains(1.0) &&
                            100.0 * std::abs(comparison.ratio - 1.0) > *comparison.noisePercent;
    }
    return comparison;
}

std::string verdictOf(const Comparison& comparison) {
    if (!comparison.noisePercent) {
        return fmt::format("too few rounds to tell, {} are needed", measure::kMinIntervalSamples);
    }
    return comparison.isSeen
               ? fmt::format("{} times", output::Readable{comparison.ratio})
               : fmt::format("no difference seen, noise ±{} %", output::Readable{*comparison.noisePercent});
}

AgainstReport runAgainst(const AgainstOptions& options, const Progress& progress) {
    constexpr std::size_t kRuns = 3; // this build, the other, this build again
    if (!program::isInstalled(options.against.string())) {
        throw base::InputError(options.against.string() + " is not installed");
    }
    const platform::PendingFile json(platform::scratchPath(".json")); // never committed
    runs::ShuffledOrder order(kRuns, options.seed);
    AgainstReport report;
    std::vector<BuildTimes> times;
    for (std::uint32_t round = 0; round < options.rounds; ++round) {
        std::array<Run, kRuns> runs;
        std::size_t done = round * kRuns;
        for (const std::size_t run : order.next()) {
            progress(done++, options.rounds * kRuns);
            runs[run] = runOnce(run == 1 ? options.against : options.here, options, json.temporary());
        }
        requireSameDevice(runs[0], runs[1], options.against);
        if (round == 0) {
            for (const auto& [name, us] : timesOf(runs[0])) {
                times.push_back({.name = name, .hereUs = {}, .againUs = {}, .againstUs = {}});
            }
            report.againstCommit = runs[1].document.commit;
            report.device = runs[0].document.device;
            report.driver = runs[0].document.driver;
        }
        for (BuildTimes& row : times) {
            row.hereUs.push_back(timeOf(runs[0], row.name, options.here));
            row.againstUs.push_back(timeOf(runs[1], row.name, options.against));
            row.againUs.push_back(timeOf(runs[2], row.name, options.here));
        }
    }
    for (const BuildTimes& row : times) {
        report.comparisons.push_back(compare(row, options.seed));
    }
    return report;
}

} // namespace cdr::experiments
