#pragma once

#include <cstddef>
#include <filesystem>

namespace cdr::platform {

/// The name of a file that must not outlive the process unless it is finished. While the object lives, a signal that
/// ends the process removes the file first; see removeUnfinishedFilesOnSignals().
class UnfinishedFile {
  public:
    /// Call it before the file is created. A path that is too long, or beside too many others, is not remembered.
    explicit UnfinishedFile(const std::filesystem::path& path);
    ~UnfinishedFile();
    UnfinishedFile(const UnfinishedFile&) = delete;
    UnfinishedFile& operator=(const UnfinishedFile&) = delete;

  private:
    std::size_t m_slot;
};

/// From now on a signal that asks the process to end first removes the unfinished files. Then it ends the process as before.
/// These signals are SIGHUP, SIGINT, SIGQUIT, SIGPIPE, SIGTERM and SIGXCPU. A signal that is ignored stays ignored. A file
/// beyond the limit of file sizes (SIGXFSZ) becomes an error of the write instead.
///
/// For main() of a program: a library leaves signals alone.
void removeUnfinishedFilesOnSignals();

} // namespace cdr::platform
