#include <cdr/base/error.h>
#include <cdr/measure/compare/wrong_pixels.h>

#include <gtest/gtest.h>

#include <string_view>
#include <vector>

namespace cdr::test {

namespace {

using measure::TruthImage;
using measure::WrongPixels;

/// One row per string, one pixel per digit: its id.
TruthImage truthOf(const std::vector<std::string_view>& rows) {
    TruthImage truth(static_cast<std::uint32_t>(rows[0].size()), static_cast<std::uint32_t>(rows.size()));
    for (std::uint32_t y = 0; y < truth.height; ++y) {
        for (std::uint32_t x = 0; x < truth.width; ++x) {
            truth.at(x, y).id = static_cast<std::uint32_t>(rows[y][x] - '0');
        }
    }
    return truth;
}

image::ImageU32 idsOf(const TruthImage& truth) {
    image::ImageU32 ids(truth.width, truth.height);
    for (std::size_t i = 0; i < ids.pixels.size(); ++i) {
        ids.pixels[i] = truth.pixels[i].id;
    }
    return ids;
}

/// Inner are the six pixels (1..3, 1..2), nothing else.
TruthImage smallTruth() {
    return truthOf({"111112", //
                    "111112", //
                    "111112", //
                    "111112", //
                    "000002"});
}

constexpr image::Rgba8 kRed{255, 0, 0, 255};
constexpr image::Rgba8 kOrange{255, 165, 0, 255};

} // namespace

TEST(InnerMask, NeedsEightNeighboursOfOneObject) {
    const auto mask = measure::innerMask(smallTruth());
    for (std::uint32_t y = 0; y < 5; ++y) {
        for (std::uint32_t x = 0; x < 6; ++x) {
            EXPECT_EQ(mask.at(x, y), x >= 1 && x <= 3 && y >= 1 && y <= 2 ? 1 : 0) << x << ' ' << y;
        }
    }
}

TEST(InnerMask, EachOfTheEightNeighboursCounts) {
    for (std::uint32_t i = 0; i < 9; ++i) {
        TruthImage truth(3, 3, {.id = 4});
        EXPECT_EQ(measure::innerMask(truth).at(1, 1), 1);
        truth.pixels[i].id = 5;
        EXPECT_EQ(measure::innerMask(truth).at(1, 1), 0) << i;
    }
}

TEST(InnerMask, BackgroundAndBordersAreNotInner) {
    EXPECT_EQ(measure::innerMask(TruthImage(4, 4)), image::Raster<std::uint8_t>(4, 4));
    EXPECT_EQ(measure::innerMask(TruthImage(1, 1, {.id = 1})), image::Raster<std::uint8_t>(1, 1));
    EXPECT_EQ(measure::innerMask(TruthImage(2, 9, {.id = 1})), image::Raster<std::uint8_t>(2, 9));
    EXPECT_EQ(measure::innerMask(TruthImage()), image::Raster<std::uint8_t>());
}

TEST(CountWrong, EqualImagesHaveNone) {
    const WrongPixels count = measure::countWrong(idsOf(smallTruth()), smallTruth());
    EXPECT_EQ(count.pixels, 6u);
    EXPECT_EQ(count.wrong, 0u);
    EXPECT_EQ(count.edgeWrong, 0u);
    EXPECT_EQ(count.overlapPixels, 0u);
    EXPECT_EQ(count.fraction(), 0.0);
    EXPECT_EQ(count.overlapFraction(), std::nullopt) << "a share of nothing";
    EXPECT_EQ(measure::countWrong(image::ImageU32(6, 5), TruthImage(6, 5)).fraction(), std::nullopt);
}

TEST(CountWrong, TellsInnerEdgeAndOverlapApart) {
    TruthImage truth = smallTruth();
    truth.at(1, 1).secondId = 9;
    truth.at(2, 1).secondId = 9;
    truth.at(3, 1).secondId = 9;
    truth.at(0, 0).secondId = 9; // a border pixel: no overlap pixel
    image::ImageU32 ids = idsOf(truth);
    ids.at(1, 1) = 9; // inner, overlap
    ids.at(2, 2) = 0; // inner, no overlap
    ids.at(0, 0) = 9; // border
    ids.at(4, 2) = 2; // edge
    ids.at(5, 2) = 1; // edge
    ids.at(2, 4) = 1; // background
    const WrongPixels count = measure::countWrong(ids, truth);
    EXPECT_EQ(count.pixels, 6u);
    EXPECT_EQ(count.wrong, 2u);
    EXPECT_EQ(count.edgeWrong, 4u);
    EXPECT_EQ(count.overlapPixels, 3u);
    EXPECT_EQ(count.overlapWrong, 1u);
    EXPECT_DOUBLE_EQ(count.fraction().value(), 2.0 / 6.0);
    EXPECT_DOUBLE_EQ(count.overlapFraction().value(), 1.0 / 3.0);
}

TEST(CountWrong, Adds) {
    WrongPixels sum{1, 2, 3, 4, 5};
    sum += {10, 20, 30, 40, 50};
    EXPECT_EQ(sum.pixels, 11u);
    EXPECT_EQ(sum.wrong, 22u);
    EXPECT_EQ(sum.edgeWrong, 33u);
    EXPECT_EQ(sum.overlapPixels, 44u);
    EXPECT_EQ(sum.overlapWrong, 55u);
}

TEST(CountWrong, RefusesAnotherSize) {
    EXPECT_THROW(measure::countWrong(image::ImageU32(5, 6), TruthImage(6, 5)), base::InputError);
    EXPECT_THROW(measure::countWrong(image::ImageU32(6, 4), TruthImage(6, 5)), base::InputError);
}

TEST(HeatMap, MarksWrongPixelsAndDimsTheRest) {
    const TruthImage truth = smallTruth();
    image::ImageU32 ids = idsOf(truth);
    ids.at(2, 1) = 7;
    ids.at(5, 4) = 0;
    image::ImageRgba8 picture(6, 5, {255, 255, 255, 9});
    picture.at(0, 0) = {0, 0, 0, 0};
    picture.at(1, 0) = {0, 200, 0, 255};
    const image::ImageRgba8 map = measure::heatMap(ids, truth, picture);
    EXPECT_EQ(map.at(2, 1), kRed);
    EXPECT_EQ(map.at(5, 4), kOrange);
    EXPECT_EQ(map.at(0, 0), (image::Rgba8{0, 0, 0, 255}));
    EXPECT_EQ(map.at(1, 0), (image::Rgba8{71, 71, 71, 255})) << "half of 0.7152 * 200";
    EXPECT_EQ(map.at(3, 3), (image::Rgba8{127, 127, 127, 255}));
}

TEST(HeatMap, RefusesAnotherSize) {
    EXPECT_THROW(measure::heatMap(image::ImageU32(5, 6), TruthImage(6, 5), image::ImageRgba8(6, 5)),
                 base::InputError);
    EXPECT_THROW(measure::heatMap(image::ImageU32(6, 5), TruthImage(6, 5), image::ImageRgba8(5, 6)),
                 base::InputError);
}

} // namespace cdr::test
