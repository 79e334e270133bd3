#pragma once

#include <algorithm>
#include <array>
#include <cerrno>

namespace cdr::platform {

/// Whether a call failed with `error` though its caller asked for nothing wrong: a full disk, a broken one, no descriptor left.
inline bool isOfTheSystem(int error) {
    constexpr std::array kOfTheSystem{ENOSPC, EDQUOT, EIO, EMFILE, ENFILE, ENOMEM};
    return std::find(kOfTheSystem.begin(), kOfTheSystem.end(), error) != kOfTheSystem.end();
}

} // namespace cdr::platform
