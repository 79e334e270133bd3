#include <cdr/image/levels.h>
#include <cdr/image/srgb.h>

#include <gtest/gtest.h>

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

} // namespace cdr::image
