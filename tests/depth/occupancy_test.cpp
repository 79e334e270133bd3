#include <cdr/depth/occupancy.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace {

using namespace cdr::depth;

/// Points from -(count / 2) on, none of them in order.
std::vector<Interval> pointsAroundZero(int count) {
    std::vector<Interval> points;
    for (int i = 0; i < count; ++i) {
        const double place = i * 7 % count - count / 2; // 7 divides no count of the test
        points.push_back({place, place});
    }
    return points;
}

TEST(Occupancy, DistancesBehindTheCameraAscendToo) {
    for (const int count : {100, 1'600, 20'000}) {
        std::vector<Interval> points = pointsAroundZero(count);
        const std::vector<Interval> merged = mergeIntervals(points, -1e6, 1e6, 0.0);
        EXPECT_EQ(merged.size(), static_cast<std::size_t>(count));
        EXPECT_TRUE(std::ranges::is_sorted(merged, {}, &Interval::nearView)) << count;
    }
}

TEST(Occupancy, IntervalsThatShareAnEndBehindTheCameraAreOne) {
    std::vector<Interval> intervals{{-3.0, -1.0}, {-5.0, -3.0}};
    EXPECT_EQ(mergeIntervals(intervals, -10.0, 10.0, 1e-6).size(), 1u);
}

} // namespace
