#pragma once

#include <exception>
#include <string>

namespace cdr::gpu {

/// How a program ends: its line on standard error and its exit status.
struct Failure {
    static constexpr int kFailed = 1;   ///< while running
    static constexpr int kBadInput = 2; ///< before any work

    int status = kFailed;
    std::string line; ///< a single one, even if the error's text has several
};

/// The failure that an uncaught exception stands for: base::InputError is bad input. All else, such as errors
/// of Vulkan and exhausted memory, is a failed run.
/// @param error not null.
Failure failureOf(const std::exception_ptr& error);

} // namespace cdr::gpu
