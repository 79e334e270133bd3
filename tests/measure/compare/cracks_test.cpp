#include <cdr/base/error.h>
#include <cdr/measure/compare/cracks.h>

#include <gtest/gtest.h>

namespace {

using namespace cdr::measure;
const SeenPixel kBackground{};
const SeenPixel kNear{.id = 7, .distanceView = 10.0};
const SeenPixel kFar{.id = 9, .distanceView = 20.0};

/// Object 7 in the left 12 columns, object 9 beyond; background in the last 4 rows.
SeenImage twoObjects() {
    SeenImage ids(24, 20);
    for (std::uint32_t y = 0; y < ids.height; ++y) {
        for (std::uint32_t x = 0; x < ids.width; ++x) {
            ids.at(x, y) = y >= 16 ? kBackground : (x < 12 ? kNear : kFar);
        }
    }
    return ids;
}

TEST(Cracks, AreWhatShowsThrough) {
    const SeenImage whole = twoObjects();
    EXPECT_TRUE(findCracks(whole, whole).empty());
    SeenImage torn = whole;
    torn.at(5, 4) = kBackground;  // background inside an object
    torn.at(2, 8) = kFar;         // an object inside another
    torn.at(23, 0) = kBackground; // in a corner
    EXPECT_EQ(findCracks(torn, whole), (std::vector<Crack>{{23, 0, 0}, {5, 4, 0}, {2, 8, 9}}));
}

TEST(Cracks, SilhouettesMayMoveByTheReach) {
    const SeenImage whole = twoObjects();
    SeenImage moved = whole;
    for (std::uint32_t y = 0; y < moved.height; ++y) {
        moved.at(10, y) = kFar; // two columns from where it was
        moved.at(9, y) = kFar;  // three
    }
    const std::vector<Crack> cracks = findCracks(moved, whole);
    EXPECT_EQ(cracks.size(), 14u); // not beside background, which is farther still
    for (const Crack& crack : cracks) {
        EXPECT_EQ(crack.x, 9u);
    }
    EXPECT_EQ(findCracks(moved, whole, 1).size(), 30u);
    EXPECT_TRUE(findCracks(moved, whole, 3).empty());
}

/// A speck that no pixel's centre met before is no hole.
TEST(Cracks, WhatComesInFrontIsNone) {
    const SeenImage whole = twoObjects();
    SeenImage speck = whole;
    speck.at(4, 4) = {.id = 3, .distanceView = 5.0};
    speck.at(4, 19) = {.id = 3, .distanceView = 5.0};
    EXPECT_TRUE(findCracks(speck, whole).empty());
    speck.at(4, 4).distanceView = 11.0;
    EXPECT_EQ(findCracks(speck, whole), (std::vector<Crack>{{4, 4, 3}}));
}

TEST(Cracks, PicturesOfOtherSizesAreRefused) {
    EXPECT_THROW(findCracks(SeenImage(3, 4), SeenImage(4, 3)), cdr::base::InputError);
}

} // namespace
