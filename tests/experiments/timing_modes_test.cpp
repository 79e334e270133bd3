#include <cdr/base/error.h>
#include <cdr/depth/make_cascades.h>
#include <cdr/platform/worker_pool.h>
#include <experiments/scaling/scaling.h>
#include <experiments/timing/timing.h>

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace {

using namespace cdr::experiments;
using cdr::base::InputError;

TEST(TimingModes, BeginWithStandardTwiceAndHaveNamesOfTheirOwn) {
    const std::vector<TimingMode> modes = timingModes();
    ASSERT_GE(modes.size(), 12u);
    EXPECT_EQ(modes[0].name, "standard");
    EXPECT_EQ(nameOf(modes[1].drawing.technique), "standard");
    EXPECT_EQ(modes[0].drawing.targets, modes[1].drawing.targets);
    std::set<std::string> names;
    for (const TimingMode& mode : modes) {
        EXPECT_TRUE(names.insert(mode.name).second) << mode.name;
    }
}

/// Section 6.2 of the thesis.
TEST(TimingModes, CarryTheThesisFigures) {
    const std::map<std::string, double> thesis{{"cdr-2", 3.4},    {"cdr-3", 4.6},    {"cdr-4", 5.7},
                                               {"cdr-5", 7.1},    {"log", 4.4},      {"logcdr-2", 8.0},
                                               {"logcdr-3", 8.2}, {"logcdr-4", 8.4}, {"logcdr-5", 10.4}};
    std::map<std::string, double> found;
    for (const TimingMode& mode : timingModes()) {
        if (mode.thesisPercent) {
            found[mode.name] = *mode.thesisPercent;
        }
    }
    EXPECT_EQ(found, thesis);
}

TEST(TimingModes, CascadedOnesHaveTheCascadesTheirNameSays) {
    for (const TimingMode& mode : timingModesNamed({"cdr-4", "logcdr-2"})) {
        const std::size_t cascades =
            cdr::depth::makeCascades(mode.drawing.technique.split,
                                     {.nearView = 0.1, .farView = 1e5, .footprintSlope = 1e-3})
                .size();
        EXPECT_EQ(cascades, mode.name == "cdr-4" ? 4u : mode.name == "logcdr-2" ? 2u : 1u) << mode.name;
    }
}

TEST(TimingModes, ChosenOnesKeepTheBaselineOnce) {
    const std::vector<TimingMode> modes = timingModesNamed({"log", "standard"});
    ASSERT_EQ(modes.size(), 3u);
    EXPECT_EQ(modes[2].name, "log");
    EXPECT_THROW(timingModesNamed({"cdr-9"}), InputError);
}

TEST(TimingModes, OptionsOfARendererSayAllThatAModeDoes) {
    namespace render = cdr::render;
    const auto optionsOf = [](const char* name) { return timingModesNamed({name}).back().drawing; };
    EXPECT_EQ(optionsOf("cdr-3").technique.split, cdr::depth::Split(cdr::depth::SplitCount{3}));
    EXPECT_EQ(optionsOf("reversed/one-pass").targets, render::parseTargets("one-pass"));
    EXPECT_EQ(optionsOf("anchored/gpu-driven").submission, render::Submission::gpuDriven);
    EXPECT_EQ(optionsOf("naive").batching, render::Batching::perObject);
    EXPECT_EQ(optionsOf("reversed/visibility").surface, render::SurfacePath::visibility);
    EXPECT_EQ(optionsOf("anchored/lit").surface, render::SurfacePath::lit);
    EXPECT_TRUE(optionsOf("standard/occlusion-culling").occlusionCulling);
    const render::RenderOptions both = optionsOf("anchored/gpu-driven/occlusion-culling");
    EXPECT_TRUE(both.occlusionCulling && both.submission == render::Submission::gpuDriven);
    EXPECT_EQ(optionsOf("cdr-5/accumulate").targets, render::parseTargets("accumulate"));
    EXPECT_EQ(timingModesNamed({"cdr-5/accumulate"}).back().name, "cdr-5/accumulate");
    for (const char* unknown : {"standard/", "/visibility", "standard/fast", "standard//lit",
                                "standard/lit/visibility", "log/lit/lit"}) {
        EXPECT_THROW(timingModesNamed({unknown}), InputError) << unknown;
    }
    EXPECT_EQ(optionsOf("standard"),
              render::RenderOptions{.technique = cdr::depth::parseTechnique("standard")});
}

TEST(TimingModes, AnOverheadIsSeenOnlyBesideTheNoise) {
    using cdr::measure::Interval;
    const Interval floor{-1.0, 1.0};
    EXPECT_FALSE(liesApart(Interval{-0.5, 2.0}, floor));
    EXPECT_FALSE(liesApart(Interval{1.0, 2.0}, floor));
    EXPECT_TRUE(liesApart(Interval{1.1, 2.0}, floor));
    EXPECT_TRUE(liesApart(Interval{-3.0, -1.1}, floor));
    EXPECT_FALSE(liesApart(Interval{0.0, 0.0}, Interval{0.2, 0.5})) << "standard over itself is no overhead";
    EXPECT_FALSE(liesApart(Interval{-0.4, -0.3}, Interval{0.2, 0.5}));
    EXPECT_FALSE(liesApart(Interval{0.6, 0.9}, Interval{-1.0, 0.2}));
    EXPECT_FALSE(liesApart(std::nullopt, floor));
    EXPECT_FALSE(liesApart(Interval{1.1, 2.0}, std::nullopt));
}

TEST(TimingModes, APlotLeavesOutIntervalsThatDoNotExist) {
    std::vector<TimingResult> results(3);
    results[1].mode.name = "standard-again";
    results[2].mode.name = "log";
    results[2].overheadPercent = 5.0;
    const std::string without = timingPlot(results, "a device");
    EXPECT_NE(without.find("2 \"log\" 5 NaN NaN NaN\n"), std::string::npos) << without;
    EXPECT_EQ(without.find("rectangle"), std::string::npos);
    EXPECT_EQ(without.find("noise"), std::string::npos);
    EXPECT_NE(without.find("set yrange [*<0:0<*]\n"), std::string::npos) << "bars begin at 0";
    results[1].overheadPercent95 = {.low = -1.0, .high = 1.5};
    results[2].overheadPercent95 = {.low = 4.0, .high = 6.5};
    const std::string with = timingPlot(results, "a device");
    EXPECT_NE(with.find("2 \"log\" 5 4 6.5 NaN\n"), std::string::npos) << with;
    EXPECT_NE(with.find("first -1 to graph 1, first 1.5"), std::string::npos) << with;
}

TEST(TimingModes, RivalsFollowADepthTestThatShadesAsLittle) {
    EXPECT_TRUE(rivalTimingModes({}).empty());
    const std::vector<TimingMode> modes = rivalTimingModes({cdr::rivals::parseRival("two-float/prepass")});
    ASSERT_EQ(modes.size(), 2u);
    EXPECT_EQ(modes[0].name, "standard/ids");
    EXPECT_TRUE(modes[0].idsAlone && !modes[0].isRival());
    EXPECT_EQ(modes[1].name, "two-float/prepass");
    EXPECT_TRUE(modes[1].isRival());
}

TEST(Scaling, ThreadStepsReachTwiceTheCpus) {
    EXPECT_EQ(threadSteps(1), (std::vector<std::size_t>{1, 2}));
    EXPECT_EQ(threadSteps(2), (std::vector<std::size_t>{1, 2, 3, 4}));
    EXPECT_EQ(threadSteps(5), (std::vector<std::size_t>{1, 2, 3, 4, 5, 6, 8, 10}));
    EXPECT_EQ(threadSteps(8), (std::vector<std::size_t>{1, 2, 3, 4, 6, 8, 12, 16}));
    for (const std::size_t cpus : {128u, 129u, 400u}) { // no pool has more threads
        EXPECT_EQ(threadSteps(cpus).back(), cdr::platform::WorkerPool::kMaxThreads);
    }
}

TEST(Scaling, UnusableOptionsAreRefused) {
    const auto refused = [](const std::function<void(ScalingOptions&)>& spoil) {
        ScalingOptions options;
        spoil(options);
        EXPECT_THROW(requireUsable(options), InputError);
    };
    EXPECT_NO_THROW(requireUsable({}));
    refused([](ScalingOptions& o) { o.draws = {10, 0}; });
    refused([](ScalingOptions& o) { o.draws = {}; });
    refused([](ScalingOptions& o) { o.threads = {1, 257}; });
    refused([](ScalingOptions& o) { o.cascades = {65}; });
    refused([](ScalingOptions& o) { o.targets = {}; });
    refused([](ScalingOptions& o) { o.submissions = {}; });
    refused([](ScalingOptions& o) { o.repeats = 0; });
}

} // namespace
