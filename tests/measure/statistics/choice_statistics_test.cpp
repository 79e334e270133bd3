#include <cdr/base/error.h>
#include <cdr/measure/statistics/choice_statistics.h>

#include <gtest/gtest.h>

namespace cdr::test {

using measure::binomialTail;
using measure::chiSquared;
using measure::chiSquaredTail;

/// Thesis Table 6.9.
TEST(ChoiceStatistics, ChiSquaredIsTheThesis) {
    EXPECT_NEAR(chiSquared({2, 10}), 5.333, 5e-4);
    EXPECT_NEAR(chiSquared({0, 12}), 12.0, 1e-12);
    EXPECT_NEAR(chiSquared({1, 11}), 8.333, 5e-4);
    EXPECT_EQ(chiSquared({11, 1}), chiSquared({1, 11}));
    EXPECT_EQ(chiSquared({6, 6}), 0.0);
}

/// The quantiles that every table of the distribution has.
TEST(ChoiceStatistics, TheTailHasTheTablesQuantiles) {
    EXPECT_NEAR(chiSquaredTail(2.705543), 0.10, 1e-7);
    EXPECT_NEAR(chiSquaredTail(3.841459), 0.05, 1e-7);
    EXPECT_NEAR(chiSquaredTail(6.634897), 0.01, 1e-7);
    EXPECT_NEAR(chiSquaredTail(10.827566), 0.001, 1e-8);
    EXPECT_EQ(chiSquaredTail(0.0), 1.0);
}

/// Counted by hand: of 4096 ways for twelve choices, C(12, 0) = 1, C(12, 1) = 12, C(12, 2) = 66.
TEST(ChoiceStatistics, TheBinomialTailCountsOutcomes) {
    EXPECT_NEAR(binomialTail({0, 12}), 2.0 * 1.0 / 4096.0, 1e-14);
    EXPECT_NEAR(binomialTail({1, 11}), 2.0 * 13.0 / 4096.0, 1e-13);
    EXPECT_NEAR(binomialTail({10, 2}), 2.0 * 79.0 / 4096.0, 1e-13);
    EXPECT_EQ(binomialTail({6, 6}), 1.0);
    EXPECT_NEAR(binomialTail({1, 0}), 1.0, 1e-14);
    EXPECT_NEAR(binomialTail({1, 2}), 1.0, 1e-13);
    EXPECT_NEAR(binomialTail({0, 3}), 0.25, 1e-13);
}

TEST(ChoiceStatistics, ManyTrialsNeitherOverflowNorLoseTheTail) {
    EXPECT_NEAR(binomialTail({500, 500}), 1.0, 1e-9);
    // For many trials the two tests agree.
    EXPECT_NEAR(binomialTail({49'500, 50'500}) / chiSquaredTail(chiSquared({49'500, 50'500})), 1.0, 0.02);
}

TEST(ChoiceStatistics, NoChoicesAreRefused) {
    EXPECT_THROW(chiSquared({0, 0}), base::InputError);
    EXPECT_THROW(binomialTail({0, 0}), base::InputError);
    EXPECT_THROW(binomialTail({0, 2'000'000}), base::InputError);
}

} // namespace cdr::test
