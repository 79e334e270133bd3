#include "../../support/synthetic_earth.h"

#include <cdr/image/srgb.h>
#include <scenes/earth/airport_map.h>
#include <scenes/earth/concrete.h>
#include <scenes/earth/ground_blocks.h>
#include <scenes/earth/ground_painter.h>
#include <scenes/orbit/orbit.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace cdr::scenes::test {

namespace {

TEST(AirportMap, IsTheGroundNearTheAirport) {
    const EarthMaps maps = cdr::test::syntheticEarth();
    const EarthSurface surface(maps.topography, kOrbitAirport, {.radius = 1e3});
    const AirportMap map(kOrbitAirport);
    for (const Geodetic& aside :
         {Geodetic{0.0, 0.0}, Geodetic{0.02, 0.0}, Geodetic{0.0, 0.03}, Geodetic{-0.01, -0.02}}) {
        const Geodetic place{kOrbitAirport.latitude + aside.latitude,
                             kOrbitAirport.longitude + aside.longitude};
        const glm::dvec3 world = surface.toWorld(place, 0.0);
        EXPECT_NEAR(glm::distance(map.at(place), glm::dvec2(world.x, world.z)), 0.0,
                    4e-3 * glm::length(glm::dvec2(world.x, world.z)) + 1e-6);
    }
}

/// A square degree anywhere is as large on the map as on a sphere.
TEST(AirportMap, KeepsAreas) {
    const AirportMap map(kOrbitAirport);
    constexpr double kStep = 0.01;
    const double radians = kStep * std::numbers::pi / 180.0;
    for (const Geodetic& place :
         {Geodetic{50.0, 1.0}, Geodetic{0.0, 0.0}, Geodetic{-30.0, 120.0}, Geodetic{80.0, -170.0}}) {
        const glm::dvec2 corner = map.at(place);
        const glm::dvec2 east = map.at({place.latitude, place.longitude + kStep}) - corner;
        const glm::dvec2 north = map.at({place.latitude + kStep, place.longitude}) - corner;
        const double onSphere = radians * radians * kEarthRadius * kEarthRadius *
                                std::cos((place.latitude + 0.5 * kStep) * std::numbers::pi / 180.0);
        EXPECT_NEAR(std::abs(east.x * north.y - east.y * north.x) / onSphere, 1.0, 1e-3);
    }
}

TEST(GroundBlocks, EachLiesInTheLastAroundTheAirport) {
    const std::vector<GroundBlock> blocks = blocksAround(kOrbitAirport, 15);
    ASSERT_EQ(blocks.size(), 15u);
    for (std::size_t i = 1; i < blocks.size(); ++i) {
        const GeodeticFrame frame = blocks[i].frame();
        const GeodeticFrame around = blocks[i - 1].frame();
        EXPECT_GE(frame.west, around.west);
        EXPECT_LE(frame.west + frame.width, around.west + around.width);
        EXPECT_LE(frame.north, around.north);
        EXPECT_GE(frame.north - frame.height, around.north - around.height);
        const double across = (kOrbitAirport.longitude - frame.west) / frame.width;
        const double down = (frame.north - kOrbitAirport.latitude) / frame.height;
        const double least = blocks[i].columns == 4 ? 0.374 : 0.249;
        EXPECT_GE(std::min(across, 1.0 - across), least) << i;
        EXPECT_GE(std::min(down, 1.0 - down), least) << i;
        EXPECT_NEAR(frame.height, 0.5 * around.height, 1e-9) << i;
    }
}

TEST(GroundBlocks, CoverTilesThatLieInThemAsAWhole) {
    const GroundBlock block{.first = {3, 5, 2}, .columns = 4, .rows = 4};
    EXPECT_TRUE(block.covers({3, 5, 2}));
    EXPECT_TRUE(block.covers({4, 17, 11}));
    EXPECT_FALSE(block.covers({3, 9, 2}));
    EXPECT_FALSE(block.covers({4, 9, 4}));
    EXPECT_FALSE(block.covers({2, 2, 1})) << "it reaches out";
    EXPECT_TRUE(GroundBlock{}.covers({0, 1, 0}));
}

glm::dvec3 meanOf(const image::ImageRgba8& picture) {
    glm::dvec3 sum(0.0);
    for (const image::Rgba8& pixel : picture.pixels) {
        sum += glm::dvec3(pixel[0], pixel[1], pixel[2]);
    }
    return sum / static_cast<double>(picture.pixels.size());
}

class GroundPainterTest : public testing::Test {
  protected:
    image::ImageRgba8 paint(const GeodeticFrame& frame, std::uint32_t side, std::size_t threads = 2) const {
        platform::WorkerPool workers(threads);
        return m_painter.paint({.frame = frame, .width = side, .height = side}, workers);
    }

    image::ImageRgba8 m_marble{16, 8, {50, 58, 22, 255}}; ///< dark enough to be farmed
    GroundPainter m_painter{m_marble, kOrbitAirport, {-1'400.0, 2'200.0}};
    /// West of the airport: sixteen kilometres of fields, woods and a town.
    GeodeticFrame m_country{.west = -0.8, .north = 51.5, .width = 0.2, .height = 0.15};
};

/// So nothing jumps where a finer picture begins. Texels of a tenth of the size show more, but no other country.
TEST_F(GroundPainterTest, FineAndCoarsePicturesHaveOneColor) {
    const glm::dvec3 fine = meanOf(paint(m_country, 512));
    for (const std::uint32_t side : {128u, 32u, 8u}) {
        const glm::dvec3 difference = glm::abs(meanOf(paint(m_country, side)) - fine);
        EXPECT_LE(std::max({difference.r, difference.g, difference.b}), 8.0) << side;
    }
}

TEST_F(GroundPainterTest, NeitherThreadsNorThePictureAroundMatter) {
    const image::ImageRgba8 whole = paint(m_country, 64, 1);
    EXPECT_EQ(paint(m_country, 64, 2), whole);
    const GeodeticFrame quarter{
        .west = m_country.west + 0.1, .north = m_country.north, .width = 0.1, .height = 0.075};
    const image::ImageRgba8 part = paint(quarter, 32);
    int largest = 0;
    for (std::uint32_t y = 0; y < 32; ++y) {
        for (std::uint32_t x = 0; x < 32; ++x) {
            for (std::size_t c = 0; c < 3; ++c) {
                largest = std::max(largest, std::abs(int{part.at(x, y)[c]} - int{whole.at(x + 32, y)[c]}));
            }
        }
    }
    EXPECT_LE(largest, 1);
}

TEST_F(GroundPainterTest, HiddenTexelsAreSparedAndTheRestIsTheSame) {
    platform::WorkerPool workers(2);
    const image::ImageRgba8 whole = paint(m_country, 128);
    const GeodeticFrame middle{
        .west = m_country.west + 0.05, .north = m_country.north - 0.0375, .width = 0.1, .height = 0.075};
    const image::ImageRgba8 spared =
        m_painter.paint({.frame = m_country, .width = 128, .height = 128, .hidden = middle}, workers);
    std::size_t differing = 0;
    for (std::uint32_t y = 0; y < 128; ++y) {
        for (std::uint32_t x = 0; x < 128; ++x) {
            const bool isInside = x >= 48 && x <= 80 && y >= 48 && y <= 80;
            differing += whole.at(x, y) != spared.at(x, y) ? 1 : 0;
            ASSERT_TRUE(isInside || whole.at(x, y) == spared.at(x, y)) << x << " " << y;
        }
    }
    EXPECT_GT(differing, 200u);
}

/// The root of the mean square by which texels of a few columns differ from the ones below them.
double contrastOf(const image::ImageRgba8& picture, std::uint32_t first, std::uint32_t last) {
    double squares = 0.0;
    std::size_t count = 0;
    for (std::uint32_t y = picture.height / 4; y + 1 < picture.height * 3 / 4; ++y) {
        for (std::uint32_t x = first; x < last; ++x, ++count) {
            const double step = picture.at(x, y)[1] - picture.at(x, y + 1)[1];
            squares += step * step;
        }
    }
    return std::sqrt(squares / static_cast<double>(count));
}

/// Where a picture of half the texels begins, its country is as strong. Else a straight line is seen over the land.
TEST_F(GroundPainterTest, NoLineIsSeenWhereAFinerPictureBegins) {
    constexpr std::uint32_t kSide = 128;
    platform::WorkerPool workers(2);
    const GeodeticFrame around{.west = -1.1, .north = 51.8, .width = 1.1, .height = 0.7}; // texels of 600 m
    const GeodeticFrame middle{.west = -0.825, .north = 51.625, .width = 0.55, .height = 0.35};
    const GeodeticFrame finest{.west = -0.6875, .north = 51.5375, .width = 0.275, .height = 0.175};
    const image::ImageRgba8 coarse = m_painter.paint(
        {.frame = around, .width = kSide, .height = kSide, .hidden = middle, .fine = middle}, workers);
    const image::ImageRgba8 fine = m_painter.paint(
        {.frame = middle, .width = kSide, .height = kSide, .hidden = finest, .fine = finest}, workers);
    const double outside = contrastOf(coarse, 24, 32);
    const double inside = contrastOf(fine, 0, 8);
    EXPECT_GT(outside, 2.0) << "there is a country";
    EXPECT_NEAR(inside / outside, 1.0, 0.25);
    EXPECT_GT(contrastOf(fine, 40, 48) / outside, 1.5) << "further in, the finer one shows more";
}

TEST(BlueMarbleTest, LandIsAsGreenBesideTheSeaAsFarFromIt) {
    image::ImageRgba8 picture(16, 8);
    for (std::uint32_t y = 0; y < 8; ++y) {
        for (std::uint32_t x = 0; x < 16; ++x) {
            picture.at(x, y) = x < 8 ? image::Rgba8{50, 58, 22, 255} : image::Rgba8{26, 68, 130, 255};
        }
    }
    const BlueMarble marble(picture);
    const MarbleColor inland = marble.at({0.0, -90.0});
    EXPECT_EQ(inland.water, 0.0);
    const MarbleColor coast = marble.at({0.0, -5.0});
    EXPECT_GT(coast.water, 0.2);
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(coast.color[c], inland.color[c], 1e-12) << c;
    }
    EXPECT_GT(marble.at({0.0, 90.0}).color.b, 0.1) << "there is no land";
}

/// The Channel is sea, the Sahara is bright, and over the airport there is no cloud.
TEST_F(GroundPainterTest, TheAirportHasGrassAndNoCloud) {
    const image::ImageRgba8 lawn =
        paint({.west = -0.48, .north = 51.478, .width = 0.02, .height = 0.001}, 32);
    const glm::dvec3 mean = meanOf(lawn);
    EXPECT_GT(mean.g, mean.r);
    EXPECT_GT(mean.r, mean.b);
    EXPECT_LT(mean.b, 120.0);
}

/// Grain, and no other grey than that of the flat slab.
TEST(Concrete, HasGrainAndAKnownMean) {
    platform::WorkerPool workers(2);
    const std::array<double, 256>& linear = image::linearOfSrgb();
    for (const std::uint32_t side : {64u, 512u}) {
        const image::ImageRgba8 slab = paintConcrete(side, workers);
        double sum = 0.0;
        std::size_t steps = 0;
        for (std::uint32_t y = 0; y < side; ++y) {
            for (std::uint32_t x = 1; x < side; ++x) {
                sum += linear[slab.at(x, y)[0]];
                steps += slab.at(x, y) != slab.at(x - 1, y) ? 1 : 0;
            }
        }
        EXPECT_NEAR(sum / (side * (side - 1.0)), double{kConcreteMean}, 0.02) << side;
        EXPECT_GT(steps, std::size_t{side} * side / 4) << side;
    }
}

/// Seen through the narrowest lenses, else the grass beside the runway is one blur.
TEST_F(GroundPainterTest, GrassHasTufts) {
    constexpr std::uint32_t kSide = 64; // texels of a metre
    const image::ImageRgba8 lawn = paint({.west = kOrbitAirport.longitude + 0.0005,
                                          .north = kOrbitAirport.latitude + 0.0012,
                                          .width = 0.0009,
                                          .height = 0.00057},
                                         kSide);
    int steps = 0;
    for (std::uint32_t y = 0; y < kSide; ++y) {
        for (std::uint32_t x = 4; x < kSide; ++x) {
            steps += std::abs(int{lawn.at(x, y)[1]} - int{lawn.at(x - 4, y)[1]});
        }
    }
    EXPECT_GT(steps, 2 * static_cast<int>(kSide * (kSide - 4)));
}

} // namespace

} // namespace cdr::scenes::test
