#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cdr::experiments {

/// What is read of the JSON of a `timing` run. Another build may have written it, or any other program.
struct TimingDocument {
    std::string commit; ///< "unknown" where it names none
    std::string device; ///< that it drew with, empty where it names none
    std::string driver; ///< likewise
    std::vector<std::pair<std::string, double>>
        medianUs; ///< modes by name, in the order of the results; over 0
};

/// Bounds of what is read. Documents of this program stay far below them.
inline constexpr std::uintmax_t kMaxTimingBytes = std::uintmax_t{1} << 24u;
inline constexpr std::size_t kMaxTimingRows = 4096;
inline constexpr std::size_t kMaxTimingText = 256; ///< bytes of a name

/// The document that a text holds.
/// @param program that wrote it, which a message begins with.
/// base::InputError, in one line, where it is no document of `timing`, or a value has not its type or range.
TimingDocument readTimingDocument(std::string_view text, const std::string& program);

} // namespace cdr::experiments
