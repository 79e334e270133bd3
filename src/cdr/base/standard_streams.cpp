#include <cdr/base/error.h>
#include <cdr/base/standard_streams.h>

#include <cerrno>
#include <cstdio>
#include <iostream>
#include <system_error>

namespace cdr::base {

void flushStandardOutput() {
    errno = 0;
    const bool isWritten = std::cout.flush() && std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
    if (!isWritten) {
        const int error = errno;
        throw RunError("standard output: write failed" +
                       (error != 0 ? ": " + std::generic_category().message(error) : std::string()));
    }
}

void printError(const std::string& line) noexcept {
    std::fputs(line.c_str(), stderr);
    std::fputc('\n', stderr);
}

} // namespace cdr::base
