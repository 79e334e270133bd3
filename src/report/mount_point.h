#pragma once

#include <filesystem>

namespace cdr::report {

/// Whether another file system, or another folder, is mounted on this one, so that it cannot be renamed.
/// @param path absolute, without links.
bool isMountPoint(const std::filesystem::path& path);

} // namespace cdr::report
