#pragma once

#include <exception>
#include <string>

namespace cdr::gpu {

/// What ends a program: what it says on standard error and what it returns.
struct Failure {
    static constexpr int kFailed = 1;   ///< while running
    static constexpr int kBadInput = 2; ///< nothing was begun

    int status = kFailed;
    std::string line; ///< one, whatever the error's text holds
};

/// Of an exception that nothing on the way could mend: base::InputError is bad input, all else, Vulkan's
/// errors and exhausted memory among it, a failure.
/// @param error not null.
Failure failureOf(const std::exception_ptr& error);

} // namespace cdr::gpu
