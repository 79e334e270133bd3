#include "allocator.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace cdr::viewer {

std::optional<std::uint64_t> allocatedBytes() {
#if defined(__GLIBC__) && __GLIBC_PREREQ(2, 33)
    const struct mallinfo2 info = ::mallinfo2();
    return std::uint64_t{info.uordblks} + std::uint64_t{info.hblkhd};
#else
    return std::nullopt;
#endif
}

void keepFreeMemoryLow() {
#ifdef __GLIBC__
    constexpr int kLargeBytes = 256 << 10;
    ::mallopt(M_MMAP_THRESHOLD, kLargeBytes);
    ::mallopt(M_ARENA_MAX, 1);
#endif
}

void writeAllBlocks() {
#ifdef __GLIBC__
    constexpr int kByte = 0xa5;
    ::mallopt(M_PERTURB, kByte);
#endif
}

void returnFreeMemory() {
#ifdef __GLIBC__
    ::malloc_trim(0);
#endif
}

} // namespace cdr::viewer
