#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace cdr::program {

/// SHA-256 of the bytes as 64 lower-case hexadecimal digits.
std::string sha256(std::span<const std::uint8_t> bytes);

/// sha256() of the bytes of a contiguous range of trivially copyable values, in memory order.
template <typename Range>
std::string sha256Of(const Range& values) {
    const auto bytes = std::as_bytes(std::span(values));
    return sha256({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
}

/// What a file holds, told by few bytes.
struct FileDigest {
    std::string sha256;       ///< as sha256() of its bytes
    std::uintmax_t bytes = 0; ///< its size
};

/// Reads the file in parts, so a large one takes no memory. InputError when it is missing, not a regular file, larger than
/// `maxBytes`, or cannot be read to its end.
FileDigest digestOfFile(const std::filesystem::path& path, std::uintmax_t maxBytes);

} // namespace cdr::program
