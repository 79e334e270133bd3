#include "data_uri.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace cdr::scene::gltf {

namespace {

/// Buffers and images; `text/plain` is what some writers call a buffer.
constexpr std::array<std::string_view, 7> kMediaTypes{"application/octet-stream",
                                                      "application/gltf-buffer",
                                                      "image/png",
                                                      "image/jpeg",
                                                      "image/bmp",
                                                      "image/gif",
                                                      "text/plain"};

/// The value of a base64 digit; nothing for another character.
std::optional<std::uint32_t> base64Digit(char c) {
    const auto from = [c](char first, std::uint32_t value) {
        return value + static_cast<std::uint32_t>(c - first);
    };
    if (c >= 'A' && c <= 'Z') {
        return from('A', 0);
    }
    if (c >= 'a' && c <= 'z') {
        return from('a', 26);
    }
    if (c >= '0' && c <= '9') {
        return from('0', 52);
    }
    return c == '+' ? std::optional(62u) : c == '/' ? std::optional(63u) : std::nullopt;
}

std::optional<host::Bytes> decodeBase64(std::string_view text) {
    for (int padding = 0; padding < 2 && text.ends_with('='); ++padding) {
        text.remove_suffix(1);
    }
    if (text.size() % 4 == 1) {
        return {};
    }
    host::Bytes bytes;
    bytes.reserve(text.size() / 4 * 3 + 2);
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        const std::optional<std::uint32_t> digit = base64Digit(c);
        if (!digit) {
            return {};
        }
        bits = bits << 6 | *digit;
        count += 6;
        if (count >= 8) {
            count -= 8;
            bytes.push_back(static_cast<std::uint8_t>(bits >> count & 0xff));
        }
    }
    return bytes;
}

} // namespace

std::optional<host::Bytes> decodeDataUri(std::string_view uri) {
    constexpr std::string_view kScheme = "data:";
    constexpr std::string_view kEncoding = ";base64,";
    const std::size_t end = uri.find(kEncoding);
    if (!uri.starts_with(kScheme) || end == std::string_view::npos) {
        return {};
    }
    const std::string_view mediaType = uri.substr(kScheme.size(), end - kScheme.size());
    if (std::find(kMediaTypes.begin(), kMediaTypes.end(), mediaType) == kMediaTypes.end()) {
        return {};
    }
    std::optional<host::Bytes> bytes = decodeBase64(uri.substr(end + kEncoding.size()));
    return bytes && !bytes->empty() ? bytes : std::nullopt;
}

} // namespace cdr::scene::gltf
