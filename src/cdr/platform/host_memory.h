#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace cdr::platform {

/// Bytes that this process can still take. It is the smaller of the memory and swap that the system calls available, and what
/// the process' own limit (`ulimit -v`) leaves. Limits of a container do not count. Empty where the system does not tell.
std::optional<std::uint64_t> freeHostBytes();

/// base::RunError with both figures when `bytes` for `what` exceed what is free. Call before allocating.
void requireHostBytes(std::uint64_t bytes, const std::string& what);

} // namespace cdr::platform
