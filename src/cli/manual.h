#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace cdr::cli {

/// A program's manual page, for man: what its help says of every command.
std::string manualOf(const CLI::App& program, const std::string& version);

} // namespace cdr::cli
