#include "print_line.h"

#include <fmt/format.h>

#include <cstdio>

namespace cdr::viewer {

void printLine(const std::string& line) {
    fmt::print("{}\n", line);
    std::fflush(stdout);
}

} // namespace cdr::viewer
