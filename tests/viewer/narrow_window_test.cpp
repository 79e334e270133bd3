#include "viewer_run.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace cdr::viewer_test {

namespace {

/// F2 to F6 show nothing where the panels have no room, so they take no keys either.
TEST_F(ViewerTest, PanelsWithoutRoomTakeNoKeys) {
    const RunResult run = play("--size 480x300 --technique anchored cubes",
                               "wait-frame\nkey F3\nwait-ui 2\nstate\nkey C\nwait-ui 2\nstate\n"
                               "key tab\nkey X\nwait-ui 2\nkey tab\nwait-ui 2\nstate\nquit\n");
    const auto states = run.states(3);
    EXPECT_EQ(valueOf(states[0], "notice"), "the window is too narrow for the panels");
    EXPECT_NE(states[1].find("second=anchored"), std::string::npos) << states[1];
    EXPECT_EQ(valueOf(states[2], "notice"), "the window is too narrow for the panels");
}

/// A window that becomes too narrow while a panel has the keys.
TEST_F(ViewerTest, PanelsThatLoseTheirRoomGiveTheKeysBack) {
    const RunResult run = play("--size 560x300 --technique anchored cubes",
                               "wait-frame\nkey F3\nwait-ui 2\nresize 480 300\nwait-state size=480x300\n"
                               "wait-frame\nkey V\nwait-ui 2\nwait-frame\nstate\nquit\n");
    EXPECT_EQ(valueOf(run.states(1)[0], "view"), "cascades");
}

/// Without the share of wrong pixels, which is below.
image::ImageRgba8 rowsOfTitles(const image::ImageRgba8& window) {
    image::ImageRgba8 rows(window.width, 100);
    std::copy_n(window.pixels.begin(), rows.pixels.size(), rows.pixels.begin());
    return rows;
}

/// The title is longer than the left side is wide.
TEST_F(ViewerTest, TitlesStayOnTheirSideOfTheDivider) {
    const std::string script = "wait-frame\nmove 300 250\nwait-frame\nwait-ui 3\nwindow ";
    play("--size 640x300 --compare standard,anchored cubes", script + "short.png\nquit\n");
    play("--size 640x300 --compare anchored-reversed/fitted:1e-09,anchored cubes",
         script + "long.png\nquit\n");
    const image::ImageRgba8 shortTitle = rowsOfTitles(picture("short.png"));
    const image::ImageRgba8 longTitle = rowsOfTitles(picture("long.png"));
    constexpr std::uint32_t kDivider = (640 - 348) / 2;
    EXPECT_GT(difference(shortTitle, longTitle, 0, kDivider - 2), 0.01);
    EXPECT_EQ(difference(shortTitle, longTitle, kDivider + 2, 640 - 348), 0.0);
}

} // namespace

} // namespace cdr::viewer_test
