#include <program/allocator.h>
#include <unistd.h>

#include <cstdlib> // defines __GLIBC__, where that is the C library
#include <fstream>

#if defined(__GLIBC__)
#include <malloc.h>
#define CDR_HAS_MALLINFO2 __GLIBC_PREREQ(2, 33)
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

std::optional<std::uint64_t> allocatedBytes() {
#if CDR_HAS_MALLINFO2
    const struct mallinfo2 info = ::mallinfo2();
    return std::uint64_t{info.uordblks} + std::uint64_t{info.hblkhd};
#else
    return std::nullopt;
#endif
}

std::optional<std::uint64_t> residentBytes() {
    std::ifstream file("/proc/self/statm");
    std::uint64_t size = 0;
    std::uint64_t resident = 0;
    const long page = ::sysconf(_SC_PAGESIZE);
    if (!(file >> size >> resident) || page <= 0) {
        return std::nullopt;
    }
    return resident * static_cast<std::uint64_t>(page);
}

void keepFreeMemoryLow() {
#if defined(__GLIBC__)
    constexpr int kLargeBytes = 256 << 10;
    ::mallopt(M_MMAP_THRESHOLD, kLargeBytes);
    ::mallopt(M_ARENA_MAX, 1);
#endif
}

void writeAllBlocks() {
#if defined(__GLIBC__)
    constexpr int kByte = 0xa5;
    ::mallopt(M_PERTURB, kByte);
#endif
}

void returnFreeMemory() {
#if defined(__GLIBC__)
    ::malloc_trim(0);
#endif
}

} // namespace cdr::program
