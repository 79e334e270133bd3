#include <viewer/state/requests/next_request.h>

#include <gtest/gtest.h>

namespace cdr::viewer {

namespace {

Wanted wantedOf(const depth::Technique& technique = depth::parseTechnique("standard")) {
    Wanted wanted{.request = {}, .isThreadReady = true};
    wanted.request.camera = scene::Camera{};
    wanted.request.settings.technique = technique;
    return wanted;
}

TEST(NextRequest, TheFirstAsksForAllThatAStillPictureHas) {
    Wanted wanted = wantedOf();
    wanted.isThreadReady = false;
    const auto first = decide(nullptr, wanted);
    ASSERT_TRUE(first);
    EXPECT_TRUE(first->wantsSurfaces);
    EXPECT_TRUE(first->countsWrong);
    EXPECT_FALSE(first->isAtRest);
}

TEST(NextRequest, NothingIsAskedForTwice) {
    const Wanted wanted = wantedOf();
    const auto first = decide(nullptr, wanted);
    EXPECT_FALSE(decide(&*first, wanted));
}

TEST(NextRequest, EachThingThatIsShownIsAskedForAtOnce) {
    const Wanted wanted = wantedOf();
    const auto first = decide(nullptr, wanted);
    const auto asksAfter = [&](auto change) {
        Wanted changed = wanted;
        changed.isThreadReady = false;
        change(changed.request);
        return decide(&*first, changed).has_value();
    };
    EXPECT_FALSE(asksAfter([](RenderRequest&) {}));
    EXPECT_FALSE(asksAfter([](RenderRequest& request) { request.serial = 9; }));
    EXPECT_TRUE(asksAfter([](RenderRequest& request) { request.camera->position.x = 1.0; }));
    EXPECT_TRUE(asksAfter([](RenderRequest& request) { request.frame = 1; }));
    EXPECT_TRUE(asksAfter([](RenderRequest& request) { request.settings.drawing.threads = 2; }));
    EXPECT_TRUE(asksAfter([](RenderRequest& request) { ++request.extent.width; }));
}

TEST(NextRequest, SurfacesAndCountsWaitUntilNothingMoves) {
    Wanted wanted = wantedOf();
    wanted.isFlying = true;
    const auto moving = decide(nullptr, wanted);
    EXPECT_FALSE(moving->wantsSurfaces);
    EXPECT_FALSE(moving->countsWrong);
    EXPECT_FALSE(decide(&*moving, wanted));
    wanted.surfacesAreDue = true;
    EXPECT_TRUE(decide(&*moving, wanted)->wantsSurfaces);
    EXPECT_FALSE(decide(&*moving, wanted)->countsWrong);

    wanted = wantedOf();
    wanted.isThreadReady = false;
    EXPECT_FALSE(decide(&*moving, wanted)) << "what is lacking waits for the thread";
    wanted.isThreadReady = true;
    const auto still = decide(&*moving, wanted);
    ASSERT_TRUE(still);
    EXPECT_TRUE(still->countsWrong);
    EXPECT_FALSE(decide(&*still, wanted));
}

TEST(NextRequest, FittedSplitsAreDrawnOnceMoreAtRest) {
    Wanted wanted = wantedOf(depth::parseTechnique("anchored"));
    const auto first = decide(nullptr, wanted);
    EXPECT_FALSE(first->isAtRest);
    const auto rest = decide(&*first, wanted);
    ASSERT_TRUE(rest);
    EXPECT_TRUE(rest->isAtRest);
    EXPECT_FALSE(decide(&*rest, wanted));
    wanted.isFlying = true;
    EXPECT_FALSE(decide(&*first, wanted)) << "in flight there is no rest";
}

TEST(NextRequest, RenderingAlwaysAsksWheneverTheThreadIsReady) {
    Wanted wanted = wantedOf();
    wanted.rendersAlways = true;
    const auto first = decide(nullptr, wanted);
    EXPECT_FALSE(first->wantsSurfaces);
    EXPECT_FALSE(first->countsWrong);
    EXPECT_TRUE(decide(&*first, wanted));
    wanted.isThreadReady = false;
    EXPECT_FALSE(decide(&*first, wanted));
}

TEST(NextRequest, FlipsFadeAtRestUntilNoneIsLeft) {
    EXPECT_FALSE(fades(nullptr));
    RenderResult shown;
    EXPECT_FALSE(fades(&shown));
    shown.sides.resize(2);
    EXPECT_FALSE(fades(&shown));
    shown.sides[1].flippedPixels = 1;
    EXPECT_TRUE(fades(&shown));
}

} // namespace

} // namespace cdr::viewer
