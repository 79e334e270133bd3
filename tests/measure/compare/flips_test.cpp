#include <cdr/base/error.h>
#include <cdr/measure/compare/flips.h>
#include <cdr/measure/compare/wrong_pixels.h>

#include <gtest/gtest.h>

#include <vector>

namespace cdr::test {

namespace {

using measure::FlipCount;
using measure::IdFrame;

/// A frame of 5x5 pixels whose truth is one object, so that the middle nine are inner.
IdFrame frameOf(std::uint32_t trueId) {
    IdFrame frame{.ids = {5, 5, trueId}, .truth = {5, 5}};
    for (measure::TruthPixel& pixel : frame.truth.pixels) {
        pixel.id = trueId;
    }
    return frame;
}

IdFrame drawing(IdFrame frame, std::uint32_t x, std::uint32_t y, std::uint32_t id) {
    frame.ids.at(x, y) = id;
    return frame;
}

FlipCount sum(const std::vector<IdFrame>& frames) {
    FlipCount count;
    for (std::size_t i = 1; i < frames.size(); ++i) {
        count += measure::countFlips(frames[i - 1], frames[i]);
    }
    return count;
}

} // namespace

TEST(Flips, ASequenceThatIsRightDoesNotFlicker) {
    EXPECT_EQ(sum({frameOf(7), frameOf(7), frameOf(7)}), (FlipCount{.flips = 0, .compared = 18}));
}

TEST(Flips, AWrongPixelThatStaysPutDoesNotFlip) {
    const IdFrame wrong = drawing(frameOf(7), 2, 2, 9);
    EXPECT_EQ(sum({wrong, wrong, wrong}), (FlipCount{.flips = 0, .compared = 18}));
}

TEST(Flips, APixelThatComesAndGoesFlipsEachTime) {
    const IdFrame right = frameOf(7);
    const IdFrame wrong = drawing(right, 2, 2, 9);
    EXPECT_EQ(sum({right, wrong, right, wrong}), (FlipCount{.flips = 3, .compared = 27}));
}

TEST(Flips, FromOneWrongObjectToAnotherIsAFlip) {
    const FlipCount count = sum({drawing(frameOf(7), 1, 3, 8), drawing(frameOf(7), 1, 3, 9)});
    EXPECT_EQ(count, (FlipCount{.flips = 1, .compared = 9}));
    EXPECT_NEAR(count.perThousand().value(), 1000.0 / 9.0, 1e-12);
}

TEST(Flips, EdgesDoNotCount) {
    EXPECT_EQ(sum({frameOf(7), drawing(frameOf(7), 0, 2, 9)}), (FlipCount{.flips = 0, .compared = 9}));
}

/// The truth moves on, and what is drawn with it: no flicker, and nothing to compare.
TEST(Flips, WhereTheTruthChangesNothingIsCompared) {
    const FlipCount count = sum({frameOf(7), frameOf(8)});
    EXPECT_EQ(count, (FlipCount{.flips = 0, .compared = 0}));
    EXPECT_EQ(count.perThousand(), std::nullopt);
}

TEST(Flips, BackgroundIsNeverInner) {
    EXPECT_EQ(sum({frameOf(0), drawing(frameOf(0), 2, 2, 3)}), (FlipCount{.flips = 0, .compared = 0}));
}

/// Inner in both frames, not in one: a second object covers the right column in the second frame.
TEST(Flips, APixelMustBeInnerInBothFrames) {
    IdFrame second = frameOf(7);
    for (std::uint32_t y = 0; y < 5; ++y) {
        second.truth.at(4, y).id = 9;
        second.ids.at(4, y) = 9;
    }
    EXPECT_EQ(sum({frameOf(7), second}), (FlipCount{.flips = 0, .compared = 6}));
    EXPECT_EQ(sum({second, frameOf(7)}), (FlipCount{.flips = 0, .compared = 6}));
}

TEST(Flips, RefusesFramesOfDifferentSizes) {
    IdFrame other{.ids = {4, 5}, .truth = {4, 5}};
    EXPECT_THROW(measure::countFlips(frameOf(1), other), base::InputError);
    EXPECT_THROW(measure::countFlips(frameOf(1).ids, frameOf(1).ids, {4, 5}), base::InputError);
}

} // namespace cdr::test
