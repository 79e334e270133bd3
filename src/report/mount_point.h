#pragma once

#include <filesystem>

namespace cdr::report {

/// Whether another file system, or another folder, is mounted on this one, so that it cannot be renamed.
/// Linux before 5.8 does not tell. There it is whether the folder is on another file system than the one that it is in.
bool isMountPoint(const std::filesystem::path& path);

} // namespace cdr::report
