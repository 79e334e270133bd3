#include <cdr/depth/forecast.h>
#include <viewer/state/importer_notes.h>
#include <viewer/state/light_list.h>
#include <viewer/state/plain_words.h>
#include <viewer/state/technique_label.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace cdr::viewer {

namespace {

TEST(LagText, SpeaksFromHalfASecondOn) {
    EXPECT_EQ(lagText(0.0), "");
    EXPECT_EQ(lagText(0.49), "");
    EXPECT_EQ(lagText(1.26), "rendering, 1.3\u00a0s behind");
}

TEST(LightLines, NameTypesAndBoundTheirNumber) {
    EXPECT_TRUE(lightLines({}).empty());
    const std::vector<scene::ListedLight> two{{.name = "lamp", .type = scene::LightType::spot, .moves = true},
                                              {.name = {}, .type = scene::LightType::directional}};
    EXPECT_EQ(lightLines(two), (std::vector<std::string>{"spot light 'lamp', moves", "directional light"}));
    const std::vector<std::string> many = lightLines(std::vector<scene::ListedLight>(14));
    ASSERT_EQ(many.size(), 13u);
    EXPECT_EQ(many[0], "point light");
    EXPECT_EQ(many[12], "and 2 more lights");
}

/// The viewer plays animations, so what a renderer would leave out is not ignored.
TEST(ImporterNotes, LeaveOutTheOneOfAnimations) {
    scene::OpenedScene opened;
    opened.notes = {"its camera", "its animation", "a sheen"};
    EXPECT_EQ(
        importerNotes(opened),
        (std::vector<std::string>{"ignored: its camera", "ignored: its animation", "ignored: a sheen"}));
    opened.animationsNote = 1;
    EXPECT_EQ(importerNotes(opened), (std::vector<std::string>{"ignored: its camera", "ignored: a sheen"}));
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
    // Just beyond its cascade, as overlaps draw.
    EXPECT_LT(techniqueStepView(anchored, thin, 1'000'016.001), 1e-4);
}

TEST(ResolvesText, ClaimsNothingWhereAStepTakesAGoodPartOfTheWay) {
    using base::LengthUnit;
    EXPECT_EQ(resolvesText(2.44e-6, 420'001.3, LengthUnit::automatic),
              "resolves 2.44\u00a0µm at 420\u00a0km");
    EXPECT_EQ(resolvesText(2.44e-6, 420'001.3, LengthUnit::none), "resolves 2.44·10⁻⁶ at 420,001");
    EXPECT_EQ(resolvesText(2.762e6, 0.5, LengthUnit::metre), "a step is over a tenth of 0.5\u00a0m");
    EXPECT_EQ(resolvesText(std::numeric_limits<double>::infinity(), 3.0, LengthUnit::automatic),
              "resolves nothing at 3\u00a0m");
}

TEST(Counted, HasItsPlural) {
    EXPECT_EQ(counted(0, "flip"), "0 flips");
    EXPECT_EQ(counted(1, "flip"), "1 flip");
    EXPECT_EQ(counted(2, "pixel"), "2 pixels");
}

} // namespace

} // namespace cdr::viewer
