#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace cdr::report {

/// The file in a report's folder that says it is one, and lists the files that belong to it.
inline constexpr const char* kManifest = "report.json";

/// base::InputError unless a report may stand at `path`: where nothing is, an empty folder, or a report that
/// holds nothing but its own files. Call before long work.
void requireReplaceable(const std::filesystem::path& path);

/// Every file under a folder, relative to it, in order.
std::vector<std::filesystem::path> filesUnder(const std::filesystem::path& folder);

/// A report in the making, in a folder beside `path`. It goes with the object unless it was put in place.
class PendingFolder {
  public:
    /// base::InputError as requireReplaceable(), and where no folder can be made beside `path`.
    explicit PendingFolder(const std::filesystem::path& path);
    ~PendingFolder();
    PendingFolder(const PendingFolder&) = delete;
    PendingFolder& operator=(const PendingFolder&) = delete;

    /// Where to write.
    const std::filesystem::path& temporary() const { return m_temporary; }

    /// Renames it to the path, and an old report there away. base::InputError, and all as before, when that
    /// fails.
    void commit() const;

  private:
    std::filesystem::path m_path;
    std::filesystem::path m_temporary;
};

} // namespace cdr::report
