#include <gtest/gtest.h>
#include <program/allocator.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
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

/// The flags that the system keeps for the memory at an address, such as "rd wr mr mw me ac sd hg".
std::string flagsOf(const void* address) {
    const auto wanted = reinterpret_cast<std::uintptr_t>(address);
    std::ifstream file("/proc/self/smaps");
    bool isThere = false;
    for (std::string line; std::getline(file, line);) {
        std::uintptr_t begin = 0;
        std::uintptr_t end = 0;
        char dash = 0;
        if (std::istringstream text(line); text >> std::hex >> begin >> dash >> end && dash == '-') {
            isThere = begin <= wanted && wanted < end;
        } else if (isThere && line.starts_with("VmFlags:")) {
            return line.substr(line.find(' ')) + " ";
        }
    }
    return {};
}

TEST(LargePages, AreAskedForWhereTheNextBlockLies) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "a sanitizer has an allocator of its own";
#endif
    if (!keepFreedMemory() || !std::ifstream("/sys/kernel/mm/transparent_hugepage/enabled")) {
        GTEST_SKIP() << "this C library or this system has no such setting";
    }
    ASSERT_TRUE(useLargePages());
    constexpr std::size_t kBytes = 1 << 20; // too large for what earlier tests freed in between
    const auto block = std::make_unique_for_overwrite<std::byte[]>(kBytes);
    const std::string flags = flagsOf(block.get() + kBytes - 1);
    EXPECT_NE(flags.find(" hg "), std::string::npos) << flags;
}

} // namespace
} // namespace cdr::program
