#include "print_line.h"

#include <cdr/base/standard_streams.h>

namespace cdr::viewer {

void printLine(const std::string& line) {
    base::printOutput(line + "\n");
    base::flushStandardOutput();
}

} // namespace cdr::viewer
