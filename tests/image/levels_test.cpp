#include <cdr/image/levels.h>
#include <cdr/platform/worker_pool.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace cdr::image {

namespace {

/// Columns of bytes, all four channels alike, over a height of 1.
ImageRgba8 rowOf(const std::vector<std::uint8_t>& values) {
    ImageRgba8 row(static_cast<std::uint32_t>(values.size()), 1);
    for (std::size_t i = 0; i < values.size(); ++i) {
        row.pixels[i] = {values[i], values[i], values[i], values[i]};
    }
    return row;
}

ImageRgba8 noiseOfAlpha(std::uint32_t width, std::uint32_t height) {
    ImageRgba8 picture(width, height);
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        const auto bits = static_cast<std::uint32_t>(i * 2654435761u);
        for (std::size_t c = 0; c < 4; ++c) {
            picture.pixels[i][c] = static_cast<std::uint8_t>(bits >> (8 * c));
        }
    }
    return picture;
}

/// The share of a picture that has at least an alpha, interpolated between pixels.
double shareFrom(const ImageRgba8& picture, double alpha) {
    std::size_t count = 0;
    const auto at = [&](double x, double y) {
        return static_cast<double>(
            picture.at(static_cast<std::uint32_t>(std::clamp(x, 0.0, picture.width - 1.0)),
                       static_cast<std::uint32_t>(std::clamp(y, 0.0, picture.height - 1.0)))[3]);
    };
    constexpr double kStep = 0.5; // of a pixel
    for (double y = -0.25; y < picture.height - 0.5; y += kStep) {
        for (double x = -0.25; x < picture.width - 0.5; x += kStep) {
            const double left = std::floor(x);
            const double top = std::floor(y);
            const double above = std::lerp(at(left, top), at(left + 1.0, top), x - left);
            const double below = std::lerp(at(left, top + 1.0), at(left + 1.0, top + 1.0), x - left);
            count += std::lerp(above, below, y - top) >= alpha ? 1 : 0;
        }
    }
    return static_cast<double>(count) * kStep * kStep / static_cast<double>(picture.pixels.size());
}

} // namespace

TEST(Levels, HalveEachSideDownToOnePixel) {
    EXPECT_EQ(levelCount(0, 5), 0u);
    EXPECT_EQ(levelCount(1, 1), 1u);
    EXPECT_EQ(levelCount(1, 5), 3u);
    EXPECT_EQ(levelCount(1024, 256), 11u);
    EXPECT_EQ(levelPixels(5, 3, 0), 0u);
    EXPECT_EQ(levelPixels(5, 3, 2), 17u);
    EXPECT_EQ(levelPixels(4, 1, 3), 7u);
    const std::vector<ImageRgba8> levels = smallerLevels(ImageRgba8(13, 3), Encoding::srgb, 99);
    ASSERT_EQ(levels.size(), 3u);
    EXPECT_EQ(levels[0].width, 6u);
    EXPECT_EQ(levels[0].height, 1u);
    EXPECT_EQ(levels[1].width, 3u);
    EXPECT_EQ(levels[2].width, 1u);
    EXPECT_EQ(smallerLevels(ImageRgba8(13, 3), Encoding::srgb, 2).size(), 2u);
    EXPECT_TRUE(smallerLevels(ImageRgba8(13, 3), Encoding::srgb, 0).empty());
    EXPECT_TRUE(smallerLevels(ImageRgba8(1, 1), Encoding::srgb, 9).empty());
}

TEST(Levels, AverageLightAndNotItsCode) {
    const Rgba8 color = smallerLevels(rowOf({0, 255}), Encoding::srgb, 1).at(0).at(0, 0);
    EXPECT_EQ(color, (Rgba8{188, 188, 188, 128})); // alpha is no light
    EXPECT_EQ(smallerLevels(rowOf({64, 192}), Encoding::srgb, 1).at(0).at(0, 0)[0], 146);
    const Rgba8 data = smallerLevels(rowOf({0, 255}), Encoding::linear, 1).at(0).at(0, 0);
    EXPECT_EQ(data, (Rgba8{128, 128, 128, 128}));
}

TEST(Levels, AreNotRoundedFromLevelToLevel) {
    // Rounded at each level, a quarter would become 0.5 and then 1.
    EXPECT_EQ(smallerLevels(rowOf({0, 1, 0, 0}), Encoding::linear, 2).at(1).at(0, 0)[0], 0);
    EXPECT_EQ(smallerLevels(rowOf({1, 1, 0, 1}), Encoding::linear, 2).at(1).at(0, 0)[0], 1);
}

TEST(Levels, OddSidesCountByWhatIsCovered) {
    // Each of the two covers 2.5 pixels of five.
    const ImageRgba8 halves = smallerLevels(rowOf({0, 50, 100, 150, 200}), Encoding::linear, 1).at(0);
    ASSERT_EQ(halves.width, 2u);
    EXPECT_EQ(halves.at(0, 0)[0], 40); // (0 + 50 + 0.5 * 100) / 2.5
    EXPECT_EQ(halves.at(1, 0)[0], 160);
    // The mean of all is kept, whatever the sides.
    for (const std::uint32_t side : {3u, 7u, 21u, 101u}) {
        ImageRgba8 picture(side, side / 2 + 1);
        double sum = 0.0;
        for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
            picture.pixels[i][1] = static_cast<std::uint8_t>((i * 97) % 251);
            sum += picture.pixels[i][1];
        }
        const Rgba8 last = smallerLevels(picture, Encoding::linear, 99).back().at(0, 0);
        EXPECT_EQ(last[1], std::lround(sum / static_cast<double>(picture.pixels.size()))) << side;
    }
}

TEST(Levels, OneColourStaysAsItIs) {
    for (std::size_t value = 0; value < 256; ++value) {
        const auto byte = static_cast<std::uint8_t>(value);
        const ImageRgba8 picture(7, 5, {byte, byte, byte, byte});
        for (const ImageRgba8& level : smallerLevels(picture, Encoding::srgb, 9)) {
            for (const Rgba8& pixel : level.pixels) {
                EXPECT_EQ(pixel, picture.at(0, 0));
            }
        }
    }
}

TEST(Levels, AreTheSameForAnyNumberOfWorkers) {
    const ImageRgba8 picture = noiseOfAlpha(1021, 514);
    ASSERT_TRUE(areLevelsDivided(picture.width, picture.height));
    EXPECT_FALSE(areLevelsDivided(128, 128));
    for (const LevelRules& rules :
         {LevelRules{}, LevelRules{.encoding = Encoding::linear, .alphaWeighs = true, .cutoff = 0.7f}}) {
        const std::vector<ImageRgba8> alone = smallerLevels(picture, rules, 99);
        for (const std::size_t threads : {1u, 2u, 3u, 7u}) {
            platform::WorkerPool workers(threads);
            EXPECT_EQ(smallerLevels(picture, rules, 99, &workers), alone) << threads;
            workers.setSchedule(12345); // another order of the bands
            EXPECT_EQ(smallerLevels(picture, rules, 99, &workers), alone) << threads;
        }
    }
}

TEST(Levels, WhatIsClearHasNoPartInColours) {
    ImageRgba8 picture(4, 1, {200, 100, 50, 255});
    picture.at(1, 0) = {0, 255, 0, 0}; // what it hides must not show
    picture.at(2, 0) = picture.at(3, 0) = {30, 30, 30, 0};
    const std::vector<ImageRgba8> levels = smallerLevels(picture, LevelRules{.alphaWeighs = true}, 2);
    EXPECT_EQ(levels.at(0).at(0, 0), (Rgba8{200, 100, 50, 128}));
    EXPECT_EQ(levels.at(0).at(1, 0), (Rgba8{30, 30, 30, 0})); // nothing else is there
    EXPECT_EQ(levels.at(1).at(0, 0), (Rgba8{200, 100, 50, 64}));
    EXPECT_NE(smallerLevels(picture, LevelRules{}, 1).at(0).at(0, 0)[0], 200);
    picture = ImageRgba8(2, 1, {255, 0, 0, 200});
    picture.at(1, 0) = {0, 0, 0, 100};
    const LevelRules data{.encoding = Encoding::linear, .alphaWeighs = true};
    EXPECT_EQ(smallerLevels(picture, data, 1).at(0).at(0, 0), (Rgba8{170, 0, 0, 150}));
}

/// Leaves of few texels: their average soon lies below any cutoff.
TEST(Levels, MaskedOnesKeepWhatIsShown) {
    ImageRgba8 picture(256, 256, {90, 120, 40, 0});
    for (std::uint32_t y = 0; y < 256; ++y) {
        for (std::uint32_t x = 0; x < 256; ++x) {
            const std::uint32_t spread = (x / 3 * 2654435761u) ^ (y / 3 * 2246822519u);
            picture.at(x, y)[3] = (spread >> 20u) % 10 < 3 ? 255 : 0;
        }
    }
    ASSERT_NEAR(shareFrom(picture, 127.5), 0.3, 0.05);
    const std::vector<ImageRgba8> plain = smallerLevels(picture, LevelRules{}, 5);
    for (const float cutoff : {0.5f, 0.2f}) {
        const double first = std::ceil(cutoff * 255.0f) - 0.5;
        const double whole = shareFrom(picture, first);
        const std::vector<ImageRgba8> kept = smallerLevels(picture, LevelRules{.cutoff = cutoff}, 5);
        for (std::size_t level = 0; level < kept.size(); ++level) {
            // The first level has few values of alpha, and all samples of one are kept, or none of them.
            EXPECT_NEAR(shareFrom(kept[level], first), whole, level == 0 ? 0.15 : 0.04)
                << cutoff << ", level " << level;
        }
        EXPECT_GT(std::abs(shareFrom(plain[4], first) - whole), 0.1) << cutoff;
    }
    for (const float none : {0.0f, -1.0f, 1.5f, std::nanf("")}) {
        EXPECT_EQ(smallerLevels(picture, LevelRules{.cutoff = none}, 5), plain) << none;
    }
}

/// Alpha that is the same everywhere stays so.
TEST(Levels, APictureThatIsAllShownKeepsItsAlpha) {
    for (const std::uint8_t alpha : {std::uint8_t{255}, std::uint8_t{140}, std::uint8_t{20}}) {
        const ImageRgba8 picture(9, 6, {1, 2, 3, alpha});
        for (const ImageRgba8& level : smallerLevels(picture, LevelRules{.cutoff = 0.5f}, 9)) {
            EXPECT_EQ(level.at(0, 0)[3], alpha);
        }
    }
}

} // namespace cdr::image
