#pragma once

#include <string>

namespace cdr::viewer {

/// Writes a line to standard output at once, for a test that reads it while the viewer runs.
void printLine(const std::string& line);

} // namespace cdr::viewer
