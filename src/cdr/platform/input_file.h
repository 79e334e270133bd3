#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

namespace cdr::platform {

/// A regular file that is open for reading. Threads may share it.
class InputFile {
  public:
    /// InputError when it is missing, not a regular file, or larger than `maxBytes`.
    InputFile(const std::filesystem::path& path, std::uintmax_t maxBytes);
    ~InputFile();
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;

    /// Bytes, when it was opened.
    std::uintmax_t size() const { return m_size; }

    /// Fills `bytes` with what is in the file from `offset` on. False where not all of it can be read: the file has become
    /// shorter, or its device fails.
    [[nodiscard]] bool read(std::uintmax_t offset, std::span<std::uint8_t> bytes) const;

  private:
    int m_descriptor = -1;
    std::uintmax_t m_size = 0;
};

} // namespace cdr::platform
