#include <cdr/depth/forecast.h>
#include <viewer/state/length_text.h>
#include <viewer/state/technique_label.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cdr::viewer {

namespace {

TEST(LengthText, PicksTheUnitAndTheDigits) {
    EXPECT_EQ(lengthText(420e3 + 1.3, 0.1), "420.0013\u00a0km");
    EXPECT_EQ(lengthText(0.005, 2e-5), "5.00\u00a0mm");
    EXPECT_EQ(lengthText(420e3, 2.4e-6), "420.000000000\u00a0km");
    EXPECT_EQ(lengthText(3.844e8, 1e3), "384400\u00a0km");
    EXPECT_EQ(lengthText(1.496e11, 1e6), "149.600\u00a0million\u00a0km");
    EXPECT_EQ(lengthText(2.5e-6, 1e-7), "2.5\u00a0µm");
    EXPECT_EQ(lengthText(0.3, 0.01), "300\u00a0mm");
    EXPECT_EQ(lengthText(12.0), "12.00\u00a0m");
    EXPECT_EQ(lengthText(-12.25, 0.01), "-12.25\u00a0m");
    EXPECT_EQ(lengthText(7.0, 300.0), "0\u00a0m");
    EXPECT_EQ(lengthText(0.0, 2e-6), "0\u00a0µm");
    EXPECT_EQ(lengthText(0.0), "0\u00a0m");
    EXPECT_EQ(lengthText(950.0, 600.0), "950\u00a0m");
    EXPECT_EQ(lengthText(std::numeric_limits<double>::infinity(), 1.0), "infinite");
    EXPECT_EQ(lengthText(std::nan("")), "infinite");
    EXPECT_EQ(lengthText(1.0, std::nan("")), "1.000\u00a0m");
}

TEST(LengthText, ReadsBackToWithinAStepAndNotFiner) {
    for (double metres = 3.7e-6; metres < 1e13; metres *= 7.3) {
        for (const double relative : {1e-2, 1e-6, 1e-11}) {
            const std::string text = lengthText(metres, metres * relative);
            const double unit = text.ends_with("million\u00a0km") ? 1e9
                                : text.ends_with("km")            ? 1e3
                                : text.ends_with("mm")            ? 1e-3
                                : text.ends_with("µm")            ? 1e-6
                                                                  : 1.0;
            EXPECT_NEAR(std::stod(text) * unit, metres, 0.51 * metres * relative) << text;
            const auto digits =
                std::count_if(text.begin(), text.end(), [](char c) { return std::isdigit(c); });
            constexpr double kMostBeforeThePoint = 6.0; // of a unit's whole number, which stays whole
            EXPECT_LE(static_cast<double>(digits), std::max(kMostBeforeThePoint, 3.0 - std::log10(relative)))
                << text;
        }
    }
}

TEST(LengthText, NeverShowsMoreThanAFloat64Holds) {
    EXPECT_EQ(lengthText(123456.789, 1e-300).find("123.4567890000000"), 0u);
    EXPECT_LE(lengthText(123456.789, 1e-300).size(), 22u);
}

TEST(LagText, SpeaksFromHalfASecondOn) {
    EXPECT_EQ(lagText(0.0), "");
    EXPECT_EQ(lagText(0.49), "");
    EXPECT_EQ(lagText(1.26), "rendering, 1.3\u00a0s behind");
}

TEST(StepText, TwoDigits) {
    EXPECT_EQ(stepText(2.44e-6), "2.4\u00a0µm");
    EXPECT_EQ(stepText(0.0123), "12\u00a0mm");
    EXPECT_EQ(stepText(420.0), "420\u00a0m");
    EXPECT_EQ(stepText(0.99999e-3), "1000\u00a0µm");
    EXPECT_EQ(stepText(3.4e-9), "0.0034\u00a0µm");
    EXPECT_EQ(stepText(1e-20), "1.0e-20\u00a0m");
    EXPECT_EQ(stepText(0.0), "0\u00a0µm");
    EXPECT_EQ(stepText(std::numeric_limits<double>::infinity()), "infinite");
}

TEST(TechniqueStep, IsTheForecastsWhereCascadesAgree) {
    const depth::ForecastScene scene{.nearView = 0.001, .farView = 2e6, .atView = 1e6};
    for (const char* name : {"standard", "cdr", "log", "logcdr", "reversed"}) {
        const depth::Technique technique = depth::parseTechnique(name);
        const depth::Cascades cascades = depth::forecastCascades(technique, scene);
        // The boundary of cdr lies there, less a rounding; the forecast takes the cascade before it, as this
        // does.
        const double step = techniqueStepView(technique, cascades, scene.atView);
        const double forecast = depth::forecast(technique, scene).resolvedView();
        EXPECT_TRUE(step == forecast || std::abs(step / forecast - 1.0) < 1e-4) << name << " " << step;
    }
}

TEST(TechniqueStep, AnchoredTellsMicrometresApartWhereOthersTellNothing) {
    const depth::Technique anchored = depth::parseTechnique("anchored");
    const depth::Cascades thin{{999'984.0, 1'000'016.0}};
    EXPECT_LT(techniqueStepView(anchored, thin, 1e6), 1e-5);
    EXPECT_GT(techniqueStepView(depth::parseTechnique("reversed"), {{0.001, 2e6}}, 1e6), 0.05);
    EXPECT_TRUE(std::isinf(techniqueStepView(anchored, thin, 5.0)));
    EXPECT_TRUE(std::isinf(techniqueStepView(anchored, thin, 2e6)));
    EXPECT_TRUE(std::isinf(techniqueStepView(anchored, {}, 1.0)));
    // A hair beyond its cascade, as overlaps draw.
    EXPECT_LT(techniqueStepView(anchored, thin, 1'000'016.001), 1e-4);
}

TEST(ResolvesText, ClaimsNothingWhereAStepTakesAGoodPartOfTheWay) {
    EXPECT_EQ(resolvesText(2.44e-6, 420'001.3), "tells 2.4\u00a0µm apart at 420.0\u00a0km");
    EXPECT_EQ(resolvesText(2.762e6, 0.5), "a step is over a tenth of 500.0\u00a0mm");
    EXPECT_EQ(resolvesText(std::numeric_limits<double>::infinity(), 3.0),
              "tells nothing apart at 3.000\u00a0m");
}

TEST(Counted, HasItsPlural) {
    EXPECT_EQ(counted(0, "flip"), "0 flips");
    EXPECT_EQ(counted(1, "flip"), "1 flip");
    EXPECT_EQ(counted(2, "pixel"), "2 pixels");
}

} // namespace

} // namespace cdr::viewer
