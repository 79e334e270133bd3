#pragma once

#include <cstdint>
#include <optional>

namespace cdr::viewer {

// The C library's allocator, for a program that measures its memory. Each does nothing where the library is not glibc.

/// Bytes that the program and its drivers have allocated, without free pieces too small to return to the system.
/// Empty where the library does not tell.
std::optional<std::uint64_t> allocatedBytes();

/// Makes the allocator return large blocks to the system when they are freed, and use one heap for all threads.
/// Otherwise it keeps more and more of them, and returnFreeMemory() cannot shrink the heaps of threads.
/// Page faults then cost about a tenth of the frame rate.
void keepFreeMemoryLow();

/// Makes the allocator write each block when it is allocated and when it is freed. Otherwise a block that its owner never
/// writes is resident only where an earlier one was written there. Then residentBytes() goes up and down by that.
void writeAllBlocks();

/// Returns to the system what the allocator keeps for later, so that residentBytes() is what the program uses.
void returnFreeMemory();

} // namespace cdr::viewer
