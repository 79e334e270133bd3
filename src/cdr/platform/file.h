#pragma once

#include <cdr/base/export.h>
#include <cdr/platform/unfinished_file.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cdr::platform {

using Bytes = std::vector<std::uint8_t>;

/// A text of UTF-8 with spaces for the bytes of its control characters, line breaks among them.
CDR_EXPORT std::string withoutControls(std::string text);

/// A path as messages show it: one line, though the name of a file may hold any byte.
std::string oneLine(const std::filesystem::path& path);

/// From the current folder, with links followed as far as files exist.
/// @errors base::InputError that names the path where the current folder is gone or a link leads nowhere.
std::filesystem::path wholePath(const std::filesystem::path& path);

/// Equal for all names of one file, and for no two files.
struct FileIdentity {
    std::uint64_t device = 0;
    std::uint64_t number = 0; ///< on the device
};
/// With links followed; none where there is no file.
std::optional<FileIdentity> identityOf(const std::filesystem::path& path);

/// Reads a whole regular file. InputError when it is missing, not a regular file, or larger than `maxBytes`.
Bytes readFile(const std::filesystem::path& path, std::uintmax_t maxBytes);

/// A file that is being written. Bytes go to a temporary file, and commit() puts them in place whole. Without
/// commit() the temporary file is removed and `path` stays as it was.
///
/// The temporary file has a random name, and is created only if nothing of that name exists. In a program that
/// called removeUnfinishedFilesOnSignals() it goes when a signal ends the process.
/// - A regular file, or nothing, at `path`: the temporary file lies beside it and is renamed over it. The
///   mode of a file that was there is kept.
/// - A link: the same for what it points at; the link stays.
/// - A device, a FIFO or an open descriptor, such as /dev/stdout: commit() copies the bytes into it.
class PendingFile {
  public:
    /// InputError when `path` names a folder, its folder is missing or read-only, or a file there is read-only or another user's in
    /// a sticky folder. RunError when the disk is full or broken, or the process has no descriptor left.
    explicit PendingFile(std::filesystem::path path);
    ~PendingFile();
    PendingFile(const PendingFile&) = delete;
    PendingFile& operator=(const PendingFile&) = delete;

    /// Where to write: an empty file with the extension of the path.
    const std::filesystem::path& temporary() const { return m_temporary; }

    /// Puts what was written in place. RunError when that fails.
    void commit() const;

  private:
    std::filesystem::path m_path;    ///< as given, for messages
    std::filesystem::path m_target;  ///< with links followed
    bool m_isCopied = false;         ///< into the target, which is no regular file
    std::optional<int> m_descriptor; ///< that the target stands for
    std::filesystem::path m_temporary;
    std::optional<UnfinishedFile> m_unfinished; ///< the temporary file
};

/// A path in the folder for temporary files that nothing else has, for a PendingFile that is never committed.
/// std::filesystem::filesystem_error when that folder is missing.
std::filesystem::path scratchPath(const std::string& extension);

/// Lets `write` fill a PendingFile and commits it. Whatever `write` throws passes through.
void writeBesideThenRename(const std::filesystem::path& path,
                           const std::function<void(const std::filesystem::path& temporary)>& write);

/// writeBesideThenRename() of bytes in memory. RunError when they cannot all be written.
void writeFile(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);

/// writeFile() of a text.
void writeText(const std::filesystem::path& path, std::string_view text);

/// Adds a text to the end of a file that exists, in its place. RunError when it cannot all be written.
void appendText(const std::filesystem::path& path, std::string_view text);

/// Throws as PendingFile unless `path` can be written. Changes nothing; call it before long work.
void requireWritable(const std::filesystem::path& path);

/// The extension of a path with its dot, in lower case: ".png" of "A.PNG". Empty where it has none.
std::string lowerExtension(const std::filesystem::path& path);

/// Makes a folder and those above it where they are missing. InputError when that fails, RunError where the disk is full or
/// broken.
void makeFolder(const std::filesystem::path& path);

} // namespace cdr::platform
