#include "../fixture.h"
#include "../snapping.h"

#include <cdr/depth/forecast.h>
#include <cdr/scene/frustum.h>
#include <scenes/cubes.h>
#include <scenes/mixed.h>

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace cdr::render_test {

namespace {

class SnappingTest : public RenderTest {
  protected:
    render::Frame drawSnapped(const scene::SceneSetup& setup, const char* technique, std::uint32_t bits,
                              std::uint32_t width, std::uint32_t height) {
        render::RenderOptions options = smallOptions(depth::parseTechnique(technique), width, height);
        options.snapBits = bits;
        return draw(setup.scene, setup.path.at(0), options);
    }

    bool isLavapipe() const { return device().info().name.find("llvmpipe") != std::string::npos; }
};

/// What tolerances of other tests rest on.
TEST_F(SnappingTest, TheDeviceMovesSurfacesNoFartherThanItsLimitsSay) {
    const double promised = halfSubPixel(device().info().subPixelBits);
    EXPECT_LE(measureReach(device(), 0), 1.1 * promised);
    if (isLavapipe()) {
        EXPECT_EQ(snapReach(device()), 0.0); // so that no tolerance there is above 0
        EXPECT_TRUE(drawsToTheHorizon(device()));
    }
}

/// What is emulated moves surfaces as far as a device of as few bits may, and nearly as far as that.
TEST_F(SnappingTest, EmulatedBitsMoveSurfacesByHalfASubPixel) {
    for (const std::uint32_t bits : {4u, 6u, 8u}) {
        const double reach = measureReach(device(), bits);
        EXPECT_LE(reach, 1.1 * halfSubPixel(bits) + snapReach(device())) << bits;
        EXPECT_GE(reach, 0.7 * halfSubPixel(bits)) << bits;
    }
}

/// Snapped, anchored depth gets gaps wrong that are far narrower than a sub-pixel of a slanted face, and no others.
TEST_F(SnappingTest, OnlySurfacesCloserThanItsReachSwap) {
    const scene::SceneSetup setup = scenes::makeMixed();
    for (const std::uint32_t bits : {4u, 8u}) {
        measure::WrongPixels wrong; // at some sizes none
        for (const auto& [width, height] : {std::pair{480u, 270u}, {640u, 360u}, {800u, 450u}}) {
            const measure::TruthImage truth = truthOf(setup.scene, setup.path.at(0), width, height);
            const image::ImageU32 ids = drawSnapped(setup, "anchored", bits, width, height).ids();
            wrong += measure::countWrong(ids, truth);
            EXPECT_EQ(wrongBeyond(ids, truth, halfSubPixel(bits) + snapReach(device())), 0u)
                << width << " " << bits;
        }
        EXPECT_GT(wrong.wrong, 0u) << bits;
        EXPECT_LT(wrong.fraction(), 0.05) << bits;
    }
}

constexpr double kPairsView = 1e4;

/// Pairs of boxes that are seen edge on, so that their faces have slope 1. Each pair is a smaller box before a larger one of
/// another outline, whose faces lie `gapView` behind. The larger are drawn last.
scene::Scene pairsOfSlopeOne(double gapView) {
    scene::Scene scene = boxScene();
    const double turn = std::numbers::pi / 4.0;
    const glm::dmat3 edgeOn(std::cos(turn), 0.0, -std::sin(turn), 0.0, 1.0, 0.0, std::sin(turn), 0.0,
                            std::cos(turn));
    for (int i = 0; i < 40; ++i) {
        const double x = 37.0 * (i % 8 - 3.5);
        const double y = 34.0 * (i / 8 - 2.0);
        const double small = 12.0 + 0.137 * i;
        const double large = small * (1.2 + 0.003 * i);
        const double behind = gapView + (large - small) * std::numbers::sqrt2 / 2.0;
        addBox(scene, {x, y, -kPairsView}, glm::mat3(small * edgeOn));
        addBox(scene, {x, y, -kPairsView - behind}, glm::mat3(large * edgeOn));
    }
    return scene;
}

/// The forecast that counts snapping, against a device that snaps: its own bits, or emulated ones.
TEST_F(SnappingTest, TheForecastHoldsForSurfacesOfOtherOutlines) {
    const scene::Camera camera{.fovY = 0.02, .nearView = 1.0, .farView = 1e5};
    const bool snaps = snapReach(device()) > 0.0;
    for (const std::uint32_t bits : snaps ? std::vector{device().info().subPixelBits} : std::vector{4u, 8u}) {
        render::RenderOptions options = smallOptions(depth::parseTechnique("anchored"));
        options.snapBits = snaps ? 0 : bits;
        const depth::Forecast forecast =
            depth::forecast(options.technique,
                            {.nearView = camera.nearView,
                             .farView = camera.farView,
                             .footprintSlope = scene::frustumOf(camera, 1.0, options.height).footprintSlope,
                             .atView = kPairsView,
                             .spanView = 40.0,
                             .somethingNear = false,
                             .subPixelBits = bits});
        const auto wrongAt = [&](double gapView) {
            const scene::Scene scene = pairsOfSlopeOne(gapView);
            return wrongIn(draw(scene, camera, options), scene, camera);
        };
        const measure::WrongPixels guaranteed = wrongAt(forecast.guaranteedView());
        EXPECT_GT(guaranteed.overlapPixels, 10'000u);
        EXPECT_EQ(guaranteed.wrong, 0u) << bits;
        EXPECT_LT(wrongAt(forecast.resolvedView()).overlapFraction(), 0.01) << bits;
        EXPECT_GT(wrongAt(0.1 * forecast.resolvedView()).overlapFraction(), 0.05) << bits;
    }
}

/// Where surfaces lie farther apart than a sub-pixel reaches, snapping takes nothing from anchored depth.
TEST_F(SnappingTest, FieldsOfCubesStayRight) {
    for (const scene::SceneSetup& setup : {scenes::makeAfc(2013), scenes::makeCubes(2013)}) {
        const measure::TruthImage truth = truthOf(setup.scene, setup.path.at(0));
        for (const std::uint32_t bits : {4u, 8u}) {
            const image::ImageU32 ids = drawSnapped(setup, "anchored", bits, 480, 270).ids();
            const measure::WrongPixels wrong = measure::countWrong(ids, truth);
            EXPECT_GT(wrong.pixels, 15'000u);
            EXPECT_EQ(wrong.wrong, 0u) << setup.scene.name << " " << bits;
        }
    }
}

} // namespace

} // namespace cdr::render_test
