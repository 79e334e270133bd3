#include <cdr/image/picture_size.h>

#include <gtest/gtest.h>

namespace cdr::image {

namespace {

TEST(PictureSize, IsParsedFromWidthTimesHeight) {
    EXPECT_EQ(parsePictureSize("1280x720"), (PictureSize{.width = 1280, .height = 720}));
    EXPECT_EQ(parsePictureSize("4294967295x1"), (PictureSize{.width = 4294967295u, .height = 1}));
}

TEST(PictureSize, OfAnyOtherTextIsRefused) {
    for (const char* text : {"", "x", "1280", "1280x", "x720", "0x720", "1280x0", "-1x2", "1x-2", "1 x2",
                             "1x2 ", "1x2x3", "1280X720", "1.5x2", "4294967296x1"}) {
        EXPECT_FALSE(parsePictureSize(text).has_value()) << text;
    }
}

} // namespace

} // namespace cdr::image
