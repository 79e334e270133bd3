#pragma once

#include <CLI/CLI.hpp>

namespace cdr::options {

/// Of an option that takes a number from `least` to `most`. CLI11's own lets NaN through.
CLI::Validator numberFrom(double least, double most);

/// Reads the whole numbers of all options that a program and its commands have in decimal: "010" is ten. Another base, such as
/// "0x10", is refused. CLI11 alone takes a leading zero for octal. Those of unsigned options are from 0 to 2^64 - 1.
void takeDecimals(CLI::App& program);

} // namespace cdr::options
