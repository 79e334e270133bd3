#include "../support/shared_device.h"

#include <cdr/gpu/commands.h>
#include <cdr/gpu/device_clock.h>
#include <cdr/gpu/memory.h>

#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>
#include <limits>

namespace cdr::gpu {
namespace {

constexpr std::uint64_t kMax = std::numeric_limits<std::uint64_t>::max();

TEST(TimestampSteps, CountAClockThatBeginsAnew) {
    EXPECT_EQ(timestampSteps(3, 10, 64), 7u);
    EXPECT_EQ(timestampSteps(kMax, 1, 64), 2u);
    const std::uint64_t last36 = (std::uint64_t{1} << 36u) - 1;
    EXPECT_EQ(timestampSteps(last36 - 1, 4, 36), 6u);
    EXPECT_EQ(timestampSteps(0, 1, 1), 1u);
}

class DeviceClockTest : public test::DeviceTest {};

/// Filling so much memory takes some time, and not more than passed on the CPU.
TEST_F(DeviceClockTest, TimesWhatIsSubmitted) {
    if (!DeviceClock::isThere(device())) {
        GTEST_SKIP() << device().info().name << " has no timestamps";
    }
    const DeviceClock clock(device(), "clock test");
    constexpr vk::DeviceSize kBytes = vk::DeviceSize{64} << 20u;
    const vk::Device handle(device().handle());
    const Buffer filled(device(), kBytes, vk::BufferUsageFlagBits::eTransferDst, MemoryUse::deviceOnly,
                        "filled");
    CommandPool pool(device(), vk::CommandBufferLevel::ePrimary, "clock test pool");
    const vk::UniqueFence done = handle.createFenceUnique({});
    for (int round = 0; round < 2; ++round) { // the queries are used again
        pool.reset();
        const vk::CommandBuffer commands = pool.next();
        commands.begin({.flags = vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
        commands.fillBuffer(filled.handle(), 0, kBytes, 7);
        commands.end();
        const auto begin = std::chrono::steady_clock::now();
        submit(device(), clock.around({&commands, 1}), *done);
        waitAndReset(device(), *done);
        const std::chrono::duration<double, std::milli> passed = std::chrono::steady_clock::now() - begin;
        EXPECT_GT(clock.lastMs(), 0.0);
        EXPECT_LE(clock.lastMs(), passed.count());
    }
}

} // namespace
} // namespace cdr::gpu
