#pragma once

#include <stdexcept>
#include <string>

namespace cdr::base {

/// The caller's fault: an argument, a file, or a limit that was exceeded. Programs exit with status 2.
class InputError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// A valid request failed while running: device lost, disk full, out of memory. Programs exit with status 1.
class RunError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

} // namespace cdr::base
