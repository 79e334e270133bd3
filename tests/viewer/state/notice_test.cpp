#include <viewer/state/model/interface_model.h>

#include <gtest/gtest.h>

namespace cdr::viewer {

namespace {

using std::chrono::seconds;

TEST(Notice, IsDrawnOnceMoreWhenItIsOver) {
    const std::chrono::steady_clock::time_point until{seconds(100)};
    const Notice notice{.text = "saved", .until = until};
    EXPECT_FALSE(notice.isOverSince(until - seconds(1), until)) << "it still shows";
    EXPECT_TRUE(notice.isOverSince(until - seconds(1), until + seconds(1)));
    EXPECT_FALSE(notice.isOverSince(until + seconds(1), until + seconds(2))) << "it is gone";
}

} // namespace

} // namespace cdr::viewer
