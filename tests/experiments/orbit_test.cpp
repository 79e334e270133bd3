#include "../support/shared_device.h"

#include <experiments/orbit/orbit.h>
#include <scenes/mixed.h>

#include <gtest/gtest.h>
#include <ranks/one_process.h>

#include <set>
#include <string>

namespace cdr::experiments {
namespace {

using Frames = std::vector<std::uint32_t>;

TEST(OrbitFrames, AreSpreadEvenlyAndEndWithTheLast) {
    EXPECT_EQ(zoomFrames(240, 1), (Frames{239}));
    EXPECT_EQ(zoomFrames(240, 3), (Frames{0, 119, 239}));
    EXPECT_EQ(zoomFrames(3, 5), (Frames{0, 1, 2}));
    EXPECT_EQ(zoomFrames(240, 240).size(), 240u);
    EXPECT_EQ(zoomFrames(240, 240).at(100), 100u);
}

TEST(OrbitPlot, DrawsALinePerTechniqueAndNoneAsTheFloor) {
    std::vector<OrbitResult> results;
    for (const char* technique : {"reversed", "anchored"}) {
        OrbitResult result{
            .frame = 0, .fovYDegrees = 60.0, .technique = technique, .cascades = 1, .wrong = {}};
        result.wrong.pixels = 1000;
        result.wrong.wrong = result.technique == "reversed" ? 250 : 0;
        results.push_back(result);
    }
    const std::string script = orbitPlot(results, "a 'device'");
    EXPECT_NE(script.find("60 25\n"), std::string::npos) << script;
    EXPECT_NE(script.find("60 1e-05\n"), std::string::npos) << script;
    EXPECT_NE(script.find("title 'anchored'"), std::string::npos) << script;
    EXPECT_NE(script.find("a ''device''"), std::string::npos) << script;
}

/// Colours come again after six lines, so points and dashes differ.
TEST(OrbitPlot, DrawsNoTwoLinesAlike) {
    std::vector<OrbitResult> results;
    for (int i = 0; i < 13; ++i) {
        results.push_back({.frame = 0, .fovYDegrees = 60.0, .technique = std::to_string(i), .wrong = {}});
    }
    const std::string script = orbitPlot(results, "a device");
    std::set<std::string> styles;
    for (std::size_t at = script.find("pointtype"); at != std::string::npos;
         at = script.find("pointtype", at + 1)) {
        styles.insert(script.substr(at, script.find(" title", at) - at));
    }
    EXPECT_EQ(styles.size(), results.size()) << script;
    EXPECT_NE(script.find("set format xy '%g'"), std::string::npos) << "ticks read 100, not 100.000000";
}

using OrbitDrawn = cdr::test::DeviceTest;

/// In a scene that is less to make.
TEST_F(OrbitDrawn, RoundedVerticesAreWrongAtMoreEdges) {
    if (device().info().subPixelBits <= 4) {
        GTEST_SKIP() << "the device itself rounds vertices to so few bits";
    }
    const scene::SceneSetup setup = scenes::makeMixed();
    OrbitOptions options{.drawing = {.width = 320, .height = 180}, .frames = 1};
    options.techniques = {depth::namedTechnique("anchored")};
    ranks::OneProcess alone;
    const auto edgeWrong = [&](std::uint32_t snapBits) {
        options.drawing.snapBits = snapBits;
        return runOrbit(
                   device(), setup, options, [](auto, auto, const auto&) {}, alone)
            .results.at(0)
            .wrong.edgeWrong;
    };
    EXPECT_GT(edgeWrong(2), edgeWrong(0));
}

/// Where one frame is drawn, it is the last: the telescope's, and not what the window shows.
TEST_F(OrbitDrawn, OneFrameHasNoPictureOfTheWindow) {
    const scene::SceneSetup setup = scenes::makeMixed();
    OrbitOptions options{.drawing = {.width = 64, .height = 36}, .frames = 1};
    options.techniques = {depth::namedTechnique("anchored")};
    ranks::OneProcess alone;
    const OrbitRun run = runOrbit(
        device(), setup, options, [](auto, auto, const auto&) {}, alone);
    EXPECT_EQ(run.last.size(), 1u);
    EXPECT_TRUE(run.window.pixels.empty());
}

TEST_F(OrbitDrawn, KeepsPicturesWhereTheyAreWanted) {
    scene::SceneSetup setup = scenes::makeMixed();
    setup.path.frames = 2;
    OrbitOptions options{.drawing = {.width = 64, .height = 36}, .frames = 2};
    options.techniques = {depth::namedTechnique("anchored")};
    ranks::OneProcess alone;
    for (const bool isWanted : {true, false}) {
        options.keepsPictures = isWanted;
        const OrbitRun run = runOrbit(
            device(), setup, options, [](auto, auto, const auto&) {}, alone);
        EXPECT_EQ(run.results.size(), 2u);
        EXPECT_EQ(run.last.empty(), !isWanted);
        EXPECT_EQ(run.window.pixels.empty(), !isWanted);
    }
}

} // namespace
} // namespace cdr::experiments
