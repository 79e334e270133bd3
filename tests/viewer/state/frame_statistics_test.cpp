#include "../../support/allocations.h"

#include <cdr/measure/statistics/statistics.h>
#include <viewer/state/frame_statistics.h>

#include <gtest/gtest.h>

#include <deque>
#include <random>
#include <set>
#include <string_view>

namespace cdr::viewer {

namespace {

StageTimes timesOf(float execute) {
    StageTimes times;
    times[FrameStage::cull] = 0.5f;
    times[FrameStage::execute] = execute;
    return times;
}

TEST(FrameStatistics, NothingIsZero) {
    const FrameStatistics statistics(8);
    EXPECT_EQ(statistics.frames(), 0u);
    EXPECT_EQ(statistics.total().max, 0.0f);
    EXPECT_TRUE(statistics.ring(FrameStage::cull).empty());
}

TEST(FrameStatistics, AgreesWithTheExperimentsPercentilesOverTheLastFrames) {
    constexpr std::size_t kWindow = 50;
    FrameStatistics statistics(kWindow);
    std::deque<double> kept;
    std::mt19937 random(1);
    for (int i = 0; i < 300; ++i) {
        const auto ms = static_cast<float>(random() % 1000) / 10.0f;
        statistics.add(timesOf(ms));
        kept.push_back(static_cast<double>(ms));
        if (kept.size() > kWindow) {
            kept.pop_front();
        }
        const std::vector<double> samples(kept.begin(), kept.end());
        const StageSummary summary = statistics.summary(FrameStage::execute);
        ASSERT_EQ(statistics.frames(), kept.size());
        EXPECT_EQ(summary.last, ms);
        EXPECT_NEAR(static_cast<double>(summary.median), measure::median(samples), 1e-5);
        EXPECT_NEAR(static_cast<double>(summary.p95), measure::percentile(samples, 95.0), 1e-5);
        EXPECT_NEAR(static_cast<double>(summary.p99), measure::percentile(samples, 99.0), 1e-5);
        EXPECT_NEAR(static_cast<double>(summary.max), measure::percentile(samples, 100.0), 1e-5);
        EXPECT_NEAR(statistics.total().last, ms + 0.5f, 1e-4f);
        // The ring from its oldest on is the series.
        const std::span<const float> ring = statistics.ring(FrameStage::execute);
        for (std::size_t k = 0; k < kept.size(); ++k) {
            ASSERT_EQ(static_cast<double>(ring[(statistics.oldest() + k) % ring.size()]), kept[k]) << i;
        }
    }
    EXPECT_EQ(statistics.totalRing().size(), kWindow);
    statistics.clear();
    EXPECT_EQ(statistics.frames(), 0u);
    statistics.add(timesOf(3.0f));
    EXPECT_EQ(statistics.summary(FrameStage::execute).max, 3.0f);
}

TEST(FrameStatistics, AllocatesNothingOnceMade) {
    FrameStatistics statistics(100);
    const std::size_t before = test::allocations;
    float sum = 0.0f;
    for (int i = 0; i < 250; ++i) {
        statistics.add(timesOf(static_cast<float>(i)));
        for (const FrameStage stage : kFrameStages) {
            sum += statistics.summary(stage).p99;
        }
        sum += statistics.total().median;
    }
    EXPECT_EQ(test::allocations, before);
    EXPECT_GT(sum, 0.0f);
    auto* const counted = new int(3); // the counter counts
    EXPECT_GT(test::allocations, before);
    delete counted;
}

TEST(FrameStatistics, AWindowOfNoneIsOne) {
    FrameStatistics statistics(0);
    statistics.add(timesOf(1.0f));
    statistics.add(timesOf(2.0f));
    EXPECT_EQ(statistics.summary(FrameStage::execute).median, 2.0f);
}

TEST(FrameStage, NamesAreDistinct) {
    std::set<std::string_view> names;
    for (const FrameStage stage : kFrameStages) {
        names.insert(nameOf(stage));
    }
    EXPECT_EQ(names.size(), kFrameStages.size());
    EXPECT_EQ(nameOf(FrameStage::cull), "cull");
    EXPECT_EQ(nameOf(FrameStage::present), "present");
}

} // namespace

} // namespace cdr::viewer
