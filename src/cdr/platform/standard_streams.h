#pragma once

#include <string>

namespace cdr::platform {

/// Prints on standard output. RunError when that could not be written.
void printOutput(const std::string& text);

/// Writes out what was printed on standard output. RunError when some of it could not be written, now or
/// before.
void flushStandardOutput();

/// Prints on standard output and writes it out at once, into files and pipes too. RunError as both.
void printNow(const std::string& text);

/// Prints a line on standard error. Does nothing if that fails, since there is no other place for an error.
void printError(const std::string& line) noexcept;

} // namespace cdr::platform
