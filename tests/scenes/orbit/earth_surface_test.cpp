#include "../../support/refusal.h"
#include "../../support/synthetic_earth.h"

#include <scenes/orbit/data.h>
#include <scenes/orbit/earth_surface.h>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

namespace cdr::scenes::test {

namespace {

constexpr Geodetic kHere{51.4775, -0.4850};

image::ImageRgba8 flatTopography() {
    return image::ImageRgba8(8, 4, {0, 0, 0, 255});
}

TEST(EarthSurface, IsTheEllipsoid) {
    const image::ImageRgba8 flat = flatTopography();
    const EarthSurface surface(flat, kHere, {.centre = {}, .radius = 1.0});
    const glm::dvec3 centre = surface.earthCentre();
    // WGS84: semi-axes, and a degree of latitude at 51.5 degrees.
    EXPECT_NEAR(glm::distance(surface.at({0.0, 77.0}), centre), 6'378'137.0, 1e-6);
    EXPECT_NEAR(glm::distance(surface.at({-90.0, 77.0}), centre), 6'356'752.3142, 1e-3);
    EXPECT_NEAR(glm::distance(surface.toWorld({51.0, 3.0}, 0.0), surface.toWorld({52.0, 3.0}, 0.0)),
                111'259.0, 10.0);
}

TEST(EarthSurface, HasItsOriginAndAxesAtThePlace) {
    const image::ImageRgba8 flat = flatTopography();
    const EarthSurface surface(flat, kHere, {.centre = {}, .radius = 1.0});
    EXPECT_LT(glm::length(surface.toWorld(kHere, 0.0)), 1e-8);
    EXPECT_NEAR(surface.toWorld(kHere, 1000.0).y, 1000.0, 1e-8);
    EXPECT_GT(surface.toWorld({kHere.latitude, kHere.longitude + 0.1}, 0.0).x, 6'000.0);  // east
    EXPECT_GT(surface.toWorld({kHere.latitude - 0.1, kHere.longitude}, 0.0).z, 11'000.0); // south
}

TEST(EarthSurface, ReadsHeightsBetweenTexels) {
    image::ImageRgba8 topography = flatTopography();
    topography.at(4, 1) = {40, 40, 40, 255}; // middle at 22.5 N, 22.5 E
    const EarthSurface surface(topography, {-40.0, 100.0}, {.centre = {}, .radius = 1.0});
    EXPECT_DOUBLE_EQ(surface.topographyAt({22.5, 22.5}), 1000.0);
    EXPECT_DOUBLE_EQ(surface.topographyAt({22.5, 45.0}), 500.0);
    EXPECT_DOUBLE_EQ(surface.topographyAt({0.0, 45.0}), 250.0);
    EXPECT_DOUBLE_EQ(surface.topographyAt({22.5, -157.5}), 0.0);
    topography.at(0, 1) = topography.at(4, 1);
    EXPECT_DOUBLE_EQ(surface.topographyAt({22.5, 180.0}), 500.0); // round the back
    EXPECT_DOUBLE_EQ(surface.topographyAt({22.5, -180.0}), 500.0);
}

TEST(EarthSurface, IsLevelOnThePadAndAsItWasBeyond) {
    const EarthMaps maps = cdr::test::syntheticEarth();
    const EarthSurface surface(maps.topography, kHere, {.centre = {1000.0, 500.0}, .radius = 2000.0});
    const EarthSurface wild(maps.topography, kHere, {.centre = {1e7, 0.0}, .radius = 1.0});
    std::size_t onPad = 0;
    std::size_t beyond = 0;
    for (double north = -0.05; north < 0.05; north += 0.0043) {
        for (double east = -0.08; east < 0.08; east += 0.0037) {
            const Geodetic place{kHere.latitude + north, kHere.longitude + east};
            const glm::dvec3 ground = surface.at(place);
            const double distance = glm::distance(glm::dvec2(ground.x, ground.z), glm::dvec2(1000.0, 500.0));
            if (distance <= 2000.0) {
                EXPECT_EQ(ground.y, 0.0);
                ++onPad;
            } else if (distance >= 4000.0) {
                EXPECT_EQ(ground, wild.at(place));
                ++beyond;
            } else {
                EXPECT_LE(std::abs(ground.y), std::abs(wild.at(place).y));
            }
        }
    }
    EXPECT_GT(onPad, 50u);
    EXPECT_GT(beyond, 50u);
}

TEST(EarthSurface, NormalsPointAwayFromTheEarth) {
    const EarthMaps maps = cdr::test::syntheticEarth();
    const EarthSurface surface(maps.topography, kHere, {.centre = {}, .radius = 1.0});
    for (const Geodetic& place : {Geodetic{90.0, 0.0}, Geodetic{-90.0, 10.0}, Geodetic{12.0, 180.0},
                                  Geodetic{-33.0, -70.0}, Geodetic{89.99, 5.0}}) {
        const glm::dvec3 up = glm::normalize(surface.at(place) - surface.earthCentre());
        const glm::dvec3 normal = surface.normalAt(place);
        EXPECT_NEAR(glm::length(normal), 1.0, 1e-12);
        EXPECT_GT(glm::dot(normal, up), 0.98);
    }
}

TEST(OrbitData, MissingMapsNameTheScriptThatFetchesThem) {
    const std::string refusal = cdr::test::inputErrorOf([] { loadEarthMaps("/nonexistent"); }, "loaded");
    EXPECT_NE(refusal.find("tools/setup.sh"), std::string::npos) << refusal;
    EXPECT_NE(refusal.find("earth-blue-marble.jpg"), std::string::npos) << refusal;
}

/// Known elevations, which kMetresPerGrey rests on.
TEST(OrbitData, RealHeightsAreThoseOfTheWorld) {
    const std::filesystem::path folder = orbitFiles().folder;
    if (!std::filesystem::exists(folder)) {
        GTEST_SKIP() << "the Earth of the scene orbit is not in " << folder << "; tools/setup.sh fetches it";
    }
    const EarthMaps maps = loadEarthMaps(folder);
    EXPECT_EQ(maps.color.width, 4096u);
    const EarthSurface surface(maps.topography, kHere, {.centre = {}, .radius = 1.0});
    struct Known {
        Geodetic place;
        double metres;
    };
    for (const Known& known :
         {Known{{40.4, -3.7}, 650.0}, Known{{33.0, 88.0}, 5000.0}, Known{{-19.0, -67.5}, 3750.0},
          Known{{39.7, -104.9}, 1700.0}, Known{{72.0, -40.0}, 3100.0}, Known{{0.0, -30.0}, 0.0}}) {
        EXPECT_NEAR(surface.topographyAt(known.place), known.metres, 60.0 + 0.05 * known.metres);
    }
}

} // namespace
} // namespace cdr::scenes::test
