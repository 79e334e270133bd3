#include "data_uri.h"

#include <openssl/evp.h>

#include <algorithm>
#include <array>
#include <limits>

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

std::optional<host::Bytes> decodeBase64(std::string_view text) {
    constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (int padding = 0; padding < 2 && text.ends_with('='); ++padding) {
        text.remove_suffix(1);
    }
    if (text.size() % 4 == 1 || text.size() > std::numeric_limits<int>::max() - 4u ||
        text.find_first_not_of(kDigits) != std::string_view::npos) {
        return {}; // OpenSSL would skip blanks at both ends
    }
    host::Bytes padded(text.begin(), text.end());
    padded.resize((text.size() + 3) / 4 * 4, '=');
    host::Bytes bytes(padded.size() / 4 * 3);
    if (EVP_DecodeBlock(bytes.data(), padded.data(), static_cast<int>(padded.size())) < 0) {
        return {};
    }
    bytes.resize(text.size() * 3 / 4); // padding counts as zeros
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
