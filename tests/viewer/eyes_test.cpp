#include "viewer_run.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace cdr::viewer_test {

namespace {

const std::string kEyes = "--size 560x300 --technique anchored alley";

/// One eye, two side by side, an anaglyph, one eye: by the key, and by the panel.
TEST_F(ViewerTest, ShowsTwoEyes) {
    const RunResult run =
        play("--size 560x300 --technique anchored alley",
             "wait-frame\npicture one.png\nkey G\nwait-frame\nstate\npicture beside.png\nkey G shift\n"
             "wait-frame\nstate\nkey G\nwait-frame\nstate\npicture both.png\nkey G\nwait-frame\n"
             "picture again.png\nstate\nclick eyes\nclick eyes=side-by-side\nwait-frame\nstate\nquit\n");
    const auto states = run.states(5);
    EXPECT_EQ(valueOf(states[0], "eyes"), "side-by-side");
    EXPECT_EQ(valueOf(states[0], "stereo"), "parallel");
    EXPECT_EQ(valueOf(states[1], "stereo"), "toed-in");
    EXPECT_EQ(valueOf(states[2], "eyes"), "anaglyph");
    EXPECT_EQ(valueOf(states[3], "eyes"), "");
    EXPECT_EQ(valueOf(states[4], "eyes"), "side-by-side");
    EXPECT_NEAR(std::stod(valueOf(states[0], "meet")) / std::stod(valueOf(states[0], "apart")), 30.0, 0.5);
    const image::ImageRgba8 one = picture("one.png");
    const image::ImageRgba8 beside = picture("beside.png");
    EXPECT_EQ(beside.width, one.width / 2 * 2);
    image::ImageRgba8 left(one.width / 2, one.height);
    image::ImageRgba8 right(one.width / 2, one.height);
    for (std::uint32_t y = 0; y < one.height; ++y) {
        for (std::uint32_t x = 0; x < left.width; ++x) {
            left.at(x, y) = beside.at(x, y);
            right.at(x, y) = beside.at(left.width + x, y);
        }
    }
    EXPECT_GT(difference(left, right), 0.001);
    EXPECT_GT(colors(left), 50u);
    EXPECT_GT(difference(picture("both.png"), one), 0.001);
    EXPECT_EQ(picture("again.png"), one);
}

/// One eye between them does not make the viewer forget what was asked for.
TEST_F(ViewerTest, KeepsTheEyesOfTheCommandLine) {
    const RunResult run =
        play("--stereo parallel --eye-distance 0.3 --converge 9 " + kEyes,
             "wait-frame\nkey G\nkey G\nwait-frame\nstate\nkey G\nwait-frame\nstate\nquit\n");
    const auto states = run.states(2);
    EXPECT_EQ(valueOf(states[0], "eyes"), "");
    EXPECT_EQ(valueOf(states[1], "eyes"), "side-by-side");
    EXPECT_EQ(valueOf(states[1], "apart"), "0.3");
    EXPECT_EQ(valueOf(states[1], "meet"), "9");
}

/// What is under the cursor is what the eye sees there whose picture it is in.
TEST_F(ViewerTest, PicksInEachEye) {
    const auto clickAt = [](int x) {
        return "move " + std::to_string(x) +
               " 250\nwait-frame\nwait-ui 5\npress\nrelease\n"
               "wait-state picked=\nstate\nkey X\nwait-ui 1\n";
    };
    constexpr int kHalf = 212 / 2; // the columns of one eye
    const std::string otherEyes = "key G\nwait-frame\n";
    const RunResult run = play("--stereo parallel --eye-distance 1e-6 --stereo-picture anaglyph " + kEyes,
                               "wait-frame\n" + clickAt(90) + otherEyes + clickAt(90) + otherEyes +
                                   clickAt(20) + clickAt(kHalf + 20) + clickAt(kHalf + 51) + "quit\n");
    const auto states = run.states(5);
    EXPECT_EQ(valueOf(states[0], "eyes"), "anaglyph");
    EXPECT_EQ(valueOf(states[1], "eyes"), "");
    EXPECT_EQ(valueOf(states[2], "eyes"), "side-by-side");
    const auto placeOf = [&](std::size_t click) { return valueOf(states[click], "picked-at"); };
    const auto close = [](const std::string& a, const std::string& b) {
        double ax = 0.0, ay = 0.0, az = 0.0, bx = 0.0, by = 0.0, bz = 0.0;
        EXPECT_EQ(std::sscanf(a.c_str(), "%lf,%lf,%lf", &ax, &ay, &az), 3) << a;
        EXPECT_EQ(std::sscanf(b.c_str(), "%lf,%lf,%lf", &bx, &by, &bz), 3) << b;
        return std::abs(ax - bx) + std::abs(ay - by) + std::abs(az - bz) < 1e-3;
    };
    EXPECT_TRUE(close(placeOf(2), placeOf(3)));
    EXPECT_FALSE(close(placeOf(2), placeOf(4)));
    // An anaglyph is picked through the left eye, which here stands where one eye would.
    EXPECT_TRUE(close(placeOf(0), placeOf(1)));
}

} // namespace

} // namespace cdr::viewer_test
