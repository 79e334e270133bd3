#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace cdr::viewer {

/// "1 flip", "2 flips".
std::string counted(std::uint64_t count, std::string_view noun);

/// "24.51 ms".
std::string millisecondsText(double ms);

/// What to say of a picture that has been waited for so long; nothing below half a second.
std::string lagText(double seconds);

} // namespace cdr::viewer
