#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

namespace cdr::base {

using Bytes = std::vector<std::uint8_t>;

/// Reads a whole regular file. InputError when it is missing, not a regular file, or larger than `maxBytes`.
Bytes readFile(const std::filesystem::path& path, std::uintmax_t maxBytes);

/// A file in the making: written under a temporary name beside `path`, and put in place whole by commit(). It
/// is removed when it goes out of scope before that.
class PendingFile {
  public:
    /// base::InputError when `path` names a folder.
    explicit PendingFile(std::filesystem::path path);
    ~PendingFile();
    PendingFile(const PendingFile&) = delete;
    PendingFile& operator=(const PendingFile&) = delete;

    /// Where to write; it has the extension of the path.
    const std::filesystem::path& temporary() const { return m_temporary; }

    /// Renames the temporary file over the path. base::InputError when that fails.
    void commit() const;

  private:
    std::filesystem::path m_path;
    std::filesystem::path m_temporary;
};

/// Lets `write` fill a temporary file beside `path`, then renames it over `path`: either the whole file
/// appears or nothing does. InputError when the folder is missing or not writable; whatever `write` throws
/// passes through.
void writeBesideThenRename(const std::filesystem::path& path,
                           const std::function<void(const std::filesystem::path& temporary)>& write);

/// writeBesideThenRename() of bytes in memory.
void writeFile(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);

/// writeFile() of a text as it is.
void writeText(const std::filesystem::path& path, std::string_view text);

/// InputError unless a file can be created at `path`. Leaves nothing behind; call before long work.
void requireWritable(const std::filesystem::path& path);

/// Makes a folder and those above it where they are missing. base::InputError when that fails.
void makeFolder(const std::filesystem::path& path);

} // namespace cdr::base
