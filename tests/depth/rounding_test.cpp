#include <cdr/base/error.h>
#include <cdr/depth/forecast.h>
#include <cdr/depth/rounding.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace cdr::depth;

TEST(Rounding, FloatGapIsThatOfNeighbouringFloats) {
    for (const float value : {1e-30f, 1e-3f, 0.75f, 1.0f, 3.0f, 1e6f, 16777216.0f}) {
        EXPECT_EQ(floatGap(static_cast<double>(value)),
                  static_cast<double>(std::nextafterf(value, INFINITY)) - static_cast<double>(value));
    }
    EXPECT_GT(floatGap(0.0), 0.0);
}

/// A slanted plane drawn with vertices snapped to sub-pixels, interpolated as rasterisers do: 1 / w is linear over the
/// picture.
TEST(Rounding, SnappedPlanesMoveByNoMoreThanTheModelSays) {
    std::mt19937_64 random(9);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    constexpr double kFootprint = 1e-3; // scene units a pixel at distance 1
    for (const unsigned bits : {4u, 8u}) {
        for (const double slope : {0.0, 1.0, 3.0}) {
            DepthRounding said;
            said.snapGapView = snapGapView(bits, kFootprint, slope);
            double worst = 0.0;
            for (int i = 0; i < 20'000; ++i) {
                // Around the pixel in the middle, whose plane lies at distance 1.
                const double turn = 3.2 * unit(random);
                const auto inverseAt = [&](double x, double y) {
                    return 1.0 - slope * kFootprint * (x * std::cos(turn) + y * std::sin(turn));
                };
                const double x[3] = {-9.0 + unit(random), 9.0 + unit(random), unit(random)};
                const double y[3] = {-7.0 + unit(random), -7.0 + unit(random), 9.0 + unit(random)};
                double sx[3];
                double sy[3];
                for (int v = 0; v < 3; ++v) {
                    sx[v] = std::round(std::ldexp(x[v], static_cast<int>(bits))) * std::exp2(-double(bits));
                    sy[v] = std::round(std::ldexp(y[v], static_cast<int>(bits))) * std::exp2(-double(bits));
                }
                const auto area = [&](int a, int b) { return sx[a] * sy[b] - sx[b] * sy[a]; };
                const double all = area(0, 1) + area(1, 2) + area(2, 0);
                double inverse = 0.0;
                for (int v = 0; v < 3; ++v) {
                    inverse += area((v + 1) % 3, (v + 2) % 3) / all * inverseAt(x[v], y[v]);
                }
                worst = std::max(worst, std::abs(1.0 / inverse - 1.0));
            }
            EXPECT_LE(worst, 1.01 * said.worstView() + 1e-15) << bits << ' ' << slope;
            EXPECT_GE(worst, 0.4 * said.worstView()) << bits << ' ' << slope;
            EXPECT_EQ(worst > 1e-12, slope > 0.0);
        }
    }
}

TEST(Rounding, DepthSlopeIsTheDerivative) {
    for (const Mapping mapping : kMappings) {
        const DepthRange range{.mapping = mapping, .nearView = 2.0, .farView = 900.0};
        for (const double w : {3.0, 40.0, 800.0}) {
            const double h = 1e-6 * w;
            const double expected = std::abs(zNdcAt(range, w + h) - zNdcAt(range, w - h)) / (2.0 * h);
            EXPECT_NEAR(depthSlope(range, w) / expected, 1.0, 1e-5) << nameOf(mapping) << ' ' << w;
        }
    }
    EXPECT_NEAR(depthSlope({.mapping = Mapping::reversed, .nearView = 0.1, .farView = {}}, 10.0), 1e-3,
                1e-12);
}

/// Depth of a surface at view distance w as the vertex shader forms it, with every operation in float32. The
/// object is rounded first, and a vertex's own offset is added. Then it is interpolated between two vertices.
float floatDepth(const DepthRange& range, double w, double offset, float weight) {
    const ClipTerms terms = clipTerms(range);
    const auto zOf = [&](double local) {
        const float ahead = static_cast<float>(w - local - terms.anchorView) + static_cast<float>(local);
        const float distance = static_cast<float>(terms.anchorView) + ahead;
        if (isLog(range.mapping)) {
            const float z =
                std::log(distance * static_cast<float>(terms.scale)) * static_cast<float>(terms.offset);
            return z * distance / distance;
        }
        return (static_cast<float>(terms.scale) * ahead + static_cast<float>(terms.offset)) / distance;
    };
    const float first = zOf(offset);
    return first + weight * (zOf(-offset) - first);
}

/// The model against the arithmetic itself, without a device. The error of a surface stays below the worst
/// case and has about the predicted deviation. The rounding of the constants is common to all surfaces, so it
/// changes no order, and the mean error is subtracted.
TEST(Rounding, IsWhatFloatArithmeticDoes) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    int lively = 0;
    const auto check = [&](const DepthRange& range, double atView, double deepView) {
        const DepthRounding said = depthRounding(range, atView);
        const double slope = depthSlope(range, atView);
        std::vector<double> errors;
        for (int i = 0; i < 20'000; ++i) {
            const double w = atView + 0.5 * deepView * unit(random);
            const float z = floatDepth(range, w, 0.4 * deepView * unit(random), 0.5f);
            errors.push_back((static_cast<double>(z) - zNdcAt(range, w)) / slope);
        }
        double mean = 0.0;
        for (const double error : errors) {
            mean += error / static_cast<double>(errors.size());
        }
        double square = 0.0;
        double worst = 0.0;
        for (const double error : errors) {
            square += (error - mean) * (error - mean) / static_cast<double>(errors.size());
            worst = std::max(worst, std::abs(error - mean));
        }
        const std::string name = std::string(nameOf(range.mapping)) + " at " + std::to_string(atView);
        EXPECT_LE(worst, 1.25 * said.worstView()) << name;
        EXPECT_LT(std::sqrt(square), 2.0 * said.deviationView()) << name;
        if (deepView > 8.0 * said.depthGapView) { // else all surfaces share a depth, and its error
            EXPECT_GT(std::sqrt(square), said.deviationView() / 4.0) << name;
            ++lively;
        }
    };
    for (const double w : {3.0, 1e3, 1e6}) {
        const double deep = 1e-6 * w; // so that slope and gaps hardly change
        check({.mapping = Mapping::standard, .nearView = 0.5, .farView = 2.0 * w}, w, deep);
        check({.mapping = Mapping::log, .nearView = 0.5, .farView = 2.0 * w}, w, deep);
        check({.mapping = Mapping::reversed, .nearView = 0.5, .farView = {}}, w, deep);
    }
    check({.mapping = Mapping::anchored, .nearView = 1e6, .farView = 1e6 + 20.0}, 1e6 + 15.0, 4.0);
    EXPECT_GE(lively, 4);
}

TEST(Forecast, AGuaranteeIsWiderThanAnExpectation) {
    for (const auto& [name, technique] : presets()) {
        const Forecast made =
            forecast(technique, {.nearView = 0.001, .farView = 2e3, .footprintSlope = 5e-5, .atView = 1e3});
        EXPECT_GT(made.guaranteedView(), made.resolvedView() * 0.9) << nameOf(technique);
        EXPECT_GT(made.resolvedView(), made.bufferStepView) << nameOf(technique);
    }
}

TEST(Forecast, APixelTargetNeedsAPixel) {
    const ForecastScene lensless{.nearView = 0.001, .farView = 2e3, .atView = 1e3};
    EXPECT_THROW(forecast(parseTechnique("anchored"), lensless), cdr::base::InputError);
}

/// Something at the near plane takes cascades that the content would otherwise have.
TEST(Forecast, SomethingNearCostsFittedCascades) {
    Technique anchored = parseTechnique("anchored");
    anchored.format = DepthFormat::d16;
    ForecastScene scene{
        .nearView = 0.001, .farView = 2e6, .footprintSlope = 5e-8, .atView = 1e6, .spanView = 13.7};
    const double crowded = forecast(anchored, scene).bufferStepView;
    scene.somethingNear = false;
    EXPECT_GT(crowded, 2.0 * forecast(anchored, scene).bufferStepView);
}

} // namespace
