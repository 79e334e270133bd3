#include "../support/address_limit.h"
#include "../support/refusal.h"

#include <cdr/base/error.h>
#include <cdr/platform/host_memory.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <string>

namespace {

using namespace cdr;
using test::AddressLimit;

constexpr std::uint64_t kMebibyte = 1 << 20;

TEST(HostMemory, MoreThanTheSystemHasIsRefused) {
    ASSERT_TRUE(platform::freeHostBytes().has_value());
    EXPECT_THROW(platform::requireHostBytes(std::uint64_t{1} << 60, "a picture"), base::RunError);
    EXPECT_NO_THROW(platform::requireHostBytes(1, "a pixel"));
}

TEST(HostMemory, AProductIsNeverLessThanItIs) {
    constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();
    constexpr std::uint64_t kSide = std::uint64_t{1} << 31;
    EXPECT_EQ(platform::saturatingProduct({3, 5, 7}), 105u);
    EXPECT_EQ(platform::saturatingProduct({kSide, kSide, 4}), kMost);
    EXPECT_EQ(platform::saturatingProduct({kSide, kSide, 3}), 3 * kSide * kSide);
    EXPECT_EQ(platform::saturatingProduct({kSide, kSide, 32, 5}), kMost);
    EXPECT_EQ(platform::saturatingProduct({kSide, kSide, 32, 0}), 0u);
}

TEST(HostMemory, TheLimitOfTheProcessCounts) {
    const AddressLimit limit(256 * kMebibyte);
    EXPECT_LE(platform::freeHostBytes().value_or(0), 257 * kMebibyte); // pages are returned meanwhile
    const std::string line =
        cdr::test::runErrorOf([&] { platform::requireHostBytes(512 * kMebibyte, "a picture"); });
    EXPECT_NE(line.find("a picture needs 512.0 MiB of memory, "), std::string::npos) << line;
    EXPECT_NE(line.find(" MiB are free"), std::string::npos) << line;
}

} // namespace
