#pragma once

#include "shared_options.h"

#include <CLI/CLI.hpp>

namespace cdr::cli {

/// Each adds its command to the program; the command runs when it is chosen.
void addView(CLI::App& program, const GlobalOptions& global);
void addDevices(CLI::App& program, const GlobalOptions& global);
void addRender(CLI::App& program, const GlobalOptions& global);
void addPrecision(CLI::App& program, const GlobalOptions& global);
void addPictures(CLI::App& program, const GlobalOptions& global);
void addFlicker(CLI::App& program, const GlobalOptions& global);
void addProbe(CLI::App& program, const GlobalOptions& global);
void addAdvise(CLI::App& program, const GlobalOptions& global);
void addTiming(CLI::App& program, const GlobalOptions& global);
void addScaling(CLI::App& program, const GlobalOptions& global);
void addCoplanar(CLI::App& program, const GlobalOptions& global);
void addDetail(CLI::App& program, const GlobalOptions& global);
void addOrbit(CLI::App& program, const GlobalOptions& global);
void addTranslucency(CLI::App& program, const GlobalOptions& global);
void addEffects(CLI::App& program, const GlobalOptions& global);
void addFocus(CLI::App& program, const GlobalOptions& global);
void addShadows(CLI::App& program, const GlobalOptions& global);
void addModels(CLI::App& program, const GlobalOptions& global);
void addRivals(CLI::App& program, const GlobalOptions& global);
void addInspect(CLI::App& program, const GlobalOptions& global);
void addReport(CLI::App& program, const GlobalOptions& global);

/// The commands that measure. A report is made of all of them but `models`.
void addExperiments(CLI::App& program, const GlobalOptions& global);

/// Completions and the manual page, made from all commands of the program. The first rank prints them.
void addShellCommands(CLI::App& program, const ranks::Ranks& ranks);

} // namespace cdr::cli
