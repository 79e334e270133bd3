#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cdr::report {

/// Every file under a folder, relative to it, in order.
std::vector<std::filesystem::path> filesUnder(const std::filesystem::path& folder);

/// A report in the making, in a temporary folder. That folder goes with the object unless it was put in place or
/// is to be kept.
///
/// It lies beside `path` and is renamed to it. A folder that cannot be renamed, a mount point or the current
/// folder, is filled instead: the temporary folder lies in it.
class PendingFolder {
  public:
    /// base::InputError if no report may be written to `path`. It is a file, a folder in which the current folder lies, or
    /// where no folder can be made. Or it is a folder that is not empty and holds more than a report's own files.
    /// @param state if not empty, the report goes on with what an earlier report of this state left. That is its temporary
    /// folder, else the report's own files, of which the caller has to remove those that it does not want.
    explicit PendingFolder(const std::filesystem::path& path, const std::string& state = "");
    ~PendingFolder();
    PendingFolder(const PendingFolder&) = delete;
    PendingFolder& operator=(const PendingFolder&) = delete;

    /// Where to write.
    const std::filesystem::path& temporary() const { return m_temporary; }

    /// From now on what was written stays, in the temporary folder if it cannot be put in place. Call it when
    /// there is something worth keeping.
    void keep() { m_isKept = true; }
    bool isKept() const { return m_isKept; }

    /// Puts the report in place of an old one. base::RunError or base::InputError, and all as before, when that
    /// fails.
    void commit();

  private:
    void makeTemporary(const std::filesystem::path& folder) const;
    void continueEarlier(const std::filesystem::path& folder);
    void renameIntoPlace() const;
    void moveIntoPlace() const;

    std::filesystem::path m_path;
    std::filesystem::path m_temporary;
    bool m_isInside = false; ///< the temporary folder lies in the path
    bool m_isKept = false;
};

} // namespace cdr::report
