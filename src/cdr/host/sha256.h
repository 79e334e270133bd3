#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace cdr::host {

/// SHA-256 of the bytes as 64 lower-case hexadecimal digits.
std::string sha256(std::span<const std::uint8_t> bytes);

/// sha256() of the bytes of a contiguous range of trivially copyable values, in memory order.
template <typename Range>
std::string sha256Of(const Range& values) {
    const auto bytes = std::as_bytes(std::span(values));
    return sha256({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
}

} // namespace cdr::host
