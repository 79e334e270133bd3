#include <cdr/image/compose.h>

#include <gtest/gtest.h>

#include <string>

namespace cdr::image {

namespace {

ImageRgba8 drawn(const std::string& text) {
    ImageRgba8 picture(120, 30, {0, 0, 0, 255});
    drawText(picture, text, 1, 1, 1, {255, 255, 255, 255});
    return picture;
}

/// The font's tables end with ASCII, and texts name models and files.
TEST(Text, ShowsAQuestionMarkForWhatTheFontLacks) {
    const std::string text = "a\u00e4\u6a21\U0001f600\t\x1f\x7f~";
    EXPECT_EQ(drawn(text), drawn("a??????~"));
    EXPECT_EQ(textWidth(text, 2), textWidth("a??????~", 2));
    EXPECT_NE(drawn("?"), drawn(" "));
    EXPECT_EQ(textWidth("ab\n\xff", 1), textWidth("ab", 1));
}

} // namespace

} // namespace cdr::image
