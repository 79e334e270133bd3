#pragma once

#include <cli/command.h>
#include <experiments/timing/against.h>
#include <experiments/timing/timing.h>

#include <program/machine_state.h>
#include <rivals/rival.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace cdr::cli {

/// What `timing` was given.
struct TimingArguments {
    program::MachineState machine; ///< before anything is timed
    experiments::TimingOptions options;
    std::vector<std::string> modes;
    std::filesystem::path csv;
    std::filesystem::path plot;
    std::filesystem::path trace;
    std::filesystem::path against;
    std::uint32_t rounds = experiments::AgainstOptions{}.rounds;
    std::vector<rivals::NamedRival> rivalsBeside;
    bool stages = false;
    bool memory = false;
    std::optional<std::uint32_t> frames; ///< none: what suits what is timed
};

/// Frames of each run of a build, unless given.
inline constexpr std::uint32_t kRunFrames = 40;
/// Frames of each mode whose stages are measured, unless given.
inline constexpr std::uint32_t kStageFrames = 100;

// Each measures, prints and writes what its option asks for.

/// Without --against, --stages and --memory: every mode over standard.
void timeModes(Command& command, TimingArguments& arguments);
/// --against: this build and another one.
void timeAgainst(const Command& command, const TimingArguments& arguments);
/// --stages: what each stage of a frame costs.
void timeStages(Command& command, const TimingArguments& arguments);
/// --memory: bytes of an instance, a draw and a pixel.
void measureMemory(Command& command, const TimingArguments& arguments);

} // namespace cdr::cli
