#pragma once

#include <filesystem>
#include <optional>

namespace cdr::platform {

/// A number that no other process of this machine has now.
long processId();

/// The file that this program was started from, with links followed. None where the system does not tell.
std::optional<std::filesystem::path> ownProgram();

} // namespace cdr::platform
