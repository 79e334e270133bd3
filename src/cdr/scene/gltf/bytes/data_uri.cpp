#include "data_uri.h"

#include "../checks.h"

#include <cdr/platform/base64.h>

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

namespace cdr::scene::gltf {

namespace {

constexpr std::string_view kDataScheme = "data:";
constexpr std::string_view kBase64 = ";base64";

/// Buffers and images; `text/plain` is what some writers call a buffer.
constexpr std::array<std::string_view, 7> kMediaTypes{"application/octet-stream",
                                                      "application/gltf-buffer",
                                                      "image/png",
                                                      "image/jpeg",
                                                      "image/bmp",
                                                      "image/gif",
                                                      "text/plain"};

/// Whether two texts are the same but for the case of ASCII letters.
bool isAlike(std::string_view a, std::string_view b) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
    return std::ranges::equal(a, b, [&](char x, char y) { return lower(x) == lower(y); });
}

[[noreturn]] void refuseData(std::string_view uri, const std::string& why) {
    refuse("data URI '{}' cannot be decoded: {}", oneLine(uri, 40), why);
}

/// What is written before the comma, without the scheme and `;base64`.
std::string_view mediaTypeOf(std::string_view uri, std::string_view head) {
    const std::size_t length = head.size() - std::min(head.size(), kBase64.size());
    if (!isAlike(head.substr(length), kBase64)) {
        refuseData(uri, "it is not base64");
    }
    return head.substr(0, length);
}

} // namespace

bool isDataUri(std::string_view uri) {
    return isAlike(uri.substr(0, kDataScheme.size()), kDataScheme);
}

platform::Bytes decodeDataUri(std::string_view uri) {
    const std::size_t comma = std::min(uri.find(','), uri.size());
    const std::string_view type =
        mediaTypeOf(uri, uri.substr(kDataScheme.size(), comma - kDataScheme.size()));
    if (std::ranges::none_of(kMediaTypes, [&](std::string_view known) { return isAlike(known, type); })) {
        refuseData(uri, fmt::format("'{}' is no media type of a buffer or a picture; those are {}",
                                    oneLine(type, 40), fmt::join(kMediaTypes, ", ")));
    }
    const std::string_view text = uri.substr(std::min(comma + 1, uri.size()));
    std::optional<platform::Bytes> bytes = platform::fromBase64(text);
    if (!bytes || bytes->empty()) {
        refuseData(uri, text.empty() ? "nothing follows the comma" : "what follows the comma is not base64");
    }
    return *std::move(bytes);
}

} // namespace cdr::scene::gltf
