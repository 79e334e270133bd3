#include <gtest/gtest.h>
#include <program/allocator.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace cdr::program {
namespace {

long pageFaults() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return usage.ru_minflt;
}

/// As a software driver does in each frame: 32 MiB in blocks of 64 KiB, all of them written, then freed.
void useMemory() {
    constexpr std::size_t kBlockBytes = 64 << 10;
    constexpr std::size_t kBlocks = 512;
    std::vector<std::unique_ptr<std::byte[]>> blocks;
    for (std::size_t i = 0; i < kBlocks; ++i) {
        blocks.push_back(std::make_unique_for_overwrite<std::byte[]>(kBlockBytes));
        std::fill_n(blocks.back().get(), kBlockBytes, std::byte{1});
    }
}

TEST(KeptMemory, IsUsedAgainWithoutPageFaults) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "a sanitizer has an allocator of its own";
#endif
    if (!keepFreedMemory()) {
        GTEST_SKIP() << "this C library has no such setting";
    }
    useMemory();
    const long before = pageFaults();
    useMemory();
    // The memory has 8192 pages of 4 KiB.
    EXPECT_LT(pageFaults() - before, 800);
}

} // namespace
} // namespace cdr::program
