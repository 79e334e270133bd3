#include <scenes/earth/noise.h>

#include <gtest/gtest.h>

#include <cmath>

namespace cdr::scenes::test {

namespace {

TEST(Noise, NumbersOfCellsAreEvenAndBelongToTheirSeed) {
    double sum = 0.0;
    double squares = 0.0;
    int same = 0;
    for (int i = -100; i < 100; ++i) {
        for (int j = -100; j < 100; ++j) {
            const double number = cellNumber(i, j, 7);
            ASSERT_GE(number, 0.0);
            ASSERT_LT(number, 1.0);
            sum += number;
            squares += number * number;
            same += number == cellNumber(i, j, 8) || number == cellNumber(j, i, 7) ? 1 : 0;
        }
    }
    EXPECT_NEAR(sum / 40'000.0, 0.5, 0.01);
    EXPECT_NEAR(squares / 40'000.0, 1.0 / 3.0, 0.01);
    EXPECT_LE(same, 200) << "the diagonal alone";
}

TEST(Noise, CellsGoDownwardsFromZero) {
    EXPECT_EQ(cellOf(2.5), 2);
    EXPECT_EQ(cellOf(-0.5), -1);
    EXPECT_EQ(cellOf(-3.0), -3);
}

/// Also across the borders of cells and of the axes.
TEST(Noise, WavesAreSmoothAndKnowTheirSlope) {
    constexpr double kStep = 1e-4;
    for (int i = 0; i < 400; ++i) {
        const glm::dvec2 place(0.137 * i - 27.0, 0.071 * i - 14.0);
        const Wave wave = waveAt(place, 3.0, 5);
        EXPECT_LE(std::abs(wave.value), 1.0);
        for (const glm::dvec2& step : {glm::dvec2(kStep, 0.0), glm::dvec2(0.0, kStep)}) {
            const double rise = waveAt(place + step, 3.0, 5).value - waveAt(place - step, 3.0, 5).value;
            EXPECT_NEAR(rise / (2.0 * kStep), glm::dot(wave.slope, step) / kStep, 1e-4);
        }
    }
}

/// What a finer texel adds is small waves: their parts add up, and none is larger than its height.
TEST(Noise, FinerTexelsAddToCoarserOnes) {
    const Waves waves{.longest = 1'000.0, .shortest = 1.0, .gain = 0.5, .seed = 3};
    for (int i = 0; i < 200; ++i) {
        const glm::dvec2 place(71.0 * i, -37.0 * i);
        double before = sumWaves(waves, place, 512.0);
        EXPECT_EQ(before, 0.0) << "no wave is shown";
        double height = 1.0;
        for (double texel = 256.0; texel > 0.1; texel *= 0.5) {
            const double sum = sumWaves(waves, place, texel);
            EXPECT_LE(std::abs(sum - before), 2.0 * height);
            for (const Fineness& fineness : {Fineness{texel, texel}, Fineness{texel, 0.6 * texel}}) {
                EXPECT_NEAR(sumWaves(waves, place, fineness, WavePart::ofGrid) +
                                sumWaves(waves, place, fineness, WavePart::beyondGrid),
                            sum, 1e-12);
            }
            before = sum;
            height *= 0.5;
        }
        EXPECT_EQ(sumWaves(waves, place, 0.01), sumWaves(waves, place, 0.001)) << "all are shown";
    }
}

TEST(Noise, WhatIsLeftOutGrowsWithTexels) {
    const Waves waves{.longest = 1'000.0, .shortest = 100.0, .gain = 0.5, .seed = 3};
    EXPECT_EQ(leftOut(waves, 1.0), 0.0);
    EXPECT_NEAR(leftOut(waves, 50.0), 0.75 * 0.125, 1e-12) << "three quarters of the shortest";
    EXPECT_NEAR(leftOut(waves, 1e4), std::sqrt(1.0 + 0.25 + 0.0625 + 0.015625), 1e-12) << "all four";
}

} // namespace

} // namespace cdr::scenes::test
