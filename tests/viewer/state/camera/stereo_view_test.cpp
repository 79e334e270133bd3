#include "../frames.h"

#include <viewer/state/camera/stereo_view.h>
#include <viewer/state/command_line.h>

#include <gtest/gtest.h>
#include <options/views/views_plan.h>

#include <limits>

namespace cdr::viewer {

namespace {

using options::StereoPicture;

TEST(StereoViewTest, StepsThroughOneEyeTwoAndAnAnaglyph) {
    const ViewSettings one;
    EXPECT_FALSE(stereoPictureOf(one));
    const ViewSettings beside = withNextStereo(one, {61.234});
    EXPECT_EQ(stereoPictureOf(beside), StereoPicture::sideBySide);
    EXPECT_EQ(beside.views.converge, 61.2);
    EXPECT_EQ(beside.views.eyeDistance, 2.04);
    const ViewSettings anaglyph = withNextStereo(withOtherEyes(beside, {5.0}), {5.0});
    EXPECT_EQ(stereoPictureOf(anaglyph), StereoPicture::anaglyph);
    EXPECT_EQ(anaglyph.views.stereo, scene::StereoMode::toedIn);
    EXPECT_EQ(anaglyph.views.converge, 61.2); // fitted once
    EXPECT_EQ(withNextStereo(anaglyph, {5.0}), one);
    EXPECT_EQ(withOtherEyes(one, {5.0}), one);
    EXPECT_EQ(withOtherEyes(withOtherEyes(withOtherEyes(beside, {5.0}), {5.0}), {5.0}), beside);
}

TEST(StereoViewTest, EyesOfTheCommandLineComeBackAfterOne) {
    ViewSettings given;
    given.views = {.kind = {}, .stereo = scene::StereoMode::offAxis, .eyeDistance = 0.3, .converge = 9.0};
    given.givenEyes = given.views;
    ViewSettings settings = withNextStereo(withNextStereo(given, {61.2}), {61.2});
    EXPECT_EQ(settings.views, options::ViewsArguments{});
    settings = withNextStereo(settings, {61.2});
    EXPECT_EQ(settings, given);
    fitEyes(settings, {30.0}); // a person's last word
    settings = withStereo(withStereo(settings, {}, {30.0}), StereoPicture::anaglyph, {60.0});
    EXPECT_EQ(settings.views.converge, 60.0);
    EXPECT_EQ(settings.views.eyeDistance, 2.0);
}

TEST(StereoViewTest, FitsEyesToOneUnitWhereNothingIsSeen) {
    for (const double nothing : {0.0, -3.0, std::numeric_limits<double>::infinity(), std::nan("")}) {
        EXPECT_EQ(withNextStereo({}, {nothing}).views.converge, 1.0) << nothing;
    }
}

TEST(StereoViewTest, EyesOfANarrowLensBothSeeWhatIsLookedAt) {
    for (const double fovY : {1.0, 0.1, 1e-3, 1e-9}) {
        const ViewSettings beside = withNextStereo({}, {.surfaceView = 1e6, .fovY = fovY});
        const options::ViewsPlan plan(beside.views, 320, 360);
        const scene::Camera camera{.fovY = fovY, .nearView = 1.0, .farView = 1e7};
        EXPECT_NO_THROW(plan.camerasOf(camera)) << fovY;
    }
}

TEST(StereoViewTest, EyesThatTurnInHaveADistanceToTurnTo) {
    ViewSettings settings;
    settings.views = {
        .kind = {}, .stereo = scene::StereoMode::parallel, .eyeDistance = 0.065, .converge = {}};
    settings.givenEyes = settings.views;
    const ViewSettings given = settings;
    for (std::size_t i = 0; i < scene::kStereoModes.size(); ++i) {
        EXPECT_NO_THROW(options::ViewsPlan(settings.views, 320, 360)) << i;
        EXPECT_EQ(settings.views.converge, i == 0 ? std::nullopt : std::optional(61.2)) << i;
        settings = withOtherEyes(settings, {.surfaceView = 61.234});
    }
    EXPECT_EQ(settings, given);
}

TEST(StereoViewTest, EyesBesideEachOtherShareTheWidth) {
    const ViewSettings beside = withNextStereo({}, {10.0});
    EXPECT_EQ(renderOptions(beside, 0, {641, 360}).width, 320u);
    EXPECT_EQ(renderOptions(withNextStereo(beside, {10.0}), 0, {641, 360}).width, 641u);
    EXPECT_EQ(renderOptions(beside, 0, {1, 360}).width, 1u);
    render::Frame frame = viewer_test::makeFrame(8, 4, [](auto, auto) { return viewer_test::MadePixel{}; });
    EXPECT_EQ(middleOf(frame), glm::dvec2(4.0, 2.0));
    frame.views.resize(2);
    EXPECT_EQ(middleOf(frame), glm::dvec2(2.0, 2.0));
    EXPECT_EQ(columnsShown(beside, frame), 8u);
    EXPECT_EQ(columnsShown(withNextStereo(beside, {10.0}), frame), 4u);
}

TEST(StereoViewTest, ACursorIsInThePictureOfOneEye) {
    const ViewSettings beside = withNextStereo({}, {10.0});
    const PictureExtent whole{641, 360};
    EXPECT_EQ(extentOfEye(beside, whole), (PictureExtent{320, 360}));
    EXPECT_EQ(extentOfEye({}, whole), whole);
    EXPECT_EQ(extentOfEye(beside, {1, 360}), (PictureExtent{1, 360}));
    EXPECT_EQ(inEye(beside, whole, {319.5, 7.0}), glm::dvec2(319.5, 7.0));
    EXPECT_EQ(inEye(beside, whole, {330.0, 7.0}), glm::dvec2(10.0, 7.0));
    EXPECT_EQ(inEye(beside, whole, {640.5, 7.0}), glm::dvec2(319.5, 7.0))
        << "beyond both, as an odd width leaves a column";
    EXPECT_EQ(inEye({}, whole, {330.0, 7.0}), glm::dvec2(330.0, 7.0));
    EXPECT_EQ(inEye(beside, whole, kNoCursor), kNoCursor);
}

TEST(StereoViewTest, TheCopiedLineSaysTheEyes) {
    ReproducedView view{.settings = withNextStereo({}, {30.0}),
                        .side = 0,
                        .camera = {},
                        .sceneCamera = {},
                        .extent = {320, 360}};
    EXPECT_NE(renderCommand(view).find("--stereo=parallel --eye-distance=1 --converge=30 --size=320x360"),
              std::string::npos)
        << renderCommand(view);
    view.settings = withNextStereo(view.settings, {30.0});
    EXPECT_NE(renderCommand(view).find("--stereo-picture=anaglyph"), std::string::npos);
    view.settings.view = ViewKind::ids; // of which there is no anaglyph
    EXPECT_EQ(renderCommand(view).find("--stereo-picture"), std::string::npos);
}

} // namespace

} // namespace cdr::viewer
