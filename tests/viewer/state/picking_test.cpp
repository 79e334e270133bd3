#include "cameras.h"
#include "frames.h"

#include <viewer/state/picking.h>

#include <limits>

namespace cdr::viewer {

namespace {

using namespace viewer_test;

/// Object 4, 12 view units beyond the far cascade's anchor, except for background in the top row.
render::Frame frameWithObject() {
    render::Frame frame = makeFrame(64, 36, [](auto, auto y) {
        return y == 0 ? MadePixel{} : MadePixel{.id = 5, .cascade = 1, .ahead = 12.0f};
    });
    frame.camera = cameraWith(1.0, {1e8, 0.0, 0.0}, {1e8, 0.0, -1.0});
    return frame;
}

const depth::Technique kTechnique = depth::parseTechnique("anchored");

TEST(Pick, NamesPlacesAndMeasures) {
    scene::Scene scene;
    const render::Frame frame = frameWithObject();
    const auto point = pickAt(frame, scene, kTechnique, 40, 20);
    ASSERT_TRUE(point);
    EXPECT_EQ(point->object, 4u);
    EXPECT_EQ(point->name, "object 4");
    EXPECT_EQ(point->distanceView, 1012.0);
    const glm::dvec2 pixel = pixelOf(frame.camera, point->position, {64, 36});
    EXPECT_NEAR(pixel.x, 40.5, 1e-6);
    EXPECT_NEAR(pixel.y, 20.5, 1e-6);
    EXPECT_NEAR(point->footprint, 1012.0 * 2.0 * std::tan(scene::radiansOf(0.5)) / 36.0, 1e-9);
    EXPECT_GT(point->stepView, 0.0);
    EXPECT_LT(point->stepView, 1e-2);
    scene.objectNames = {"a", "b", "c", "d", "runway"};
    EXPECT_EQ(pickAt(frame, scene, kTechnique, 40, 20)->name, "runway");
    scene.objectNames.back().clear();
    EXPECT_EQ(pickAt(frame, scene, kTechnique, 40, 20)->name, "object 4");
    EXPECT_EQ(describe(*point, base::LengthUnit::automatic).find("object 4, 1.012"), 0u);
}

/// Along the view axis it is half as far.
TEST(Pick, IsAsFarAwayAsItIsAtTheSideOfAWideLens) {
    render::Frame frame = frameWithObject();
    frame.camera = cameraWith(90.0, {1e8, 0.0, 0.0}, {1e8, 0.0, -1.0});
    const auto point = pickAt(frame, {}, kTechnique, 63, 18);
    ASSERT_TRUE(point);
    EXPECT_EQ(point->distanceView, 1012.0);
    // Half a height is 18 pixels, and as far ahead as to the side.
    EXPECT_NEAR(point->distance, 1012.0 * std::hypot(1.0, 31.5 / 18.0, 0.5 / 18.0), 1e-6);
    EXPECT_EQ(describe(*point, base::LengthUnit::automatic).find("object 4, 2.04\u00a0km away, "), 0u);
}

TEST(Pick, NothingAtBackgroundAndOutside) {
    const render::Frame frame = frameWithObject();
    EXPECT_FALSE(pickAt(frame, {}, kTechnique, 3, 0));
    EXPECT_FALSE(pickAt(frame, {}, kTechnique, 64, 1));
    EXPECT_FALSE(pickAt(frame, {}, kTechnique, 0, 36));
    EXPECT_FALSE(pickAt({}, {}, kTechnique, 0, 0));
}

TEST(SurfaceView, TakesThePixelElseTheNearest) {
    const render::Frame frame = makeFrame(320, 200, [](auto x, auto y) {
        if (x < 160) {
            return MadePixel{};
        }
        return MadePixel{.id = 1, .cascade = 0, .ahead = y < 100 ? 50.0f : 20.0f};
    });
    EXPECT_EQ(surfaceView(frame, {200.5, 10.0}), 51.0);
    EXPECT_EQ(surfaceView(frame, {10.0, 10.0}), 21.0);
    EXPECT_EQ(surfaceView(frame, {-5.0, 1e9}), 21.0);
    EXPECT_EQ(surfaceView(frame, {std::nan(""), 3.0}), 21.0);
    const render::Frame empty = makeFrame(5, 5, [](auto, auto) { return MadePixel{}; });
    EXPECT_EQ(surfaceView(empty, {2.0, 2.0}), std::numeric_limits<double>::infinity());
    EXPECT_EQ(surfaceView({}, {0.0, 0.0}), std::numeric_limits<double>::infinity());
    const render::Frame tiny = makeFrame(1, 1, [](auto, auto) { return MadePixel{.id = 1, .ahead = 3.0f}; });
    EXPECT_EQ(surfaceView(tiny, {7.0, 7.0}), 4.0);
}

TEST(SurfaceView, FindsWhatCoversOnePixel) {
    const render::Frame frame = makeFrame(320, 200, [](auto x, auto y) {
        return x == 7 && y == 3 ? MadePixel{.id = 1, .ahead = 50.0f} : MadePixel{};
    });
    EXPECT_EQ(surfaceView(frame, {200.5, 10.0}), 51.0);
}

PickedPoint pointAt(const glm::dvec3& position, double distanceView) {
    return {.object = 0,
            .name = "x",
            .position = position,
            .normal = glm::dvec3(0.0),
            .distance = distanceView,
            .distanceView = distanceView,
            .stepView = 3e-6,
            .footprint = 8e-3};
}

TEST(Measuring, TwoClicksMeasureAndTheThirdBeginsAnew) {
    Measuring measuring;
    EXPECT_FALSE(measuring.span());
    const PickedPoint first = pointAt({1e8, 5.0, 0.0}, 1e6);
    const PickedPoint second = pointAt({1e8, 5.0, -0.005}, 1e6 + 0.004);
    measuring.click(first);
    EXPECT_FALSE(measuring.span());
    measuring.click(second);
    const auto span = measuring.span();
    ASSERT_TRUE(span);
    EXPECT_EQ(span->vector, glm::dvec3(0.0, 0.0, -0.005));
    EXPECT_EQ(span->length, 0.005);
    EXPECT_NEAR(span->alongView, 0.004, 1e-9);
    EXPECT_NEAR(span->uncertainty, std::sqrt(2.0 * 16e-6 + 2.0 * 9e-12), 1e-12);
    EXPECT_EQ(describe(*span, base::LengthUnit::automatic)
                  .find("5\u00a0mm, 4\u00a0mm of it along the view, to within 5."),
              0u);
    Span lost = *span;
    lost.uncertainty = INFINITY;
    EXPECT_NE(describe(lost, base::LengthUnit::automatic).find("view, where nothing is told apart"),
              std::string::npos);
    measuring.click(first);
    EXPECT_FALSE(measuring.span());
    EXPECT_TRUE(measuring.first());
    measuring.click(second);
    measuring.clear();
    EXPECT_FALSE(measuring.first());
    measuring.click(second);
    EXPECT_FALSE(measuring.span());
}

} // namespace

} // namespace cdr::viewer
