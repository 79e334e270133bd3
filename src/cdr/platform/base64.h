#pragma once

#include <cdr/platform/file.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace cdr::platform {

/// The bytes as base64, padded, without line ends.
std::string toBase64(std::span<const std::uint8_t> bytes);

/// The bytes of base64, padded or not; nothing where the text is none.
std::optional<Bytes> fromBase64(std::string_view text);

} // namespace cdr::platform
