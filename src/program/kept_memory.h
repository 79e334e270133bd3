#pragma once

namespace cdr::program {

/// Has the process keep freed memory for its next allocation, up to 256 MiB, instead of returning it to the system. A
/// software driver allocates and frees several MiB in each frame, and memory that was returned costs a page fault per 4 KiB.
/// For programs, not for libraries: it changes the allocator of the whole process. Call it before threads start.
/// @return whether the C library has such a setting; else nothing changes.
bool keepFreedMemory();

} // namespace cdr::program
