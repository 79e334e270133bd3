#pragma once

#include <cstdint>
#include <optional>

namespace cdr::viewer {

/// Bytes of this process that are in memory; empty where the system does not say.
std::optional<std::uint64_t> residentBytes();

/// Bytes that the program and its drivers hold of the allocator, without what that keeps in pieces too small
/// to give back; empty where it does not say.
std::optional<std::uint64_t> allocatedBytes();

/// Has the allocator give pictures and the like back to the system when they are freed, and keep one heap for
/// all threads, where it can be told to, for who measures memory: left alone it keeps ever more of them, and
/// returnFreeMemory() cannot shrink the heaps of threads. Costs a tenth of the frame rate in page faults.
void keepFreeMemoryLow();

/// Gives back to the system what the allocator keeps for later, where it can be told to, so that
/// residentBytes() is what the program uses.
void returnFreeMemory();

} // namespace cdr::viewer
