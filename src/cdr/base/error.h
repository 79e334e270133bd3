#pragma once

#include <cdr/base/export.h>

#include <stdexcept>
#include <string>

#if !defined(__cpp_exceptions)
#include <cstdio>
#include <cstdlib>
#endif

/// Errors, results, names and numbers as text. All other rooms use it.
/// @threads Functions keep nothing: any thread may call them, many at once.
namespace cdr::base {

/// The caller's fault: an argument, a file, or a limit that was exceeded. Programs exit with status 2.
class CDR_EXPORT InputError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// A valid request failed while running: device lost, disk full, out of memory. Programs exit with status 1.
class CDR_EXPORT RunError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Throws an InputError or a RunError. Compiled without exceptions, it prints the message and aborts: such programs
/// call the function's form that returns a Result.
/// @throws Error with the message, always.
template <typename Error>
[[noreturn]] void raise(const std::string& message) {
#if defined(__cpp_exceptions)
    throw Error(message);
#else
    std::fprintf(stderr, "%s\n", message.c_str());
    std::abort();
#endif
}

} // namespace cdr::base
