#include <cdr/base/error.h>
#include <cdr/depth/advice.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace {

using namespace cdr::depth;

ForecastScene sceneAt(double atView) {
    return {.nearView = 0.001,
            .farView = 2.0 * atView,
            .footprintSlope = 0.05 / atView, // the ladder's lens
            .atView = atView,
            .spanView = 18.0};
}

Forecast forecastOf(const char* name, DepthFormat format, double atView) {
    Technique technique = parseTechnique(name);
    technique.format = format;
    return forecast(technique, sceneAt(atView));
}

/// What `cdr probe` measured on lavapipe (Mesa 22.3.6), within a factor of three.
TEST(Forecast, IsNearWhatTheProbeMeasured) {
    const auto expectNear = [](const char* name, DepthFormat format, double atView, double measured) {
        const double ratio = forecastOf(name, format, atView).resolvedView() / measured;
        EXPECT_GT(ratio, 1.0 / 3.0) << name << " " << atView;
        EXPECT_LT(ratio, 3.0) << name << " " << atView;
    };
    for (const DepthFormat format : {DepthFormat::d24, DepthFormat::d32f}) {
        for (const double w : {1e5, 1e6, 1e7, 1e8, 1e9}) {
            expectNear("anchored", format, w, 1.8e-6);
        }
        expectNear("logcdr", format, 1e6, 0.8);
        expectNear("log", format, 1e3, 2.1e-3);
    }
    expectNear("reversed", DepthFormat::d32f, 1e6, 0.23);
}

TEST(Forecast, VertexRoundingIsFloat32sOfWhatTheShaderReceives) {
    EXPECT_DOUBLE_EQ(forecastOf("reversed", DepthFormat::d32f, 1e6).rounding.distanceGapView, 0x1p-4);
    EXPECT_DOUBLE_EQ(forecastOf("anchored", DepthFormat::d32f, 1e6).rounding.distanceGapView, 0x1p-19);
    EXPECT_GT(forecastOf("log", DepthFormat::d32f, 1e6).rounding.depthGapView, 1.0);
}

AdviceQuestion question(double atView, double separationView) {
    return {.scene = sceneAt(atView), .separationView = separationView};
}

TEST(Advice, NamesTheSimplestThatSuffices) {
    const auto simplest = [](double atView, double separationView) {
        const Advice advice = advise(question(atView, separationView));
        return advice.simplest ? nameOf(advice.rows[*advice.simplest].technique) : "none";
    };
    EXPECT_EQ(simplest(1.0, 0.01), "standard");
    EXPECT_EQ(simplest(1e6, 1.0), "reversed");
    EXPECT_EQ(simplest(1e6, 0.01), "anchored");
    EXPECT_EQ(simplest(1e6, 1e-5), "anchored");
    EXPECT_EQ(simplest(1e6, 1e-8), "none");
}

TEST(Advice, ChoosesFromTheTechniquesThatAreAskedFor) {
    AdviceQuestion asked = question(1e6, 0.01);
    asked.techniques = {parseTechnique("anchored"), parseTechnique("reversed")};
    asked.formats = {DepthFormat::d24, DepthFormat::d32f};
    const Advice advice = advise(asked);
    std::vector<std::string> rows;
    for (const AdviceRow& row : advice.rows) {
        rows.push_back(std::string(nameOf(row.technique.mapping)) + "/" +
                       std::string(nameOf(row.technique.format)));
    }
    EXPECT_EQ(rows,
              (std::vector<std::string>{"anchored/d24", "anchored/d32f", "reversed/d24", "reversed/d32f"}));
    ASSERT_TRUE(advice.simplest);
    EXPECT_EQ(advice.rows[*advice.simplest].technique.mapping, Mapping::anchored);
    asked.techniques = {parseTechnique("reversed")};
    EXPECT_FALSE(advise(asked).simplest);
}

TEST(Advice, KnowsHowSimpleEachPresetIs) {
    std::set<std::string> listed(kSimplestFirst.begin(), kSimplestFirst.end());
    for (const NamedTechnique& preset : presets()) {
        EXPECT_EQ(listed.erase(preset.name), 1u) << preset.name;
    }
    EXPECT_TRUE(listed.empty());
}

/// Its figure is its forecast, which is finer than that of the preset. A measurement may make it the only one that is enough.
TEST(Advice, EndsWithAnchoredReversedFittedAsFineAsCanBe) {
    const char* finest = "anchored-reversed/fitted:1e-9";
    const AdviceQuestion asked = question(1e6, 1e-6);
    const Advice predicted = advise(asked);
    const AdviceRow& last = predicted.rows.back();
    EXPECT_EQ(nameOf(last.technique), nameOf(parseTechnique(finest)));
    const auto resolvedBy = [&](const char* name) {
        return forecastOf(name, last.technique.format, 1e6).resolvedView();
    };
    EXPECT_EQ(last.resolvedView(), resolvedBy(finest));
    EXPECT_LT(last.resolvedView(), resolvedBy("anchored") / 1.5);
    EXPECT_EQ(costOf(last).substr(0, 42), "float64 offset per object, flipped compare");

    std::vector<std::optional<Measurement>> measurements(
        predicted.rows.size(), Measurement{.resolvedView = 2e-6, .largestView = 1.0});
    measurements.back() = {.resolvedView = 0.8e-6, .largestView = 1.0};
    const Advice advice = advise(asked, measurements);
    ASSERT_EQ(advice.simplest, advice.rows.size() - 1);
    const std::vector<std::string> lines = explain(asked, advice);
    EXPECT_TRUE(std::any_of(lines.begin(), lines.end(), [](const std::string& line) {
        return line.find("detail at one distance") != std::string::npos;
    }));
}

TEST(Advice, EverySimplerTechniqueFallsShort) {
    for (const double separation : {1e-6, 1e-4, 1e-2, 1.0, 100.0}) {
        const Advice advice = advise(question(1e5, separation));
        ASSERT_TRUE(advice.simplest.has_value());
        const AdviceRow& simplest = advice.rows[*advice.simplest];
        EXPECT_TRUE(simplest.suffices);
        for (std::size_t i = 0; i <= *advice.simplest; ++i) {
            const AdviceRow& row = advice.rows[i];
            EXPECT_EQ(row.suffices, row.forecast.resolvedView() <= separation);
            EXPECT_TRUE(!row.suffices || nameOf(row.technique) == nameOf(simplest.technique));
            EXPECT_TRUE(!row.suffices || row.forecast.cascades >= simplest.forecast.cascades);
        }
    }
}

TEST(Advice, SaysSoInPlainWords) {
    const auto words = [](const AdviceQuestion& asked) { return explain(asked, advise(asked)); };
    EXPECT_EQ(words(question(1e6, 1.0)).front().substr(0, 41), "reversed with d32f in one cascade is enou");
    const auto anchored = words(question(1e6, 1e-5));
    ASSERT_EQ(anchored.size(), 5u);
    EXPECT_NE(anchored[1].find("float64 offset per object, 1 more depth clear"), std::string::npos);
    EXPECT_NE(anchored[3].find("has a depth of"), std::string::npos);
    EXPECT_EQ(words(question(1e6, 1e-9)).front().substr(0, 21), "Nothing here resolves");
}

/// Snapping decides where a sub-pixel is worth more than the separation, and is named wherever it may.
TEST(Advice, CountsSnappingWhereAskedTo) {
    AdviceQuestion asked = question(1e6, 1e-5);
    asked.scene.footprintSlope = 1e-6; // a pixel covers 1 unit, a sub-pixel 1/256
    ASSERT_TRUE(advise(asked).simplest);
    EXPECT_EQ(
        explain(asked, advise(asked)).back(),
        "If vertices snap to 8 sub-pixel bits, faces of slope 1 with different outlines may swap below a gap "
        "of 0.005524. With --snapping in-plane, flat facets do not.");
    asked.scene.subPixelBits = 4;
    const Advice snapped = advise(asked);
    EXPECT_FALSE(snapped.simplest);
    EXPECT_NE(explain(asked, snapped).front().find("limited by the snapping"), std::string::npos);
    asked.scene.slope = 0.0; // faces the camera
    EXPECT_TRUE(advise(asked).simplest);
}

/// Pairs of a ladder have outlines alike, so a measurement knows nothing of it.
TEST(Advice, MeasurementsDoNotOverruleSnapping) {
    AdviceQuestion asked = question(1e6, 1e-5);
    asked.scene.footprintSlope = 1e-6;
    const std::size_t rows = advise(asked).rows.size();
    const std::vector<std::optional<Measurement>> measured(
        rows, Measurement{.resolvedView = 1e-6, .largestView = 1.0});
    EXPECT_TRUE(advise(asked, measured).simplest);
    asked.scene.subPixelBits = 4;
    const Advice snapped = advise(asked, measured);
    EXPECT_FALSE(snapped.simplest);
    EXPECT_NE(explain(asked, snapped).front().find("limited by the snapping"), std::string::npos);
    // Where snapping is worth less than the question, no sentence calls its reach measured.
    asked.separationView = 1.0;
    EXPECT_EQ(explain(asked, advise(asked, measured)).front().find("was measured"), std::string::npos);
}

/// A measurement overrules the formula in both directions, down to a step of the buffer.
TEST(Advice, MeasurementsDecideWhereThereAreAny) {
    const AdviceQuestion asked = question(1e6, 0.5);
    const Advice predicted = advise(asked);
    const auto rowOf = [&](const Advice& advice, const char* name, DepthFormat format) {
        return std::find_if(advice.rows.begin(), advice.rows.end(), [&](const AdviceRow& row) {
            return nameOf(row.technique) == name && row.technique.format == format;
        });
    };
    ASSERT_EQ(nameOf(predicted.rows[*predicted.simplest].technique), "reversed");
    std::vector<std::optional<Measurement>> measurements(predicted.rows.size());
    const auto index = [&](const char* name) {
        return static_cast<std::size_t>(rowOf(predicted, name, DepthFormat::d32f) - predicted.rows.begin());
    };
    measurements[index("reversed")] = {.resolvedView = 0.7, .largestView = 1.0};
    measurements[index("logcdr")] = {.resolvedView = 0.45,
                                     .largestView = 1.0,
                                     .timeRatio = 1.25,
                                     .timeRatio95 = RatioInterval{.low = 0.90849, .high = 1.42153}};
    Advice advice = advise(asked, measurements);
    EXPECT_FALSE(rowOf(advice, "reversed", DepthFormat::d32f)->suffices);
    EXPECT_EQ(nameOf(advice.rows[*advice.simplest].technique), "logcdr");
    EXPECT_NE(explain(asked, advice)[0].find("was measured to resolve 0.45"), std::string::npos);
    EXPECT_NE(explain(asked, advice)[1].find("+25 % of a frame (-9.151 to +42.15)."), std::string::npos)
        << "digits as in the table";
    measurements[index("logcdr")]->timeRatio95.reset();
    EXPECT_NE(explain(asked, advise(asked, measurements))[1].find("+25 % of a frame."), std::string::npos)
        << "too few frames for an interval";

    // Nothing that was tried came out right: wider gaps stay unanswered, narrower ones are refused.
    measurements.assign(predicted.rows.size(), std::nullopt);
    for (const double largest : {0.5, 0.6}) {
        measurements[index("reversed")] = {.resolvedView = {}, .largestView = largest};
        EXPECT_FALSE(rowOf(advise(asked, measurements), "reversed", DepthFormat::d32f)->suffices);
    }
    measurements[index("reversed")] = {.resolvedView = {}, .largestView = 0.001};
    EXPECT_TRUE(rowOf(advise(asked, measurements), "reversed", DepthFormat::d32f)->suffices);
    EXPECT_THROW(advise(asked, {}), cdr::base::InputError);
}

TEST(Advice, NamesTheCost) {
    const Advice advice = advise(question(1e6, 0.5));
    const auto cost = [&](const char* name) {
        for (const AdviceRow& row : advice.rows) {
            if (nameOf(row.technique) == name) {
                return costOf(row);
            }
        }
        return std::string("no such row");
    };
    EXPECT_EQ(cost("standard"), "nothing");
    EXPECT_EQ(cost("reversed"), "flipped compare");
    EXPECT_EQ(cost("log"), "logarithm per vertex");
    EXPECT_EQ(cost("cdr"), "3 more depth clears");
    EXPECT_EQ(cost("logcdr"), "logarithm per vertex, 3 more depth clears");
}

TEST(Advice, TheWidestContentIsResolvedAndFourTimesThatIsNot) {
    AdviceQuestion asked = question(1e6, 1e-4);
    const Advice advice = advise(asked);
    ASSERT_TRUE(advice.widest);
    ASSERT_GT(advice.widestSpanView, 100.0);
    asked.scene.spanView = 0.99 * advice.widestSpanView;
    EXPECT_TRUE(advise(asked).rows[*advice.widest].suffices);
    asked.scene.spanView = 4.0 * advice.widestSpanView;
    EXPECT_FALSE(advise(asked).rows[*advice.widest].suffices);
}

/// The line on the depth of content; empty where there is none.
std::string widestLine(const AdviceQuestion& asked, const Advice& advice) {
    for (const std::string& line : explain(asked, advice)) {
        if (line.find(" if what is visible there has a depth of at most ") != std::string::npos) {
            return line;
        }
    }
    return "";
}

TEST(Advice, TheWidestContentIsOfWhatWasAskedFor) {
    AdviceQuestion asked{.scene = {.nearView = 1.0,
                                   .farView = 1e6,
                                   .footprintSlope = 1e-3,
                                   .atView = 1000.0,
                                   .spanView = 200.0},
                         .separationView = 1e-4,
                         .formats = {DepthFormat::d16}};
    const Advice advice = advise(asked);
    ASSERT_FALSE(advice.simplest);
    EXPECT_LT(advice.widestSpanView, 200.0) << "not d32f";
    asked.techniques = {parseTechnique("reversed")};
    EXPECT_EQ(widestLine(asked, advise(asked)), "") << "no anchored one was asked for";
    asked.techniques = {parseTechnique("anchored")};
    asked.formats = {DepthFormat::d16, DepthFormat::d32f};
    EXPECT_EQ(widestLine(asked, advise(asked)).substr(0, 45),
              "anchored with d32f resolves it if what is vis");
}

/// Thin content takes one cascade, which is coarser than the two of deeper content.
TEST(Advice, TheWidestContentMayResolveWhatThinContentDoesNot) {
    const Advice advice = advise(
        {.scene =
             {.nearView = 1.0, .farView = 1e6, .footprintSlope = 1.604e-3, .atView = 27.0, .spanView = 10.0},
         .separationView = 1e-5,
         .formats = {DepthFormat::d32f},
         .techniques = {parseTechnique("anchored")}});
    ASSERT_TRUE(advice.rows[0].suffices);
    EXPECT_GE(advice.widestSpanView, 10.0);
}

/// Content may be thinner than the thin content that is tried where what was asked for is not resolved.
TEST(Advice, TheWidestContentIsResolvedWhereVeryThinContentIsAskedFor) {
    AdviceQuestion asked{
        .scene = {.nearView = 1.0, .farView = 1e6, .footprintSlope = 1e-3, .atView = 1e5, .spanView = 1e-5},
        .separationView = 1e-9,
        .formats = {DepthFormat::d16},
        .techniques = {parseTechnique("anchored")}};
    const Advice advice = advise(asked);
    ASSERT_TRUE(advice.rows[0].suffices);
    EXPECT_GE(advice.widestSpanView, 1e-5);
    asked.scene.spanView = advice.widestSpanView;
    EXPECT_TRUE(advise(asked).rows[0].suffices) << advice.widestSpanView;
}

/// Whoever asks again with content as deep as the line says gets that technique as enough.
TEST(Advice, TheWidestContentKeepsItsPromise) {
    std::mt19937_64 random(7);
    const auto between = [&](double low, double high) {
        return low * std::pow(high / low, std::uniform_real_distribution<double>()(random));
    };
    int lines = 0;
    for (int i = 0; i < 500; ++i) {
        AdviceQuestion asked;
        asked.scene.footprintSlope = between(1e-4, 1e-2);
        asked.scene.nearView = between(1e-3, 10.0);
        asked.scene.farView = asked.scene.nearView * between(1e2, 1e9);
        asked.scene.atView = between(2.0 * asked.scene.nearView, 0.9 * asked.scene.farView);
        asked.scene.spanView = asked.scene.atView * between(1e-4, 1.0);
        asked.separationView = asked.scene.atView * between(1e-11, 1e-3);
        asked.formats = {kDepthFormats[random() % kDepthFormats.size()]};
        const Advice advice = advise(asked);
        ASSERT_EQ(advice.widest.has_value(), advice.widestSpanView > 0.0);
        if (!advice.widest) {
            continue;
        }
        lines += widestLine(asked, advice).empty() ? 0 : 1;
        const AdviceRow& widest = advice.rows[*advice.widest];
        EXPECT_EQ(widest.suffices, advice.widestSpanView >= asked.scene.spanView) << i;
        asked.scene.spanView = advice.widestSpanView;
        EXPECT_TRUE(advise(asked).rows[*advice.widest].suffices) << i << " " << nameOf(widest.technique);
    }
    EXPECT_GT(lines, 10);
}

/// A measurement has a smallest gap. Where that came out right too, the forecast says what less is resolved.
TEST(Advice, AsksTheForecastBelowTheSmallestGapThatWasMeasured) {
    const AdviceQuestion asked{
        .scene = {.nearView = 0.1, .farView = 2000.0, .footprintSlope = 1e-3, .atView = 1000.0},
        .separationView = 8e-7};
    const Advice predicted = advise(asked);
    ASSERT_TRUE(predicted.simplest);
    const auto measuredAs = [&](bool resolvesAll) {
        const std::vector<std::optional<Measurement>> measured(
            predicted.rows.size(),
            Measurement{.resolvedView = 1e-6, .largestView = 1.0, .resolvesAll = resolvesAll});
        return tryAdvise(asked, measured).orThrow();
    };
    EXPECT_FALSE(measuredAs(false).simplest);
    const Advice advice = measuredAs(true);
    EXPECT_EQ(advice.simplest, predicted.simplest);
    EXPECT_EQ(explain(asked, advice)[0], explain(asked, predicted)[0])
        << "the forecast is not called measured";
    for (std::size_t i = 0; i < advice.rows.size(); ++i) {
        EXPECT_LE(advice.rows[i].resolvedView(), std::max(1e-6, predicted.rows[i].resolvedView()));
    }
}

/// One picture may have gaps in order that the buffer stores as one number.
TEST(Advice, NothingSufficesBelowAStepOfTheDepthBuffer) {
    AdviceQuestion asked = question(1e6, 1e-3);
    const std::size_t rows = advise(asked).rows.size();
    const std::vector<std::optional<Measurement>> lucky(
        rows, Measurement{.resolvedView = 1e-9, .largestView = 1.0});
    for (const double separation : {1e-7, 1e-5, 1e-3, 0.1, 10.0}) {
        asked.separationView = separation;
        for (const AdviceRow& row : advise(asked, lucky).rows) {
            EXPECT_TRUE(!row.suffices || separation >= row.forecast.bufferStepView)
                << nameOf(row.technique) << " " << separation;
        }
    }
    asked.separationView = 1e-9;
    EXPECT_NE(explain(asked, advise(asked, lucky)).front().find("limited by the steps of the depth buffer"),
              std::string::npos);
}

/// Of the measured 9e-7, 8.2e-7 are the step. float32 distances are 2.4e-7 apart there.
TEST(Advice, NamesTheDepthBufferWhereItsStepIsMostOfWhatWasMeasured) {
    AdviceQuestion asked{
        .scene = {.nearView = 1.0, .farView = 100.0, .footprintSlope = 1e-3, .atView = 3.0, .spanView = 0.1},
        .separationView = 1e-12,
        .formats = {DepthFormat::d24},
        .techniques = {parseTechnique("log")}};
    const auto firstLine = [&](double resolved) {
        const std::vector<std::optional<Measurement>> measured(
            advise(asked).rows.size(), Measurement{.resolvedView = resolved, .largestView = 1.0});
        return explain(asked, advise(asked, measured)).front();
    };
    EXPECT_NE(firstLine(9e-7).find("limited by the steps of the depth buffer"), std::string::npos);
    EXPECT_NE(firstLine(5e-6).find("limited by float32 view distances"), std::string::npos);
}

TEST(Advice, RefusesNonsense) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    using cdr::base::InputError;
    EXPECT_THROW(advise(question(1e6, 0.0)), InputError);
    EXPECT_THROW(advise(question(1e6, -1.0)), InputError);
    EXPECT_THROW(advise(question(1e6, kNan)), InputError);
    for (const double bad : {0.0, -1.0, kNan, 1e9}) {
        AdviceQuestion asked = question(1e6, 1.0);
        asked.scene.atView = bad;
        EXPECT_THROW(advise(asked), InputError) << bad;
    }
    AdviceQuestion asked = question(1e6, 1.0);
    asked.scene.spanView = kNan;
    EXPECT_THROW(advise(asked), InputError);
    asked = question(1e6, 1.0);
    asked.formats.clear();
    EXPECT_THROW(advise(asked), InputError);
}

} // namespace
