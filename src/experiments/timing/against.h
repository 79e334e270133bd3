#pragma once

#include <cdr/measure/statistics/statistics.h>
#include <experiments/progress.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace cdr::experiments {

/// Two builds of this program that time the same frames in turns.
struct AgainstOptions {
    std::filesystem::path here;         ///< this program
    std::filesystem::path against;      ///< the other build
    std::vector<std::string> arguments; ///< both get them
    std::uint32_t rounds = 9;           ///< in each, the other build runs once and this one twice
    std::uint64_t seed = 2013;          ///< of the orders and the bootstrap
};

/// What one figure was, round by round.
struct BuildTimes {
    std::string name; ///< a mode, or kWholeRun
    std::vector<double> hereUs;
    std::vector<double> againUs; ///< of this build's second run
    std::vector<double> againstUs;
};

/// The CPU time of a whole run, start and warm-up included, in place of a mode's frame time. It counts no waiting.
inline constexpr const char* kWholeRun = "run, CPU time";

/// This build over the other.
struct Comparison {
    std::string name;
    double hereUs = 0.0; ///< median
    double againstUs = 0.0;
    double ratio = 1.0;                         ///< median of the rounds' ratios
    std::optional<measure::Interval> ratio95{}; ///< bootstrapped
    /// This build over itself: how far from 1 the same interval reaches.
    std::optional<double> noisePercent{};
    /// The interval leaves out 1, and the ratio differs from it by more than the noise. Never without an interval.
    bool isSeen = false;
};

/// base::InputError unless each has a value per round, and at least one.
Comparison compare(const BuildTimes& times, std::uint64_t seed);
/// "0.84 times", "no difference seen, noise ±3.1 %", or that there are too few rounds.
std::string verdictOf(const Comparison& comparison);

struct AgainstReport {
    std::vector<Comparison> comparisons;
    std::string againstCommit;
    std::string device; ///< that both drew with
    std::string driver;
};

/// base::InputError where the other build times no mode of that name, or on another device; base::RunError where a run
/// fails.
AgainstReport runAgainst(const AgainstOptions& options, const Progress& progress);

} // namespace cdr::experiments
