#include <cdr/base/error.h>
#include <cdr/measure/cracks.h>

#include <gtest/gtest.h>

namespace {

using namespace cdr::measure;
using cdr::image::ImageU32;

/// Object 7 in the left 12 columns, object 9 beyond; background in the last 4 rows.
ImageU32 twoObjects() {
    ImageU32 ids(24, 20, 7);
    for (std::uint32_t y = 0; y < ids.height; ++y) {
        for (std::uint32_t x = 0; x < ids.width; ++x) {
            ids.at(x, y) = y >= 16 ? 0 : (x < 12 ? 7 : 9);
        }
    }
    return ids;
}

TEST(Cracks, AreWhatShowsThrough) {
    const ImageU32 whole = twoObjects();
    EXPECT_TRUE(findCracks(whole, whole).empty());
    ImageU32 torn = whole;
    torn.at(5, 4) = 0;  // background inside an object
    torn.at(2, 8) = 9;  // an object inside another
    torn.at(23, 0) = 0; // in a corner
    EXPECT_EQ(findCracks(torn, whole), (std::vector<Crack>{{23, 0, 0}, {5, 4, 0}, {2, 8, 9}}));
}

TEST(Cracks, SilhouettesMayMoveByTheReach) {
    const ImageU32 whole = twoObjects();
    ImageU32 moved = whole;
    for (std::uint32_t x = 0; x < moved.width; ++x) {
        moved.at(x, 15) = 0;
        moved.at(x, 14) = 0;
        moved.at(x, 16) = 7;
    }
    // Object 7 came where it was not, in the row beneath object 9 and 2 columns from itself.
    const std::vector<Crack> cracks = findCracks(moved, whole);
    EXPECT_EQ(cracks.size(), 10u);
    for (const Crack& crack : cracks) {
        EXPECT_EQ(crack.id, 7u);
        EXPECT_GE(crack.x, 14u);
    }
    EXPECT_EQ(findCracks(moved, whole, 1).size(), 11u + 24u);
    EXPECT_TRUE(findCracks(moved, whole, 24).empty());
}

TEST(Cracks, PicturesOfOtherSizesAreRefused) {
    EXPECT_THROW(findCracks(ImageU32(3, 4), ImageU32(4, 3)), cdr::base::InputError);
}

} // namespace
