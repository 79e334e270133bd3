#include <cdr/base/error.h>
#include <cdr/host/sha256.h>

#include <openssl/evp.h>

#include <array>

namespace cdr::host {

std::string sha256(std::span<const std::uint8_t> bytes) {
    std::array<unsigned char, 32> digest{};
    if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), nullptr, EVP_sha256(), nullptr) != 1) {
        throw base::RunError("EVP_Digest: SHA-256 is not available");
    }
    static constexpr char kDigits[] = "0123456789abcdef";
    std::string text;
    text.reserve(2 * digest.size());
    for (const unsigned char byte : digest) {
        text += kDigits[byte >> 4];
        text += kDigits[byte & 15];
    }
    return text;
}

} // namespace cdr::host
