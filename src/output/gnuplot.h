#pragma once

#include <filesystem>
#include <string>

namespace cdr::output {

/// base::InputError unless `path` ends in .png or .svg, and gnuplot is installed. Call before long work.
void requirePlottable(const std::filesystem::path& path);

/// Draws a gnuplot script into a .png or .svg file, whole or not at all. gnuplot runs as a program of its
/// own, without a shell. The script says neither terminal nor output. base::RunError, with gnuplot's own
/// words, when it fails or has not written all of it.
void writePlot(const std::filesystem::path& path, const std::string& script);

/// Text as a gnuplot string, quoted; control characters become spaces.
std::string gnuplotQuote(const std::string& text);

} // namespace cdr::output
