#pragma once

#include <cstdint>
#include <optional>

namespace cdr::viewer {

/// Bytes of this process that are in memory; empty where the system does not say.
std::optional<std::uint64_t> residentBytes();

} // namespace cdr::viewer
