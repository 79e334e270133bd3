#include "../support/fault.h"
#include "viewer_run.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <ostream>

namespace cdr::viewer_test {

namespace {

namespace fs = std::filesystem;
using test::Fault;

/// Shows, changes technique and size, and keeps pictures of both.
constexpr const char* kScript = "wait-frame\nwait-ui 5\nwindow before.png\nkey 6\nwait-frame\nwait-ui 5\n"
                                "resize 200 150\nwait-state size=200x150\nwait-frame\nwait-ui 3\nstate\n"
                                "window after.png\nquit\n";

/// Ends what hangs, with a status that no test expects.
constexpr const char* kViewer = "timeout 1200 '" CDR_VIEWER_DRIVE
                                "' --validate --script script --size 240x180 --technique standard cubes";

class ViewerFault : public ViewerTest {
  protected:
    RunResult suffer(const Fault& fault, const std::string& script = kScript) {
        std::ofstream(folder() / "script") << script;
        return runShell(kViewer, folder(), environment() + " CDR_FAULT_LOG=fault.log " + fault.environment());
    }
    /// The first call that failed in the last viewer; "none" where none did.
    std::string failedCall() const {
        std::string calls;
        std::string failed;
        std::ifstream(folder() / "fault.log") >> calls >> failed;
        return failed;
    }
    /// The files in the folder, without those of the test itself. An unfinished file would be one of them.
    std::vector<std::string> files() const {
        std::vector<std::string> names;
        for (const auto& entry : fs::directory_iterator(folder())) {
            const std::string name = entry.path().filename().string();
            if (name != "script" && name != "fault.log" && name != "run.out" && name != "run.err") {
                names.push_back(name);
            }
        }
        return names;
    }
};

struct Fatal {
    Fault fault;
    const char* says;

    friend std::ostream& operator<<(std::ostream& out, const Fatal& fatal) { return out << fatal.fault; }
};

class ViewerFatal : public ViewerFault, public testing::WithParamInterface<Fatal> {};

TEST_P(ViewerFatal, EndsInOneLine) {
    const RunResult run = suffer(GetParam().fault);
    expectOneLine(run, 1, GetParam().says);
    for (const std::string& name : files()) {
        EXPECT_EQ(name, "before.png");
        EXPECT_EQ(picture(name).width, 240u) << "half written";
    }
}

constexpr const char* kLost = "the Vulkan device was lost";
constexpr const char* kMemory = "out of memory";

INSTANTIATE_TEST_SUITE_P(
    DeviceLost, ViewerFatal,
    testing::Values(Fatal{{.call = "vkQueueSubmit2", .device = "render"}, kLost}, // while a scene is uploaded
                    Fatal{{.call = "vkQueueSubmit2", .device = "render", .after = 5}, kLost},
                    Fatal{{.call = "vkWaitForFences", .device = "render", .after = 5}, kLost},
                    Fatal{{.call = "vkQueueSubmit2", .device = "window"}, kLost}, // while glyphs are uploaded
                    Fatal{{.call = "vkQueueSubmit2", .device = "window", .after = 5}, kLost},
                    Fatal{{.call = "vkWaitForFences", .device = "window", .after = 5}, kLost},
                    Fatal{{.call = "vkDeviceWaitIdle", .device = "window", .after = 1}, kLost},
                    Fatal{{.call = "vkAcquireNextImageKHR", .after = 3}, kLost},
                    Fatal{{.call = "vkQueuePresentKHR", .after = 3}, kLost}));

constexpr Fatal lacksMemory(std::string_view call) {
    return {.fault = {.call = call, .result = VK_ERROR_OUT_OF_DEVICE_MEMORY}, .says = kMemory};
}

INSTANTIATE_TEST_SUITE_P(
    OutOfMemory, ViewerFatal,
    testing::Values(
        Fatal{{.call = "vkAllocateMemory",
               .device = "render",
               .times = test::kForever,
               .result = VK_ERROR_OUT_OF_DEVICE_MEMORY},
              kMemory},
        Fatal{{.call = "vkAllocateMemory",
               .device = "window",
               .times = test::kForever,
               .result = VK_ERROR_OUT_OF_DEVICE_MEMORY},
              kMemory},
        Fatal{{.call = "vkAllocateMemory",
               .device = "window",
               .after = 2,
               .times = test::kForever,
               .result = VK_ERROR_OUT_OF_DEVICE_MEMORY},
              kMemory},
        Fatal{{.call = "vkCreateSwapchainKHR", .after = 1, .result = VK_ERROR_OUT_OF_DEVICE_MEMORY}, kMemory},
        lacksMemory("vkCreateInstance"), lacksMemory("vkEnumeratePhysicalDevices"),
        lacksMemory("vkCreateXcbSurfaceKHR"), lacksMemory("vkGetPhysicalDeviceSurfaceSupportKHR"),
        lacksMemory("vkGetPhysicalDeviceSurfaceFormatsKHR"),
        lacksMemory("vkGetPhysicalDeviceSurfacePresentModesKHR"), lacksMemory("vkGetSwapchainImagesKHR"),
        lacksMemory("vkCreateRenderPass"), lacksMemory("vkCreateFramebuffer"),
        Fatal{{.call = "vkAcquireNextImageKHR",
               .after = 2,
               .times = test::kForever,
               .result = VK_ERROR_SURFACE_LOST_KHR},
              "surface was lost"}));

/// A surface that is lost, out of date or without pixels for once.
class ViewerMended : public ViewerFault, public testing::WithParamInterface<Fault> {};

TEST_P(ViewerMended, GoesOn) {
    const RunResult run = suffer(GetParam());
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.err, "");
    EXPECT_EQ(failedCall(), GetParam().call);
    const auto states = run.states(1);
    EXPECT_EQ(valueOf(states[0], "technique"), "anchored,");
    const image::ImageRgba8 after = picture("after.png");
    EXPECT_EQ(after.width, 200u);
    EXPECT_EQ(after.height, 150u);
    EXPECT_GT(brightness(after), 15.0);
}

std::vector<Fault> passing() {
    std::vector<Fault> faults;
    for (const long result : {VK_ERROR_OUT_OF_DATE_KHR, VK_ERROR_SURFACE_LOST_KHR}) {
        for (const char* call : {"vkAcquireNextImageKHR", "vkQueuePresentKHR", "vkCreateSwapchainKHR"}) {
            faults.push_back({.call = call, .after = 0, .times = 1, .result = result});
            faults.push_back({.call = call, .after = 1, .times = 1, .result = result});
        }
    }
    for (const char* call : {"vkAcquireNextImageKHR", "vkQueuePresentKHR"}) {
        faults.push_back({.call = call, .times = test::kForever, .result = VK_SUBOPTIMAL_KHR});
    }
    constexpr const char* kCapabilities = "vkGetPhysicalDeviceSurfaceCapabilitiesKHR";
    faults.push_back({.call = kCapabilities, .times = 1, .result = 0});
    faults.push_back({.call = kCapabilities, .after = 1, .times = 2, .result = 0});
    faults.push_back({.call = kCapabilities, .times = test::kForever, .result = -1});
    return faults;
}

INSTANTIATE_TEST_SUITE_P(Surface, ViewerMended, testing::ValuesIn(passing()));

/// A frame that is to be kept and cannot be presented: its pixels are still being copied when that is known.
TEST_F(ViewerFault, LosesAFrameThatIsNotPresented) {
    constexpr int kKept = 24;
    std::string script = "wait-frame\n";
    for (int i = 0; i < kKept; ++i) {
        script += fmt::format("window {}.png\n", i);
    }
    // By then, whatever came before the first of them, some are kept, and more follow.
    const RunResult run =
        suffer({.call = "vkQueuePresentKHR", .after = 24, .times = 1, .result = VK_ERROR_OUT_OF_DATE_KHR},
               script + "quit\n");
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.err, "");
    EXPECT_EQ(failedCall(), "vkQueuePresentKHR");
    EXPECT_GE(files().size(), std::size_t{kKept - 1});
}

TEST_F(ViewerFault, SavesTheRecordedPathWhenTheDeviceIsLost) {
    const RunResult run = suffer({.call = "vkQueueSubmit2", .device = "render", .after = 30},
                                 "wait-frame\nkey R\nhold W\nwait-frame 1000\nquit\n");
    expectOneLine(run, 1, kLost);
    EXPECT_EQ(files(), std::vector<std::string>{"camera-path-0001.json"});
}

TEST_F(ViewerFault, KeepsThePictureWhenMemoryRunsOut) {
    // What a window of 240x180 needs was had by then; what 1920x1080 needs is not to be had.
    const RunResult run = suffer(
        {.call = "vkAllocateMemory",
         .device = "render",
         .after = 8,
         .times = test::kForever,
         .result = VK_ERROR_OUT_OF_DEVICE_MEMORY},
        "wait-frame\nstate\npicture before.png\nresize 1920 1080\nwait-state memory\nwait-ui 3\nstate\n"
        "picture still.png\nquit\n");
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.err, "");
    const auto states = run.states(2);
    EXPECT_NE(valueOf(states[1], "notice").find("out of memory"), std::string::npos) << states[1];
    EXPECT_EQ(valueOf(states[1], "size"), "240x180");
    EXPECT_EQ(picture("still.png"), picture("before.png"));
}

} // namespace

} // namespace cdr::viewer_test
