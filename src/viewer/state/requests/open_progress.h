#pragma once

#include <cstddef>
#include <string>

namespace cdr::viewer {

/// How much of a file the render thread has opened.
struct OpenProgress {
    std::string file; ///< as it was named
    std::size_t done = 0;
    std::size_t all = 1; ///< above 0
};

/// A line that says so in percent.
std::string textOf(const OpenProgress& progress);

} // namespace cdr::viewer
