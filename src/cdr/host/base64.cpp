#include <cdr/host/base64.h>

#include <openssl/evp.h>

#include <algorithm>
#include <limits>

namespace cdr::host {

std::string toBase64(std::span<const std::uint8_t> bytes) {
    constexpr std::size_t kPart = 3u << 20u;                // of whole groups, and in the range of an int
    std::string text((bytes.size() + 2) / 3 * 4 + 1, '\0'); // OpenSSL ends each part with a zero
    std::size_t size = 0;
    for (; !bytes.empty(); bytes = bytes.subspan(std::min(kPart, bytes.size()))) {
        size += static_cast<std::size_t>(EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data() + size),
                                                         bytes.data(),
                                                         static_cast<int>(std::min(kPart, bytes.size()))));
    }
    text.resize(size);
    return text;
}

std::optional<Bytes> fromBase64(std::string_view text) {
    constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (int padding = 0; padding < 2 && text.ends_with('='); ++padding) {
        text.remove_suffix(1);
    }
    if (text.size() % 4 == 1 || text.size() > std::numeric_limits<int>::max() - 4u ||
        text.find_first_not_of(kDigits) != std::string_view::npos) {
        return {}; // OpenSSL would skip blanks at both ends
    }
    Bytes padded(text.begin(), text.end());
    padded.resize((text.size() + 3) / 4 * 4, '=');
    Bytes bytes(padded.size() / 4 * 3);
    if (EVP_DecodeBlock(bytes.data(), padded.data(), static_cast<int>(padded.size())) < 0) {
        return {};
    }
    bytes.resize(text.size() * 3 / 4); // padding counts as zeros
    return bytes;
}

} // namespace cdr::host
