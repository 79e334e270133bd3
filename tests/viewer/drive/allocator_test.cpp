#include <gtest/gtest.h>
#include <program/allocator.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace cdr::viewer_test {

namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kHasOtherAllocator = true;
#else
constexpr bool kHasOtherAllocator = false;
#endif

TEST(Allocator, MakesABlockResidentThatNobodyWrites) {
    if (kHasOtherAllocator) {
        GTEST_SKIP() << "a sanitizer stands where the C library's allocator would";
    }
    constexpr std::size_t kBytes = std::size_t{16} << 20;
    program::writeAllBlocks();
    const std::uint64_t before = program::residentBytes().value_or(0);
    void* volatile block = std::malloc(kBytes); // volatile, or a compiler may leave both calls out
    const std::uint64_t after = program::residentBytes().value_or(0);
    std::free(block);
    EXPECT_GT(after, before + kBytes / 2); // the system counts each thread's pages with a delay
}

} // namespace

} // namespace cdr::viewer_test
