#include <cdr/base/error.h>
#include <cdr/platform/standard_streams.h>

#include <cerrno>
#include <cstdio>
#include <system_error>

namespace cdr::platform {

namespace {

[[noreturn]] void failToWrite() {
    const int error = errno;
    throw base::RunError("standard output: write failed" +
                         (error != 0 ? ": " + std::generic_category().message(error) : std::string()));
}

} // namespace

void printOutput(const std::string& text) {
    errno = 0;
    if (std::fputs(text.c_str(), stdout) < 0) {
        failToWrite();
    }
}

void flushStandardOutput() {
    errno = 0;
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
        failToWrite();
    }
}

void printNow(const std::string& text) {
    printOutput(text);
    flushStandardOutput();
}

void printError(const std::string& line) noexcept {
    std::fprintf(stderr, "%s\n", line.c_str()); // one write, so that lines of several processes stay whole
}

} // namespace cdr::platform
