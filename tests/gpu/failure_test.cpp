#include <cdr/base/error.h>
#include <cdr/gpu/device.h>
#include <cdr/gpu/failure.h>
#include <cdr/gpu/vulkan_hpp.h>

#include <gtest/gtest.h>

#include <new>
#include <stdexcept>
#include <system_error>

namespace cdr::gpu_test {

namespace {

gpu::Failure failureFrom(const auto& error) {
    return gpu::failureOf(std::make_exception_ptr(error));
}

TEST(FailureOf, IsBadInputOrAFailureAndOneLine) {
    EXPECT_EQ(failureFrom(base::InputError("no\nsuch\nscene")).status, 2);
    EXPECT_EQ(failureFrom(base::InputError("no\nsuch\nscene")).line, "no such scene");
    EXPECT_EQ(failureFrom(base::InputError("\x1b[31mred\x7f\u009b")).line, " [31mred   ");
    EXPECT_EQ(failureFrom(base::RunError("disk full")).status, 1);
    EXPECT_EQ(failureFrom(base::RunError("disk full")).line, "disk full");
}

TEST(FailureOf, NamesWhatVulkanAndTheSystemRanOutOf) {
    const auto has = [](const gpu::Failure& failure, const char* text) {
        return failure.status == 1 && failure.line.find(text) != std::string::npos;
    };
    EXPECT_TRUE(has(failureFrom(vk::DeviceLostError("vkQueueSubmit2")), "device was lost"));
    EXPECT_TRUE(has(failureFrom(vk::OutOfDeviceMemoryError("vkAllocateMemory")),
                    "device is out of memory (vkAllocateMemory"));
    EXPECT_TRUE(has(failureFrom(vk::InitializationFailedError("vkCreateDevice")), "Vulkan: vkCreateDevice"));
    EXPECT_TRUE(has(failureFrom(std::bad_alloc()), "out of memory"));
    EXPECT_TRUE(has(failureFrom(std::logic_error("never")), "never"));
}

TEST(FailureOf, ALostDeviceIsToldFromOtherErrors) {
    EXPECT_TRUE(gpu::isDeviceLost(vk::DeviceLostError("vkQueueSubmit2")));
    EXPECT_FALSE(gpu::isDeviceLost(vk::OutOfDeviceMemoryError("vkQueueSubmit2")));
    EXPECT_FALSE(gpu::isDeviceLost(
        std::system_error(static_cast<int>(vk::Result::eErrorDeviceLost), std::generic_category())));
    EXPECT_FALSE(gpu::isDeviceLost(base::RunError("the device was lost")));
    // A host's own vulkan.hpp beside a shared library.
    struct HostsCategory : std::error_category {
        const char* name() const noexcept override { return "vk::Result"; }
        std::string message(int) const override { return {}; }
    };
    const HostsCategory category;
    EXPECT_TRUE(gpu::isDeviceLost(std::system_error(VK_ERROR_DEVICE_LOST, category)));
    EXPECT_FALSE(gpu::isDeviceLost(std::system_error(VK_ERROR_OUT_OF_DEVICE_MEMORY, category)));
}

} // namespace

} // namespace cdr::gpu_test
