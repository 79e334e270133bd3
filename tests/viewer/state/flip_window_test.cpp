#include "frames.h"

#include <cdr/base/error.h>
#include <cdr/measure/compare/flips.h>
#include <viewer/state/flip_window.h>

#include <gtest/gtest.h>

#include <random>

namespace cdr::viewer {

namespace {

using namespace viewer_test;

constexpr std::uint32_t kWidth = 60;
constexpr std::uint32_t kHeight = 40;

/// Wide boxes of ids; the answer of a camera that has moved by so many pixels.
render::Frame answerAt(std::uint32_t moved) {
    return makeFrame(kWidth, kHeight, [=](auto x, auto y) -> MadePixel {
        return {.id = 1 + ((x + moved) / 12) * 4 + y / 11, .cascade = 0, .ahead = 1.0f};
    });
}

/// An answer with some pixels wrong.
render::Frame withWrong(render::Frame frame, unsigned seed) {
    std::mt19937 random(seed);
    for (render::GBufferPixel& pixel : frame.gbuffer.pixels) {
        pixel.idAndCascade += random() % 6 == 0 ? 100 : 0;
    }
    return frame;
}

measure::IdFrame idFrame(const render::Frame& shown, const render::Frame& answer) {
    measure::IdFrame frame{.ids = shown.ids(), .truth = measure::TruthImage(kWidth, kHeight)};
    for (std::uint32_t y = 0; y < kHeight; ++y) {
        for (std::uint32_t x = 0; x < kWidth; ++x) {
            frame.truth.at(x, y).id = answer.id(x, y);
        }
    }
    return frame;
}

TEST(FlipWindow, CountsAsTheExperimentDoes) {
    FlipWindow window;
    render::Frame before;
    for (unsigned i = 0; i < 12; ++i) {
        const render::Frame answer = answerAt(i / 2);
        const render::Frame shown = withWrong(answer, i);
        window.add(shown, answer, 0.1 * i);
        if (i > 0) {
            const render::Frame answerBefore = answerAt((i - 1) / 2);
            const measure::FlipCount count =
                measure::countFlips(idFrame(before, answerBefore), idFrame(shown, answer));
            EXPECT_GT(count.flips, 20u);
            EXPECT_EQ(window.flipsNow(), count.flips) << i;
        }
        before = shown;
    }
}

TEST(FlipWindow, WrongPixelsThatStayPutAndMovingAnswersDoNotFlip) {
    FlipWindow window;
    const render::Frame wrong = withWrong(answerAt(0), 3);
    window.add(wrong, answerAt(0), 0.0);
    window.add(wrong, answerAt(0), 0.1);
    EXPECT_EQ(window.flipsNow(), 0u);
    FlipWindow moving;
    for (std::uint32_t i = 0; i < 10; ++i) {
        moving.add(answerAt(i), answerAt(i), 0.1 * i);
        EXPECT_EQ(moving.flipsNow(), 0u);
    }
    EXPECT_EQ(moving.pixelsInWindow(), 0u);
}

TEST(FlipWindow, FadesOverASecond) {
    FlipWindow window;
    const render::Frame answer = answerAt(0);
    render::Frame shown = answer;
    window.add(shown, answer, 100.0);
    shown.gbuffer.at(5, 5).idAndCascade += 100; // off edges
    window.add(shown, answer, 100.1);
    EXPECT_EQ(window.flipsNow(), 1u);
    image::ImageRgba8 picture;
    window.paint(shown, picture);
    EXPECT_EQ(picture.at(5, 5), (image::Rgba8{255, 0, 0, 255}));
    EXPECT_EQ(picture.at(6, 5)[0], picture.at(6, 5)[1]); // grey
    int last = 256;
    for (int i = 1; i < 10; ++i) {
        window.add(shown, answer, 100.1 + 0.1 * i);
        EXPECT_EQ(window.flipsNow(), 0u);
        EXPECT_EQ(window.pixelsInWindow(), 1u);
        window.paint(shown, picture);
        const image::Rgba8 color = picture.at(5, 5);
        EXPECT_LT(color[0], last);
        EXPECT_GT(color[0], color[1]);
        last = color[0];
    }
    window.add(shown, answer, 101.2);
    EXPECT_EQ(window.pixelsInWindow(), 0u);
    window.paint(shown, picture);
    EXPECT_EQ(picture.at(5, 5)[0], picture.at(5, 5)[1]);
}

TEST(FlipWindow, BeginsAnewWithAnotherSizeAndWhenCleared) {
    FlipWindow window;
    window.add(withWrong(answerAt(0), 1), answerAt(0), 0.0);
    window.add(withWrong(answerAt(0), 2), answerAt(0), 0.1);
    EXPECT_GT(window.pixelsInWindow(), 0u);
    const auto small = [](std::uint32_t id) {
        return makeFrame(7, 5, [id](auto, auto) { return MadePixel{.id = id}; });
    };
    window.add(small(2), small(1), 0.2);
    EXPECT_EQ(window.pixelsInWindow(), 0u);
    window.add(small(3), small(1), 0.3);
    EXPECT_EQ(window.flipsNow(), 15u); // 5x3 inner pixels
    window.clear();
    window.add(small(2), small(1), 0.4);
    EXPECT_EQ(window.flipsNow(), 0u);
    image::ImageRgba8 picture;
    EXPECT_THROW(window.add(small(1), answerAt(0), 0.5), base::InputError);
    EXPECT_THROW(window.paint(answerAt(0), picture), base::InputError);
    EXPECT_THROW(FlipWindow().paint(answerAt(0), picture), base::InputError);
}

} // namespace

} // namespace cdr::viewer
