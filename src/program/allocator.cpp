#include <program/allocator.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib> // defines __GLIBC__, where that is the C library
#include <fstream>

#if defined(__GLIBC__)
#include <malloc.h>
#include <sys/mman.h>
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

bool useLargePages() {
#if defined(__GLIBC__) && defined(MADV_HUGEPAGE)
    // Less than keepFreedMemory() keeps, or a heap that is all free would be returned to the system.
    constexpr int kReservedBytes = 192 << 20;
    constexpr std::size_t kMoreThanIsFree = 1 << 20;
    constexpr int kDefaultPad = 128 << 10;
    // One block that the heap has no room for makes it grow by all of the pad.
    ::mallopt(M_TOP_PAD, kReservedBytes);
    void* const block = ::malloc(kMoreThanIsFree);
    ::mallopt(M_TOP_PAD, kDefaultPad);
    const auto page = static_cast<std::uintptr_t>(::sysconf(_SC_PAGESIZE));
    const auto begin = reinterpret_cast<std::uintptr_t>(block);
    const std::uintptr_t toPage = (page - begin % page) % page;
    const auto end = reinterpret_cast<std::uintptr_t>(::sbrk(0));
    // Where the heap could not grow, the block is null or lies elsewhere: above its end, or far below.
    const bool isInHeap =
        block != nullptr && begin + toPage < end && end - begin <= 2 * std::uintptr_t{kReservedBytes};
    const bool isAsked = isInHeap && ::madvise(static_cast<char*>(block) + toPage,
                                               (end - begin - toPage) / page * page, MADV_HUGEPAGE) == 0;
    ::free(block);
    return isAsked;
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
