#include <viewer/state/first_steps.h>
#include <viewer/state/tour.h>

#include <gtest/gtest.h>

namespace cdr::viewer {

namespace {

TEST(FirstSteps, EachGoesWhenItIsDone) {
    FirstSteps steps;
    ViewSettings settings;
    scene::Camera camera;
    EXPECT_FALSE(steps.text()); // nobody asked
    steps.begin();
    steps.see(settings, camera);
    EXPECT_EQ(steps.text()->substr(0, 6), "1 of 3");
    camera.position.x = 1.0; // not what was asked for
    steps.see(settings, camera);
    EXPECT_EQ(steps.text()->substr(0, 6), "1 of 3");
    settings.divider = 0.4;
    steps.see(settings, camera);
    EXPECT_EQ(steps.text()->substr(0, 6), "2 of 3");
    camera.position.x = 2.0;
    steps.see(settings, camera);
    EXPECT_EQ(steps.text()->substr(0, 6), "3 of 3");
    settings.view = ViewKind::wrong;
    steps.see(settings, camera);
    EXPECT_FALSE(steps.text());
}

TEST(FirstSteps, CanBeSkipped) {
    FirstSteps steps;
    steps.begin();
    steps.end();
    EXPECT_FALSE(steps.text());
}

TEST(Tour, EndsOnItsLastFrameAndSaysAnotherThingOnTheWay) {
    EXPECT_EQ(tourFrame(0.0, 240), 0u);
    EXPECT_EQ(tourFrame(0.5 * kTourSeconds, 241), 120u);
    EXPECT_EQ(tourFrame(kTourSeconds, 240), 239u);
    EXPECT_EQ(tourFrame(1e9, 240), 239u);
    EXPECT_NE(tourCaption(60.0), tourCaption(5.0));
    EXPECT_NE(tourCaption(0.01), tourCaption(0.002));
}

} // namespace

} // namespace cdr::viewer
