#include "data_uri.h"

#include <cdr/platform/base64.h>

#include <algorithm>
#include <array>

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

} // namespace

std::optional<platform::Bytes> decodeDataUri(std::string_view uri) {
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
    std::optional<platform::Bytes> bytes = platform::fromBase64(uri.substr(end + kEncoding.size()));
    return bytes && !bytes->empty() ? bytes : std::nullopt;
}

} // namespace cdr::scene::gltf
