#include <cdr/base/error.h>
#include <experiments/timing/against.h>

#include <gtest/gtest.h>

#include <random>

namespace {

using cdr::base::InputError;
using cdr::experiments::BuildTimes;
using cdr::experiments::compare;
using cdr::experiments::Comparison;
using cdr::experiments::verdictOf;

/// Frames of about 1000 us here and 1000 us / factor there, each off by up to `noise` of it.
BuildTimes timesOf(double factor, double noise, std::size_t rounds = 15) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> share(1.0 - noise, 1.0 + noise);
    BuildTimes times{.name = "standard", .hereUs = {}, .againUs = {}, .againstUs = {}};
    for (std::size_t round = 0; round < rounds; ++round) {
        times.hereUs.push_back(1000.0 * share(random));
        times.againUs.push_back(1000.0 * share(random));
        times.againstUs.push_back(1000.0 / factor * share(random));
    }
    return times;
}

TEST(Against, SaysARatioThatStandsOutOfTheNoise) {
    const Comparison faster = compare(timesOf(0.8, 0.02), 1);
    EXPECT_NEAR(faster.ratio, 0.8, 0.02);
    EXPECT_TRUE(faster.ratio95.value().contains(faster.ratio));
    EXPECT_TRUE(faster.isSeen);
    EXPECT_EQ(verdictOf(faster).substr(0, 3), "0.8");
    EXPECT_TRUE(compare(timesOf(1.3, 0.02), 1).isSeen);
}

TEST(Against, RefusesToCallADifferenceBelowTheNoise) {
    for (const double factor : {1.0, 0.99, 1.01}) {
        const Comparison same = compare(timesOf(factor, 0.2), 1);
        EXPECT_FALSE(same.isSeen) << factor;
        EXPECT_NE(verdictOf(same).find("no difference seen, noise ±"), std::string::npos);
        EXPECT_GT(same.noisePercent.value(), 1.0);
    }
}

/// A ratio whose interval leaves out 1, but which this build differs by from itself too.
TEST(Against, CountsTheNoiseOfABuildOverItself) {
    BuildTimes times = timesOf(0.9, 0.001);
    for (std::size_t round = 0; round < times.hereUs.size(); ++round) {
        times.againUs[round] = 1.2 * times.hereUs[round];
    }
    const Comparison comparison = compare(times, 1);
    EXPECT_FALSE(comparison.ratio95.value().contains(1.0));
    EXPECT_NEAR(comparison.noisePercent.value(), 20.0, 0.1);
    EXPECT_FALSE(comparison.isSeen);
}

/// A median beyond the noise whose own interval still holds 1.
TEST(Against, CountsTheIntervalOfTheRatio) {
    BuildTimes times = timesOf(1.0, 0.0, 7);
    times.againstUs = {500.0, 2000.0, 500.0, 2000.0, 700.0, 1900.0, 800.0};
    const Comparison comparison = compare(times, 1);
    EXPECT_GT(comparison.ratio, 1.1);
    EXPECT_EQ(comparison.noisePercent, 0.0);
    EXPECT_FALSE(comparison.isSeen);
}

/// Five rounds have no 95 % interval of their median.
TEST(Against, FewRoundsSeeNothing) {
    EXPECT_TRUE(compare(timesOf(2.0, 0.01, 6), 1).isSeen);
    const Comparison few = compare(timesOf(2.0, 0.01, 5), 1);
    EXPECT_FALSE(few.isSeen);
    EXPECT_FALSE(few.ratio95.has_value());
    EXPECT_FALSE(few.noisePercent.has_value());
    EXPECT_EQ(verdictOf(few), "too few rounds to tell, 6 are needed");
}

/// Before this build has measured its frames.
TEST(Against, LooksForTheOtherProgramFirst) {
    std::size_t runs = 0;
    const cdr::experiments::AgainstOptions options{
        .here = "true", .against = "no-such-program", .arguments = {}, .rounds = 1, .seed = 1};
    EXPECT_THROW(cdr::experiments::runAgainst(options, [&](std::size_t, std::size_t) { ++runs; }),
                 InputError);
    EXPECT_EQ(runs, 0u);
}

TEST(Against, NeedsATimeOfEachRound) {
    BuildTimes times = timesOf(1.0, 0.1);
    times.againUs.pop_back();
    EXPECT_THROW(compare(times, 1), InputError);
    EXPECT_THROW(compare(timesOf(1.0, 0.1, 0), 1), InputError);
}

} // namespace
