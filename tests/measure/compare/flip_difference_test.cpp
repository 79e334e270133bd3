#include <cdr/base/error.h>
#include <cdr/measure/compare/flip_difference.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace cdr::test {

namespace {

using image::ImageRgba8;
using image::Rgba8;
using measure::FlipDifference;

// The pictures of flip_reference.py.

ImageRgba8 ramp(std::uint32_t width, std::uint32_t height) {
    ImageRgba8 picture(width, height);
    for (std::uint32_t y = 0; y < height; ++y) {
        for (std::uint32_t x = 0; x < width; ++x) {
            picture.at(x, y) = {static_cast<std::uint8_t>(5 * x), static_cast<std::uint8_t>(3 * x + 6 * y),
                                static_cast<std::uint8_t>(255 - 4 * y), 255};
        }
    }
    return picture;
}

struct Box {
    std::uint32_t left, top, right, bottom;
};

ImageRgba8 withBox(ImageRgba8 picture, const Box& box, const Rgba8& color) {
    for (std::uint32_t y = box.top; y < box.bottom; ++y) {
        for (std::uint32_t x = box.left; x < box.right; ++x) {
            picture.at(x, y) = color;
        }
    }
    return picture;
}

ImageRgba8 flat(std::uint32_t width, std::uint32_t height, std::uint8_t grey) {
    return {width, height, Rgba8{grey, grey, grey, 255}};
}

ImageRgba8 noise(std::uint32_t width, std::uint32_t height, unsigned step) {
    ImageRgba8 picture(width, height);
    std::uint32_t state = 1;
    for (Rgba8& pixel : picture.pixels) {
        state = 1664525u * state + 1013904223u;
        const auto value = static_cast<std::uint8_t>(128 + (state >= 0x80000000u ? step : 0));
        pixel = {value, value, value, 255};
    }
    return picture;
}

struct Figures {
    double mean;
    double corner;
    double middle;
};

/// Against what flip_reference.py printed, float64 and two-dimensional filters throughout.
void expectFigures(const ImageRgba8& reference, const ImageRgba8& test, const Figures& expected,
                   const measure::Viewing& viewing = {}) {
    platform::WorkerPool workers(2);
    const FlipDifference flip(viewing);
    const image::ImageFloat map = flip.map(reference, test, workers);
    EXPECT_NEAR(flip.mean(reference, test, workers), expected.mean, 1e-5);
    EXPECT_NEAR(static_cast<double>(map.at(0, 0)), expected.corner, 1e-5);
    EXPECT_NEAR(static_cast<double>(map.at(map.width / 2, map.height / 2)), expected.middle, 1e-5);
}

constexpr Rgba8 kRedBox{250, 30, 60, 255};

} // namespace

TEST(FlipDifference, ABoxInARampIsAsTheReferenceHasIt) {
    const ImageRgba8 reference = ramp(70, 40);
    const ImageRgba8 test = withBox(reference, {20, 10, 40, 25}, kRedBox);
    expectFigures(reference, test, {0.1394393, 0.0, 0.9712360});
    expectFigures(reference, test, {0.1188640, 0.0, 0.9755857}, {.pixelsPerDegree = 30.0});
}

TEST(FlipDifference, FlatColorsAreAsTheReferenceHasThem) {
    expectFigures(flat(24, 20, 100), flat(24, 20, 110), {0.1534606, 0.1534606, 0.1534606});
    expectFigures(flat(24, 20, 0), flat(24, 20, 255), {0.9673798, 0.9673798, 0.9673798});
    expectFigures({24, 20, Rgba8{0, 255, 0, 255}}, {24, 20, Rgba8{0, 0, 255, 255}}, {1.0, 1.0, 1.0});
}

TEST(FlipDifference, FeaturesThatVanishAreAsTheReferenceHasThem) {
    expectFigures(noise(48, 32, 40), flat(48, 32, 128), {0.3155325, 0.2927026, 0.2755879});
    expectFigures(flat(30, 30, 128), withBox(flat(30, 30, 128), {15, 15, 16, 16}, {129, 129, 129, 255}),
                  {0.0000896, 0.0, 0.0083916});
}

TEST(FlipDifference, EqualPicturesDoNotDiffer) {
    platform::WorkerPool workers(1);
    const FlipDifference flip;
    EXPECT_EQ(flip.mean(ramp(100, 90), ramp(100, 90), workers), 0.0);
    EXPECT_EQ(flip.mean({}, {}, workers), 0.0);
}

/// The division into tiles changes no difference, wherever it lies.
TEST(FlipDifference, ADifferenceLooksTheSameWhereverItLies) {
    platform::WorkerPool workers(2);
    const FlipDifference flip;
    const ImageRgba8 reference = flat(200, 150, 90);
    const auto mapOf = [&](std::uint32_t x, std::uint32_t y) {
        return flip.map(reference, withBox(reference, {x, y, x + 3, y + 2}, kRedBox), workers);
    };
    const std::uint32_t reach = flip.reach();
    const image::ImageFloat first = mapOf(30, 30);
    EXPECT_GT(*std::max_element(first.pixels.begin(), first.pixels.end()), 0.1f);
    for (const auto& [x, y] : {std::pair{62u, 63u}, std::pair{64u, 30u}, std::pair{127u, 128u - reach}}) {
        const image::ImageFloat moved = mapOf(x, y);
        for (std::uint32_t j = 0; j < 2 * reach + 4; ++j) {
            for (std::uint32_t i = 0; i < 2 * reach + 4; ++i) {
                ASSERT_EQ(moved.at(x - reach + i, y - reach + j), first.at(30 - reach + i, 30 - reach + j))
                    << i << ' ' << j;
            }
        }
    }
}

TEST(FlipDifference, WorkersDoNotChangeTheBits) {
    platform::WorkerPool one(1);
    platform::WorkerPool three(3);
    const FlipDifference flip;
    EXPECT_EQ(flip.map(ramp(300, 200), flat(300, 200, 128), one),
              flip.map(ramp(300, 200), flat(300, 200, 128), three));
}

TEST(FlipDifference, RefusesWhatCannotBeCompared) {
    platform::WorkerPool workers(1);
    EXPECT_THROW(FlipDifference().map(flat(4, 4, 0), flat(4, 5, 0), workers), base::InputError);
    EXPECT_THROW(FlipDifference({.pixelsPerDegree = 0.5}), base::InputError);
    EXPECT_THROW(FlipDifference({.pixelsPerDegree = 1e9}), base::InputError);
}

} // namespace cdr::test
