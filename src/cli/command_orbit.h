#pragma once

#include "session.h"

#include <CLI/CLI.hpp>

namespace cdr::cli {

/// Adds the command `orbit`; as commands.h.
void addOrbit(CLI::App& program, const GlobalOptions& global);

} // namespace cdr::cli
