#pragma once

#include <cstddef>
#include <filesystem>

namespace cdr::host {

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

/// From now on the signals that ask a process to end (SIGHUP, SIGINT, SIGQUIT, SIGPIPE, SIGTERM, SIGXCPU) remove what is
/// unfinished, and then end it as before. One that is ignored stays ignored. A file beyond the limit of file sizes
/// (SIGXFSZ) becomes an error of the write instead.
///
/// For main() of a program: a library leaves signals alone.
void removeUnfinishedFilesOnSignals();

} // namespace cdr::host
