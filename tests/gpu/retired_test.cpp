#include "../support/shared_device.h"
#include "../support/timeline.h"
#include "host_loader.h"

#include <cdr/gpu/commands.h>
#include <cdr/gpu/retired.h>

#include <memory>

namespace cdr::gpu_test {

namespace {

using RetiredObjects = test::DeviceTest;

TEST_F(RetiredObjects, StayUntilWhatWasSubmittedBeforeIsDone) {
    gpu::Retired retired(device());
    const test::Timeline ready(device());
    const VkSemaphoreSubmitInfo wait = ready.info();
    gpu::submit(device(), {}, {}, {&wait, 1});
    auto object = std::make_shared<int>(1);
    const std::weak_ptr<int> watched = object;
    retired.add(std::move(object));
    retired.free();
    EXPECT_FALSE(watched.expired()) << "not closed";
    retired.close();
    retired.free();
    EXPECT_FALSE(watched.expired()) << "not done";
    ready.signal();
    gpu::waitForQueue(device());
    retired.free();
    EXPECT_TRUE(watched.expired());
}

TEST_F(RetiredObjects, GoWithTheirKeeperOnceItHasWaited) {
    std::weak_ptr<int> watched;
    {
        gpu::Retired retired(device());
        auto object = std::make_shared<int>(1);
        watched = object;
        retired.add(std::move(object));
        retired.close();
    }
    EXPECT_TRUE(watched.expired());
}

/// An update that found no memory leaves them open, and then there may be none to wait with.
TEST_F(RetiredObjects, AreWaitedForWithoutMemoryWhereNothingClosedThem) {
    test::waits() = {};
    {
        gpu::Retired retired(device());
        retired.add(1);
    }
    EXPECT_EQ(test::waits().idle, 1) << "a fence takes memory";
}

} // namespace

} // namespace cdr::gpu_test
