#pragma once

#include <CLI/CLI.hpp>

#include <cstdint>
#include <string>
#include <string_view>

namespace cdr::cli {

enum class Shell : std::uint8_t { bash, zsh, fish };

/// base::InputError with a suggestion for an unknown name.
Shell parseShell(std::string_view name);

/// A script that makes a shell complete a program's commands and options.
std::string completionsOf(const CLI::App& program, Shell shell);

} // namespace cdr::cli
