#pragma once

#include "shared_options.h"

#include <CLI/CLI.hpp>

namespace cdr::cli {

/// Adds its command to the program; the command runs when it is chosen.
using AddCommand = void(CLI::App& program, const GlobalOptions& global);
AddCommand addView, addDevices, addRender, addPrecision, addPictures, addFlicker, addProbe, addAdvise,
    addTiming, addScaling, addCoplanar, addDetail, addOrbit, addTranslucency, addEffects, addFocus,
    addShadows, addModels, addRivals, addInspect, addReport;

/// The commands that measure. A report is made of all of them but `models`.
AddCommand addExperiments;

/// Completions and the manual page, made from all commands of the program. The first rank prints them.
void addShellCommands(CLI::App& program, const ranks::Ranks& ranks);

} // namespace cdr::cli
