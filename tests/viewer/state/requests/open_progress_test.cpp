#include <viewer/state/requests/open_progress.h>

#include <gtest/gtest.h>

namespace cdr::viewer_test {

namespace {

TEST(OpenProgress, IsSaidInPercentOfTheFile) {
    EXPECT_EQ(viewer::textOf({.file = "models/ship.glb", .done = 1, .all = 3}), "opening ship.glb: 33 %");
    EXPECT_EQ(viewer::textOf({.file = "ship.glb", .done = 0, .all = 3}), "opening ship.glb: 0 %");
    EXPECT_EQ(viewer::textOf({.file = "ship.glb", .done = 7, .all = 7}), "opening ship.glb: 100 %");
}

} // namespace

} // namespace cdr::viewer_test
