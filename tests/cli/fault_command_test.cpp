#include "../support/fault.h"
#include "program.h"

#include <gtest/gtest.h>

#include <ostream>

namespace cdr::cli_test {

namespace {

using test::Fault;

struct Fatal {
    const char* arguments;
    Fault fault;
    const char* says;

    friend std::ostream& operator<<(std::ostream& out, const Fatal& fatal) {
        return out << fatal.arguments << ", " << fatal.fault.environment();
    }
};

class FaultTest : public FolderTest, public testing::WithParamInterface<Fatal> {};

/// One line, exit status 1, nothing half written, no hang and no crash.
TEST_P(FaultTest, EndsInOneLine) {
    if (std::string(GetParam().arguments).find("gpu-driven") != std::string::npos && !canDrawGpuDriven()) {
        GTEST_SKIP() << "the device cannot draw gpu-driven";
    }
    const ProgramResult result =
        run(std::string(GetParam().arguments) + " --validate --size 320x180 -o a.png --json a.json",
            GetParam().fault.environment() + " timeout 1000");
    expectOneLine(result, 1, GetParam().says);
    EXPECT_TRUE(folderIsEmpty());
}

TEST(Fault, ThatNeverComesChangesNothing) {
    const TemporaryFolder folder;
    const Fault never{.call = "vkQueueSubmit2", .after = test::kForever};
    const ProgramResult result =
        succeed("render cubes --size 320x180 -o a.png", folder.path(), never.environment());
    EXPECT_EQ(result.err, "");
    EXPECT_FALSE(folder.isEmpty());
}

/// There no draw fills the G-buffer.
TEST(Fault, ADeviceThatSaysItIsACardDrawsTheSame) {
    const TemporaryFolder folder;
    const std::string card = Fault{.call = "vkGetPhysicalDeviceProperties2",
                                   .times = test::kForever,
                                   .result = VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU}
                                 .environment();
    EXPECT_NE(succeed("devices", folder.path(), card).out.find("discrete"), std::string::npos);
    for (const char* options : {"", " --submission primaries", " --surface visibility", " --threads 3"}) {
        const std::string command =
            fmt::format("render afc --technique cdr --size 96x64 --validate{} -o ", options);
        succeed(command + "here.png", folder.path());
        succeed(command + "card.png", folder.path(), card);
        EXPECT_EQ(readText(folder.path() / "card.png"), readText(folder.path() / "here.png")) << options;
    }
}

constexpr const char* kLost = "the Vulkan device was lost";

/// A call of every path and of what has passes of its own.
INSTANTIATE_TEST_SUITE_P(
    DeviceLost, FaultTest,
    testing::Values(
        Fatal{"render cubes", {.call = "vkQueueSubmit2"}, kLost},
        Fatal{"render cubes", {.call = "vkWaitForFences"}, kLost},
        Fatal{"render cubes --threads 3", {.call = "vkQueueSubmit2", .after = 3}, kLost},
        Fatal{"render cubes --threads 3", {.call = "vkWaitForFences", .after = 3}, kLost},
        Fatal{"render cubes --submission primaries", {.call = "vkWaitForFences", .after = 3}, kLost},
        Fatal{"render cubes --submission gpu-driven", {.call = "vkWaitForFences", .after = 3}, kLost},
        Fatal{"render cubes --targets pool --threads 2", {.call = "vkWaitForFences", .after = 3}, kLost},
        Fatal{"render sheets --translucency sorted", {.call = "vkWaitForFences", .after = 3}, kLost},
        Fatal{"render cubes --targets layers --focus 12000:1",
              {.call = "vkWaitForFences", .after = 3},
              kLost}));

constexpr Fault memoryAfter(long calls) {
    return {.call = "vkAllocateMemory",
            .after = calls,
            .times = test::kForever,
            .result = VK_ERROR_OUT_OF_DEVICE_MEMORY};
}

constexpr const char* kForWhat = "out of memory for "; // what, and how many bytes

INSTANTIATE_TEST_SUITE_P(OutOfMemory, FaultTest,
                         testing::Values(Fatal{"render cubes", memoryAfter(0), kForWhat},
                                         Fatal{"render cubes", memoryAfter(1), kForWhat}));

} // namespace

} // namespace cdr::cli_test
