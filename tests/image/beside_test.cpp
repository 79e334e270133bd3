#include <cdr/image/beside.h>

#include <gtest/gtest.h>

#include <array>

namespace cdr::image {

namespace {

ImageU32 numbered(std::uint32_t first) {
    ImageU32 picture(4, 2);
    for (std::uint32_t i = 0; i < 8; ++i) {
        picture.pixels[i] = first + i;
    }
    return picture;
}

using Row = std::vector<std::uint32_t>;

TEST(BesideTest, PicturesStandBesideEachOther) {
    const ImageU32 left = numbered(10);
    const ImageU32 right = numbered(50);
    const std::array pictures{&left, &right, &left};
    const ImageU32 joined = beside<std::uint32_t>(pictures);
    EXPECT_EQ(joined.width, 12u);
    EXPECT_EQ(joined.height, 2u);
    EXPECT_EQ(joined.pixels, (Row{10, 11, 12, 13, 50, 51, 52, 53, 10, 11, 12, 13, //
                                  14, 15, 16, 17, 54, 55, 56, 57, 14, 15, 16, 17}));
    EXPECT_TRUE(beside<std::uint32_t>({}).pixels.empty());
}

TEST(BesideTest, TheLeftPictureMovesLeftAndTheRightOneRight) {
    const ImageU32 left = numbered(10);
    const ImageU32 right = numbered(50);
    const std::array pictures{&left, &right};
    EXPECT_EQ(beside<std::uint32_t>(pictures, 3, 7).pixels,
              (Row{11, 12, 13, 7, 7, 7, 50, 51, 15, 16, 17, 7, 7, 7, 54, 55}));
    EXPECT_EQ(beside<std::uint32_t>(pictures, 1000, 7).pixels, Row(16, 7));
}

TEST(BesideTest, AnAnaglyphIsRedOfTheLeftAndCyanOfTheRight) {
    ImageRgba8 both(2, 1);
    both.pixels = {{1, 2, 3, 255}, {4, 5, 6, 255}};
    const ImageRgba8 anaglyph = anaglyphOf(both);
    EXPECT_EQ(anaglyph.width, 1u);
    EXPECT_EQ(anaglyph.at(0, 0), (Rgba8{1, 5, 6, 255}));
}

} // namespace

} // namespace cdr::image
