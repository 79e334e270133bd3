#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>

namespace cdr::platform {

/// Bytes that this process can still take. It is the smaller of the memory and swap that the system calls available, and what
/// the process' own limit (`ulimit -v`) leaves. Limits of a container do not count. Empty where the system does not tell.
std::optional<std::uint64_t> freeHostBytes();

/// The product, or the largest number where the product is larger. So a size that is far too large does not look like none.
std::uint64_t saturatingProduct(std::initializer_list<std::uint64_t> factors);

/// base::RunError with both figures when `bytes` for `what` exceed what is free. Call before allocating.
void requireHostBytes(std::uint64_t bytes, const std::string& what);

} // namespace cdr::platform
