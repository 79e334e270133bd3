#include "frames.h"

#include <cdr/base/error.h>
#include <cdr/measure/compare/wrong_pixels.h>
#include <viewer/state/split_picture.h>
#include <viewer/state/view_picture.h>
#include <viewer/state/wrong_view.h>

#include <gtest/gtest.h>
#include <output/aov.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

namespace cdr::viewer {

namespace {

using namespace viewer_test;

/// Boxes of ids in two cascades over background, distances over four decades.
render::Frame boxes() {
    return makeFrame(97, 61, [](auto x, auto y) -> MadePixel {
        const std::uint32_t id = (x / 9) * 8 + y / 8;
        if (id % 5 == 0) {
            return {};
        }
        return {.id = id, .cascade = id % 2, .ahead = static_cast<float>(0.3 * (x + 1) * (y + 1))};
    });
}

image::ImageRgba8 painted(const render::Frame& frame, ViewKind view) {
    image::ImageRgba8 picture;
    paintView(frame, view, picture);
    return picture;
}

TEST(PaintView, ShadedAndCascadesAreTheExperimentsPictures) {
    const render::Frame frame = boxes();
    EXPECT_EQ(painted(frame, ViewKind::shaded), frame.color);
    EXPECT_EQ(painted(frame, ViewKind::cascades), output::pictureOf(frame, output::Aov::cascade, nullptr));
    EXPECT_EQ(cascadeColor(0), output::cascadeTint(0, 255));
}

/// Of all pixels, the largest difference to the experiments' picture, which takes its time over logarithms.
int distanceError(const render::Frame& frame) {
    const image::ImageRgba8 exact = output::pictureOf(frame, output::Aov::distance, nullptr);
    const image::ImageRgba8 quick = painted(frame, ViewKind::distance);
    int largest = 0;
    for (std::size_t i = 0; i < exact.pixels.size(); ++i) {
        largest = std::max(largest, std::abs(int{exact.pixels[i][0]} - int{quick.pixels[i][0]}));
        EXPECT_EQ(quick.pixels[i][3], 255);
    }
    return largest;
}

TEST(PaintView, DistancesAreTheExperimentsToAGrey) {
    EXPECT_LE(distanceError(boxes()), 1);
    // Thin content far away, where 1 + x rounds.
    render::Frame thin = boxes();
    thin.anchorsView = {1e6, 1e6 + 3.0};
    EXPECT_LE(distanceError(thin), 1);
    for (render::GBufferPixel& pixel : thin.gbuffer.pixels) {
        pixel.ahead *= 1e-3f;
    }
    EXPECT_LE(distanceError(thin), 1);
    thin.anchorsView = {1e-3, 1e12};
    EXPECT_LE(distanceError(thin), 1);
}

TEST(PaintView, OneDistanceAndNoneAreSound) {
    const render::Frame flat = makeFrame(8, 8, [](auto, auto) { return MadePixel{.id = 1, .ahead = 2.0f}; });
    EXPECT_EQ(painted(flat, ViewKind::distance).pixels.front(), (image::Rgba8{255, 255, 255, 255}));
    const render::Frame empty = makeFrame(8, 8, [](auto, auto) { return MadePixel{}; });
    for (const ViewKind view : {ViewKind::distance, ViewKind::ids, ViewKind::cascades}) {
        EXPECT_EQ(painted(empty, view).pixels.front(), (image::Rgba8{0, 0, 0, 255}));
    }
}

TEST(PaintView, IdsHaveColoursOfTheirOwn) {
    std::set<image::Rgba8> colors;
    for (std::uint32_t id = 1; id <= 20'000; ++id) {
        const image::Rgba8 color = idColor(id);
        colors.insert(color);
        EXPECT_GE(std::min({color[0], color[1], color[2]}), 48);
    }
    EXPECT_GT(colors.size(), 19'900u);
    EXPECT_EQ(idColor(0), (image::Rgba8{0, 0, 0, 255}));
    const render::Frame frame = boxes();
    const image::ImageRgba8 picture = painted(frame, ViewKind::ids);
    EXPECT_EQ(picture.at(20, 30), idColor(frame.id(20, 30)));
}

TEST(PaintView, ReusesAPictureOfTheSizeAndRefusesComparisons) {
    const render::Frame frame = boxes();
    image::ImageRgba8 picture(97, 61, {9, 9, 9, 9});
    const image::Rgba8* const memory = picture.pixels.data();
    for (const ViewKind view : {ViewKind::shaded, ViewKind::cascades, ViewKind::distance, ViewKind::ids}) {
        paintView(frame, view, picture);
        EXPECT_EQ(picture.pixels.data(), memory);
    }
    EXPECT_THROW(paintView(frame, ViewKind::wrong, picture), base::InputError);
    EXPECT_THROW(paintView(frame, ViewKind::flips, picture), base::InputError);
}

/// The truth that a frame's ids would be.
measure::TruthImage truthOf(const render::Frame& frame) {
    measure::TruthImage truth(frame.width(), frame.height());
    for (std::uint32_t y = 0; y < frame.height(); ++y) {
        for (std::uint32_t x = 0; x < frame.width(); ++x) {
            truth.at(x, y).id = frame.id(x, y);
        }
    }
    return truth;
}

TEST(PaintWrong, IsTheHeatMapWithTheAnswerAsTruth) {
    const render::Frame reference = boxes();
    render::Frame frame = reference;
    std::mt19937 random(5);
    for (render::GBufferPixel& pixel : frame.gbuffer.pixels) {
        if (random() % 7 == 0) {
            pixel.idAndCascade ^= 1u;
        }
    }
    const measure::TruthImage truth = truthOf(reference);
    image::ImageRgba8 picture;
    const WrongCount count = paintWrong(frame, reference, picture);
    EXPECT_EQ(picture, measure::heatMap(frame.ids(), truth, frame.color));
    const measure::WrongPixels expected = measure::countWrong(frame.ids(), truth);
    EXPECT_GT(expected.wrong, 50u);
    EXPECT_GT(expected.edgeWrong, 50u);
    EXPECT_EQ(count.inner, expected.pixels);
    EXPECT_EQ(count.wrong, expected.wrong);
    EXPECT_EQ(count.edgeWrong, expected.edgeWrong);
    EXPECT_DOUBLE_EQ(count.share().value(), expected.fraction().value());
    EXPECT_EQ(countWrong(frame, reference).wrong, expected.wrong);
}

TEST(WrongText, SaysWhyNothingCanBeWrong) {
    EXPECT_EQ(wrongText({}), "");
    EXPECT_EQ(wrongText({{.objects = 0}}), "");
    EXPECT_EQ(wrongText({{.inner = 9, .objects = 1}}), "one object in view: no wrong pixels to count");
    EXPECT_EQ(wrongText({{.inner = 1000, .wrong = 230, .objects = 2}, {.inner = 1000, .objects = 2}}),
              "wrong\u00a023\u00a0%\u00a0|\u00a00\u00a0%");
    EXPECT_EQ(wrongText({{.objects = 2}, {.inner = 1000, .objects = 2}}),
              "wrong\u00a0-\u00a0|\u00a00\u00a0%");
    EXPECT_EQ(shareText(1.0), "100\u00a0%");
    EXPECT_EQ(shareText(1e-6), "0.0001\u00a0%");
}

TEST(PaintWrong, FindsNothingInTheAnswerItself) {
    const render::Frame frame = boxes();
    image::ImageRgba8 picture;
    const WrongCount count = paintWrong(frame, frame, picture);
    EXPECT_EQ(count.wrong + count.edgeWrong, 0u);
    EXPECT_GT(count.inner, 1000u);
    EXPECT_EQ(count.objects, 2u);
    EXPECT_EQ(wrongText({count, count}), "wrong\u00a00\u00a0%\u00a0|\u00a00\u00a0%");
    EXPECT_THROW(paintWrong(frame, makeFrame(4, 4, [](auto, auto) { return MadePixel{}; }), picture),
                 base::InputError);
}

TEST(ComposeSplit, ShowsEachSideItsOwnAndALineBetween) {
    const image::ImageRgba8 left(10, 3, {1, 1, 1, 255});
    const image::ImageRgba8 right(10, 3, {2, 2, 2, 255});
    image::ImageRgba8 picture;
    composeSplit(left, right, 0.4, picture);
    for (std::uint32_t y = 0; y < 3; ++y) {
        for (std::uint32_t x = 0; x < 10; ++x) {
            const int expected = x < 3 ? 1 : x < 5 ? 235 : 2;
            EXPECT_EQ(picture.at(x, y)[0], expected) << x;
        }
    }
    composeSplit(left, right, 0.0, picture);
    EXPECT_EQ(picture, right);
    composeSplit(left, right, 7.0, picture);
    EXPECT_EQ(picture, left);
    EXPECT_EQ(dividerColumn(std::nan(""), 10), 0u);
    EXPECT_EQ(dividerColumn(-3.0, 10), 0u);
    EXPECT_EQ(dividerColumn(0.5, 1), 1u);
    EXPECT_THROW(composeSplit(left, image::ImageRgba8(3, 3), 0.5, picture), base::InputError);
    const image::ImageRgba8 none;
    composeSplit(none, none, 0.5, picture);
    EXPECT_TRUE(picture.pixels.empty());
}

} // namespace

} // namespace cdr::viewer
