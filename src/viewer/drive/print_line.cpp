#include "print_line.h"

#include <cdr/platform/standard_streams.h>

namespace cdr::viewer {

void printLine(const std::string& line) {
    platform::printOutput(line + "\n");
    platform::flushStandardOutput();
}

} // namespace cdr::viewer
