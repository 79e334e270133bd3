#include <cdr/base/error.h>
#include <cdr/platform/input_file.h>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <openssl/evp.h>
#include <program/sha256.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace cdr::program {

namespace {

constexpr std::uintmax_t kPartBytes = 1u << 20u;

/// The digest of bytes that come in parts.
class Sha256 {
  public:
    Sha256() {
        require(m_context != nullptr && EVP_DigestInit_ex(m_context.get(), EVP_sha256(), nullptr) == 1);
    }

    void add(std::span<const std::uint8_t> bytes) {
        require(EVP_DigestUpdate(m_context.get(), bytes.data(), bytes.size()) == 1);
    }

    std::string finish() {
        std::array<unsigned char, 32> digest{};
        require(EVP_DigestFinal_ex(m_context.get(), digest.data(), nullptr) == 1);
        return fmt::format("{:02x}", fmt::join(digest, ""));
    }

  private:
    static void require(bool isDone) {
        if (!isDone) {
            throw base::RunError("OpenSSL: SHA-256 is not available");
        }
    }

    std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> m_context{EVP_MD_CTX_new(), EVP_MD_CTX_free};
};

} // namespace

std::string sha256(std::span<const std::uint8_t> bytes) {
    Sha256 sha;
    sha.add(bytes);
    return sha.finish();
}

FileDigest digestOfFile(const std::filesystem::path& path, std::uintmax_t maxBytes) {
    const platform::InputFile file(path, maxBytes);
    Sha256 sha;
    std::vector<std::uint8_t> part(static_cast<std::size_t>(std::min(file.size(), kPartBytes)));
    for (std::uintmax_t offset = 0; offset < file.size(); offset += part.size()) {
        part.resize(static_cast<std::size_t>(std::min(file.size() - offset, kPartBytes)));
        if (!file.read(offset, part)) {
            throw base::InputError(path.string() + ": cannot be read");
        }
        sha.add(part);
    }
    return {.sha256 = sha.finish(), .bytes = file.size()};
}

} // namespace cdr::program
