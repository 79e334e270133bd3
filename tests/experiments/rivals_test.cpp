#include "../support/refusal.h"
#include "../support/shared_device.h"

#include <experiments/rivals/rivals.h>
#include <scenes/open_scene.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using namespace cdr;
using namespace cdr::experiments;

class RivalsExperiment : public cdr::test::DeviceTest {
  protected:
    RivalsReport measure(const RivalsOptions& options, const std::vector<std::string>& names = {"mixed"}) {
        std::vector<NamedScene> scenes;
        for (const std::string& name : names) {
            scenes.push_back({name, scenes::openScene(name, options.seed).setup});
        }
        return runRivals(device(), scenes, options, {});
    }

    static RivalsOptions small() {
        RivalsOptions options;
        options.distancesView = {};
        options.width = 320;
        options.height = 180;
        options.frames = 2;
        return options;
    }

    /// What a contender came to; a default row where it took no part.
    template <typename Row>
    static Row of(const std::vector<Row>& rows, const std::string& contender) {
        const auto found = std::find_if(rows.begin(), rows.end(),
                                        [&](const Row& row) { return row.contender == contender; });
        return found != rows.end() ? *found : Row{};
    }

    std::string refusalOf(const RivalsOptions& options, const std::string& scene = "mixed") {
        return cdr::test::inputErrorOf([&] { measure(options, {scene}); }, "none");
    }
};

TEST_F(RivalsExperiment, TodaysPracticeAndRivalsAreHeldAgainstOneTruth) {
    const RivalsReport report = measure(small());
    ASSERT_EQ(report.scenes.size(), defaultContenders(device().info()).size());
    const RivalScene anchored = of(report.scenes, "anchored");
    EXPECT_LT(anchored.wrong.fraction(), 0.02); // 0 where vertices are not snapped
    EXPECT_EQ(anchored.ratio, 1.0);
    EXPECT_GT(anchored.cascades, 1u);
    EXPECT_GT(of(report.scenes, "standard").wrong.fraction(), 0.5);
    for (const RivalScene& row : report.scenes) {
        EXPECT_EQ(row.wrong.pixels, anchored.wrong.pixels) << row.contender;
        EXPECT_EQ(row.frames, 1u) << row.contender; // the scene stands still
        EXPECT_GT(row.frameMs, row.executeMs) << row.contender;
        EXPECT_GT(row.ratio, 0.0) << row.contender;
        if (row.isRival) {
            EXPECT_EQ(row.cascades, 1u) << row.contender;
        }
    }
    ASSERT_EQ(report.wholeFrames.size(), 1u);
    EXPECT_GT(report.wholeFrames.front().ratio, 0.0); // a busy machine decides how far above 1
    EXPECT_EQ(report.needs.size(), report.scenes.size());
    EXPECT_TRUE(of(report.needs, "anchored").features.empty());
    EXPECT_EQ(of(report.needs, "anchored").bytesPerPixel, 12u);
    if (!device().info().hasInt64Atomics) {
        leaveOut("64-bit atomics");
        return;
    }
    EXPECT_EQ(of(report.needs, "object-anchors").geometryPasses, 2u);
    EXPECT_EQ(of(report.scenes, "object-anchors").wrong.wrong, 0u);
    EXPECT_GT(of(report.scenes, "two-float").wrong.wrong, 0u);
}

/// Equal cubes are rounded alike, so a distance from the object tells them apart at a gap below what it tells of others.
TEST_F(RivalsExperiment, UnlikePairsResolveCoarserThanEqualOnes) {
    RivalsOptions options = small();
    options.distancesView = {1e3};
    options.width = 1280;
    options.height = 720;
    options.contenders = {{"anchored", depth::parseTechnique("anchored")},
                          {"reversed", depth::parseTechnique("reversed")}};
    if (!device().info().hasInt64Atomics || !device().info().hasFragmentStores) {
        leaveOut("64-bit atomics");
        return;
    }
    options.contenders.push_back({"object-anchors", rivals::parseRival("object-anchors").rival});
    const RivalsReport report = measure(options, {});
    const RivalResolved anchored = of(report.resolved, "anchored");
    const RivalResolved rival = of(report.resolved, "object-anchors");
    ASSERT_TRUE(anchored.unlikeView && anchored.resolvedView && rival.unlikeView && rival.resolvedView);
    EXPECT_EQ(anchored.ratio, 1.0);
    EXPECT_GT(of(report.resolved, "reversed").ratio.value_or(0.0), 10.0);
    EXPECT_LT(*rival.resolvedView, 0.1 * *anchored.resolvedView);
    EXPECT_GT(*rival.unlikeView, 10.0 * *rival.resolvedView);
}

TEST_F(RivalsExperiment, WhatCannotBeComparedIsRefused) {
    RivalsOptions options = small();
    options.contenders = {{"reversed", depth::parseTechnique("reversed")}};
    EXPECT_NE(refusalOf(options).find("anchored"), std::string::npos);
    options = small();
    options.distancesView = {0.0};
    EXPECT_NE(refusalOf(options).find("distance"), std::string::npos);
    EXPECT_NE(refusalOf(small(), "coplanar").find("layer offsets"), std::string::npos);
    options = small();
    options.frames = 0;
    EXPECT_NE(refusalOf(options).find("frame"), std::string::npos);
}

} // namespace
