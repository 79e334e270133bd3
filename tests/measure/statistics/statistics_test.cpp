#include <cdr/base/error.h>
#include <cdr/measure/statistics/scaling_law.h>
#include <cdr/measure/statistics/statistics.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>

namespace {

using namespace cdr::measure;

TEST(Statistics, MedianTakesTheMiddle) {
    EXPECT_EQ(median({7.0}), 7.0);
    EXPECT_EQ(median({3.0, 1.0, 2.0}), 2.0);
    EXPECT_EQ(median({4.0, 1.0, 3.0, 2.0}), 2.5);
    EXPECT_EQ(median({1.0, 1.0, 1e9}), 1.0);
}

/// numpy.percentile of the same list.
TEST(Statistics, PercentileInterpolatesAsNumPyDoes) {
    const std::vector<double> samples{15.0, 20.0, 35.0, 40.0, 50.0};
    EXPECT_DOUBLE_EQ(percentile(samples, 0.0), 15.0);
    EXPECT_DOUBLE_EQ(percentile(samples, 40.0), 29.0);
    EXPECT_DOUBLE_EQ(percentile(samples, 50.0), 35.0);
    EXPECT_DOUBLE_EQ(percentile(samples, 90.0), 46.0);
    EXPECT_DOUBLE_EQ(percentile(samples, 100.0), 50.0);
}

TEST(Statistics, AnInfiniteSampleIsNoneOfThoseBelowIt) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(median({kInfinity, 1.0, 2.0}), 2.0);
    EXPECT_EQ(percentile({1.0, kInfinity}, 0.0), 1.0);
    EXPECT_EQ(median({1.0, 2.0, kInfinity, kInfinity}), kInfinity);
}

TEST(Statistics, NoSamplesAreRefused) {
    EXPECT_THROW(median({}), cdr::base::InputError);
    EXPECT_THROW(percentile({}, 5.0), cdr::base::InputError);
    EXPECT_THROW(bootstrapMedian({}, 1), cdr::base::InputError);
}

/// Even from the smallest to the largest of five, one interval in 16 misses the median.
TEST(Bootstrap, FiveSamplesHaveNoInterval) {
    EXPECT_FALSE(bootstrapMedian({3.0}, 1).has_value());
    EXPECT_FALSE(bootstrapMedian({1.0, 2.0, 3.0, 4.0, 5.0}, 1).has_value());
    EXPECT_TRUE(bootstrapMedian({1.0, 2.0, 3.0, 4.0, 5.0, 6.0}, 1).has_value());
}

TEST(Bootstrap, EqualSamplesLeaveNoDoubt) {
    for (const std::vector<double>& samples : {std::vector(6, 3.0), std::vector(50, 3.0)}) {
        const Interval interval = bootstrapMedian(samples, 1).value();
        EXPECT_EQ(interval.low, 3.0);
        EXPECT_EQ(interval.high, 3.0);
    }
}

TEST(Bootstrap, ASeedFixesTheInterval) {
    std::vector<double> samples(101);
    std::iota(samples.begin(), samples.end(), 0.0);
    const Interval first = bootstrapMedian(samples, 42).value();
    std::reverse(samples.begin(), samples.end());
    const Interval second = bootstrapMedian(samples, 42).value();
    EXPECT_EQ(first.low, second.low);
    EXPECT_EQ(first.high, second.high);
}

/// Of the 7^7 resamples of seven, 1.0 % have the least as their median, and 10.8 % one of the two least (binomial). The other
/// end mirrors it.
TEST(Bootstrap, DrawsEverySampleEquallyOften) {
    const Interval interval = bootstrapMedian({1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0}, 7).value();
    EXPECT_EQ(interval.low, 2.0);
    EXPECT_EQ(interval.high, 6.0);
}

/// Over 0 to 1000 the ranks of the exact 95 % interval of a median (binomial, n = 1001) are 470 and 532, one
/// based.
TEST(Bootstrap, AgreesWithTheBinomialInterval) {
    std::vector<double> samples(1001);
    std::iota(samples.begin(), samples.end(), 0.0);
    const Interval interval = bootstrapMedian(samples, 3, 20'000).value();
    EXPECT_NEAR(interval.low, 469.0, 3.0);
    EXPECT_NEAR(interval.high, 531.0, 3.0);
}

/// A 95 % interval misses the true median about once in twenty.
TEST(Bootstrap, HoldsTheTrueMedianAsOftenAsItSays) {
    std::mt19937_64 random(5);
    int held = 0;
    for (std::uint64_t trial = 0; trial < 400; ++trial) {
        std::vector<double> samples(80);
        for (double& sample : samples) {
            sample = static_cast<double>(random() >> 11) * 0x1p-53;
        }
        held += bootstrapMedian(samples, trial, 400).value().contains(0.5) ? 1 : 0;
    }
    EXPECT_GT(held, 362);
    EXPECT_LT(held, 398);
}

TEST(ScalingLaw, AmdahlFindsItsOwnSerialFraction) {
    std::vector<SpeedUp> points;
    for (const double p : {1.0, 2.0, 4.0, 7.0}) {
        points.push_back({.threads = p, .factor = 1.0 / (0.2 + 0.8 / p)});
    }
    EXPECT_NEAR(fitAmdahl(points).value(), 0.2, 1e-12);
    EXPECT_NEAR(fitAmdahl({{2.0, 2.0}}).value(), 0.0, 1e-12);
    EXPECT_NEAR(fitAmdahl({{2.0, 1.0}}).value(), 1.0, 1e-12);
    EXPECT_EQ(fitAmdahl({{2.0, 3.0}}), 0.0); // better than threads can
    EXPECT_EQ(fitAmdahl({{2.0, 0.8}}), 1.0); // slower than one
    EXPECT_FALSE(fitAmdahl({{1.0, 1.0}}).has_value());
    EXPECT_FALSE(fitAmdahl({}).has_value());
}

TEST(ScalingLaw, UniversalScalabilityFindsItsOwnCoefficients) {
    std::vector<SpeedUp> points;
    for (const double p : {1.0, 2.0, 4.0, 8.0}) {
        points.push_back({.threads = p, .factor = p / (1.0 + 0.05 * (p - 1.0) + 0.01 * p * (p - 1.0))});
    }
    const UniversalScalability found = fitUniversalScalability(points).value();
    EXPECT_NEAR(found.contention, 0.05, 1e-12);
    EXPECT_NEAR(found.coherence, 0.01, 1e-12);
}

TEST(ScalingLaw, UniversalScalabilityNeedsFourPointsAndTwoCounts) {
    EXPECT_FALSE(fitUniversalScalability({{1.0, 1.0}, {2.0, 1.9}, {3.0, 2.5}}).has_value());
    EXPECT_FALSE(fitUniversalScalability({{1.0, 1.0}, {2.0, 1.9}, {2.0, 1.8}, {2.0, 1.7}}).has_value());
}

} // namespace
