#pragma once

#include <cstdint>
#include <optional>

namespace cdr::viewer {

/// Bytes of this process that are in physical memory. Empty where the system does not tell.
std::optional<std::uint64_t> residentBytes();

} // namespace cdr::viewer
