#pragma once

#include <cstdint>
#include <optional>

namespace cdr::program {

// The memory of the process, and the C library's allocator: for programs and not for libraries, since both are the whole
// process's. Where the library is not glibc, what is about the allocator does nothing.

/// Has the process keep freed memory for its next allocation, up to 256 MiB, instead of returning it to the system. A
/// software driver allocates and frees several MiB in each frame, and memory that was returned costs a page fault per 4 KiB.
/// Call it before threads start.
/// @return whether the C library has such a setting; else nothing changes.
bool keepFreedMemory();

/// Asks the system for pages of 2 MiB in the next 192 MiB of the heap. A program that draws one picture otherwise spends much of
/// its time in page faults, one per 4 KiB. This reserves addresses; memory is taken when it is used. Call it first of all, right
/// after keepFreedMemory(), without which large blocks are not in the heap.
/// @return whether the system takes such requests and the heap could grow.
bool useLargePages();

/// Bytes that the program and its drivers have allocated, without free pieces too small to return to the system.
/// Empty where the library does not tell.
std::optional<std::uint64_t> allocatedBytes();
/// Bytes of this process that are in physical memory. Empty where the system does not tell.
std::optional<std::uint64_t> residentBytes();

/// Makes the allocator return large blocks to the system when they are freed, and use one heap for all threads.
/// Otherwise it keeps more and more of them, and returnFreeMemory() cannot shrink the heaps of threads.
/// Page faults then cost about a tenth of the frame rate.
void keepFreeMemoryLow();

/// Makes the allocator write each block when it is allocated and when it is freed. Otherwise a block that its owner never
/// writes is resident only where an earlier one was written there. Then the resident bytes go up and down by that.
void writeAllBlocks();

/// Returns to the system what the allocator keeps for later, so that the resident bytes are what the program uses.
void returnFreeMemory();

} // namespace cdr::program
