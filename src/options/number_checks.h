#pragma once

#include <CLI/CLI.hpp>

namespace cdr::options {

/// Of an option that takes a number from `least` to `most`. CLI11's own lets NaN through.
CLI::Validator numberFrom(double least, double most);

/// Of an option that takes a whole number, 0 to 2^64 - 1. CLI11 alone takes -1 for 2^64 - 1, and so all that is too
/// large.
CLI::Validator wholeNumber();

} // namespace cdr::options
