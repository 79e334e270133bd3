#include "print_line.h"

#include <cdr/host/standard_streams.h>

namespace cdr::viewer {

void printLine(const std::string& line) {
    host::printOutput(line + "\n");
    host::flushStandardOutput();
}

} // namespace cdr::viewer
