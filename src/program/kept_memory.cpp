#include <program/kept_memory.h>

#include <cstdlib> // defines __GLIBC__, where that is the C library

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace cdr::program {

bool keepFreedMemory() {
#if defined(__GLIBC__)
    constexpr int kKeptBytes = 256 << 20;
    // The largest that glibc takes. One setting alone would stop glibc from raising the other.
    constexpr int kLargestFromHeap = 32 << 20;
    return ::mallopt(M_TRIM_THRESHOLD, kKeptBytes) != 0 && ::mallopt(M_MMAP_THRESHOLD, kLargestFromHeap) != 0;
#else
    return false;
#endif
}

} // namespace cdr::program
