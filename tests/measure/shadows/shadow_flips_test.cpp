#include <cdr/base/error.h>
#include <cdr/measure/shadows/shadow_flips.h>

#include <gtest/gtest.h>

namespace cdr::measure {

namespace {

/// One lit object over the whole picture, drawn as it is.
struct LitPicture {
    ShadowImage truth{8, 6, {.id = 3, .reach = Reach::reached}};
    image::ImageRgba8 reached{8, 6, {0, 255, 0, 0}};

    ShadowFrame frame() const { return {.light = {reached, 1}, .truth = truth}; }
};

TEST(ShadowFlipsTest, AFlipIsAChangeThatTheTruthDoesNotMake) {
    const LitPicture before;
    LitPicture after;
    EXPECT_EQ(countShadowFlips(before.frame(), after.frame()), (FlipCount{.flips = 0, .compared = 6 * 4}));
    after.reached.at(3, 3)[1] = 0;
    after.reached.at(4, 3)[0] = 255; // another light
    after.reached.at(0, 3)[1] = 0;   // at the border, which is not inner
    EXPECT_EQ(countShadowFlips(before.frame(), after.frame()).flips, 1u);
    EXPECT_EQ(countShadowFlips(after.frame(), before.frame()).flips, 1u);
    EXPECT_EQ(countShadowFlips(after.frame(), after.frame()).flips, 0u) << "what stays wrong does not flip";
}

TEST(ShadowFlipsTest, PixelsWhoseTruthChangesAreNotCompared) {
    const LitPicture before;
    LitPicture after;
    after.reached.at(3, 3)[1] = 0;
    after.truth.at(3, 3).reach = Reach::shadowed;
    const FlipCount count = countShadowFlips(before.frame(), after.frame());
    EXPECT_EQ(count.flips, 0u);
    EXPECT_EQ(count.compared, 6u * 4 - 9) << "nor those beside them, which are at an edge now";
    LitPicture dark; // the whole picture, drawn as it should be
    dark.truth = ShadowImage(8, 6, {.id = 3, .reach = Reach::shadowed});
    dark.reached = image::ImageRgba8(8, 6);
    EXPECT_EQ(countShadowFlips(before.frame(), dark.frame()).compared, 0u);
    LitPicture away;
    away.truth = ShadowImage(8, 6, {.id = 3, .reach = Reach::away});
    EXPECT_EQ(countShadowFlips(away.frame(), away.frame()).compared, 0u);
}

TEST(ShadowFlipsTest, SizesMustAgree) {
    const LitPicture before;
    LitPicture after;
    after.reached = image::ImageRgba8(7, 6);
    EXPECT_THROW(countShadowFlips(before.frame(), after.frame()), base::InputError);
    after = {};
    after.truth = ShadowImage(8, 5);
    EXPECT_THROW(countShadowFlips(before.frame(), after.frame()), base::InputError);
}

} // namespace

} // namespace cdr::measure
