#pragma once

#include "session.h"

#include <CLI/CLI.hpp>

namespace cdr::cli {

/// Each adds its command to the program; the command runs when it is chosen.
void addDevices(CLI::App& program, const GlobalOptions& global);
void addRender(CLI::App& program, const GlobalOptions& global);
void addPrecision(CLI::App& program, const GlobalOptions& global);
void addPictures(CLI::App& program, const GlobalOptions& global);
void addFlicker(CLI::App& program, const GlobalOptions& global);
void addProbe(CLI::App& program, const GlobalOptions& global);
void addAdvise(CLI::App& program, const GlobalOptions& global);
void addTiming(CLI::App& program, const GlobalOptions& global);
void addScaling(CLI::App& program, const GlobalOptions& global);
void addDetail(CLI::App& program, const GlobalOptions& global);
void addOrbit(CLI::App& program, const GlobalOptions& global);
void addTranslucency(CLI::App& program, const GlobalOptions& global);
void addEffects(CLI::App& program, const GlobalOptions& global);
void addFocus(CLI::App& program, const GlobalOptions& global);
void addReport(CLI::App& program, const GlobalOptions& global);

/// The commands that a report is made of: all that measure.
void addExperiments(CLI::App& program, const GlobalOptions& global);

/// Adds `--json [FILE]`; without a file, or with "-", JSON goes to standard output and the table to standard
/// error.
void addJson(CLI::App& command, OutputOptions& output);

/// base::InputError when --json names a file that cannot be written; call before long work.
void requireJsonWritable(const OutputOptions& output);

/// "1280x720". base::InputError for anything that is not two whole numbers above 0.
struct PictureSize {
    std::uint32_t width = 1280;
    std::uint32_t height = 720;
};
PictureSize parseSize(const std::string& text);

/// Most frames one call renders.
inline constexpr std::uint32_t kMaxFrames = 1'000'000;

/// Most MiB that --translucency-memory takes: 4 TiB.
inline constexpr std::uint64_t kMostTranslucencyMiB = std::uint64_t{1} << 22u;

} // namespace cdr::cli
