#include <cdr/base/error.h>
#include <viewer/state/animation/playback.h>

#include <gtest/gtest.h>

namespace cdr::viewer {

namespace {

scene::OpenedScene twoAnimations() {
    scene::OpenedScene scene;
    scene.animations = {{.name = "walk", .seconds = 2.0}, {.name = "run", .seconds = 3.0}};
    return scene;
}

/// Names come first, as for `--animation`.
TEST(Playback, ChoosesAnimationsWhoseNamesAreNumbers) {
    scene::OpenedScene scene;
    scene.animations = {{.name = "1", .seconds = 2.0}, {.name = "0", .seconds = 3.0}, {.name = "#2"}, {}};
    for (int number = 0; number < 4; ++number) {
        const scene::GltfChoice choice = withAnimation({}, scene, number);
        EXPECT_EQ(chosenNumber(choice, scene), number) << *choice.animation;
    }
    EXPECT_EQ(withAnimation({}, scene, 1).animation, "#1");
    EXPECT_EQ(withAnimation({}, scene, 3).animation, "3");
    scene::GltfChoice choice;
    choice.framesPerSecond = 24.0;
    EXPECT_EQ(chosenNumber(choice, scene), 0) << "the first, not '0'";
    choice.animation = "1";
    EXPECT_EQ(chosenNumber(choice, scene), 0);
    EXPECT_FALSE(scene::animationOf(scene.animations, "4"));
    EXPECT_FALSE(scene::animationOf(scene.animations, "##1"));
    EXPECT_FALSE(scene::animationOf(scene.animations, "01"));
}

TEST(Playback, PlaysOnlyWhilePlaying) {
    Playback playback{.isPlaying = false, .loops = true, .speed = 2.0, .seconds = 0.5};
    playback.advance(0.25, 2.0);
    EXPECT_EQ(playback.seconds, 0.5);
    playback.isPlaying = true;
    playback.advance(0.25, 2.0);
    EXPECT_EQ(playback.seconds, 1.0);
}

TEST(Playback, LoopsOrStopsAtTheEnd) {
    Playback playback{.isPlaying = true, .loops = true, .speed = 1.0, .seconds = 1.5};
    playback.advance(1.0, 2.0);
    EXPECT_EQ(playback.seconds, 0.5);
    EXPECT_TRUE(playback.isPlaying);
    playback.loops = false;
    playback.advance(9.0, 2.0);
    EXPECT_EQ(playback.seconds, 2.0);
    EXPECT_FALSE(playback.isPlaying);
    playback = {.isPlaying = true, .loops = true, .speed = 1.0, .seconds = 0.0};
    playback.advance(1.0, 0.0); // nothing to play
    EXPECT_EQ(playback.seconds, 0.0);
    EXPECT_FALSE(playback.isPlaying);
}

/// Else it would stop at once.
TEST(Playback, BeginsAgainWhereItHasEnded) {
    Playback playback{.isPlaying = true, .loops = false, .speed = 1.0, .seconds = 1.5};
    playback.advance(1.0, 2.0);
    playback.toggle(2.0);
    EXPECT_TRUE(playback.isPlaying);
    EXPECT_EQ(playback.seconds, 0.0);
    playback.advance(0.5, 2.0);
    playback.toggle(2.0);
    EXPECT_FALSE(playback.isPlaying);
    playback.toggle(2.0);
    EXPECT_TRUE(playback.isPlaying);
    EXPECT_EQ(playback.seconds, 0.5) << "a pause is no end";
}

/// The frame number and the rate say the moment that the copied command line shows.
TEST(Playback, FramesNameTheMoment) {
    const scene::GltfChoice choice = withAnimation({}, twoAnimations(), 1);
    const Playback playback{.isPlaying = false, .loops = true, .speed = 1.0, .seconds = 1.234};
    EXPECT_EQ(playback.frame(choice), 1234u);
    EXPECT_NEAR(*scene::secondsAt(choice, playback.frame(choice)), 1.234, 1e-12);
    EXPECT_EQ(chosenNumber(choice, twoAnimations()), 1);
    EXPECT_EQ(playableSeconds(choice, twoAnimations()), 3.0);
    EXPECT_EQ(withAnimation(choice, twoAnimations(), -1), scene::GltfChoice{});
}

TEST(Playback, BeginsWhereTheCommandLineSays) {
    scene::GltfChoice choice;
    choice.seconds = 1.5;
    EXPECT_EQ(playbackOf(choice, 0).seconds, 1.5);
    EXPECT_FALSE(choice.animation || choice.seconds);
    EXPECT_EQ(choice.framesPerSecond, kPlaybackRate);
    EXPECT_EQ(chosenNumber(choice, twoAnimations()), 0);
    choice.animation = "run";
    choice.framesPerSecond = 10.0;
    choice.seconds = 1.0;
    const Playback playback = playbackOf(choice, 5);
    EXPECT_EQ(playback.seconds, 0.5);
    EXPECT_EQ(playback.frame(choice), 5u);
    EXPECT_EQ(chosenNumber(choice, twoAnimations()), 1);
    EXPECT_EQ(playableSeconds(choice, twoAnimations()), 2.0);
    EXPECT_EQ(playback.moment(choice), 1.5) << "of the animation, which --time begins after a second";
    scene::GltfChoice still;
    EXPECT_EQ(playbackOf(still, 7).seconds, 0.0);
    EXPECT_EQ(still, scene::GltfChoice{});
    EXPECT_EQ(chosenNumber(still, twoAnimations()), -1);
}

/// The moment that is set is the one that is shown, wherever `--time` begins.
TEST(Playback, GoesToTheAnimationsOwnTime) {
    scene::GltfChoice choice;
    choice.seconds = 1.0;
    choice.framesPerSecond = 10.0;
    Playback playback;
    playback.goTo(2.5, choice);
    EXPECT_EQ(playback.moment(choice), 2.5);
    EXPECT_EQ(scene::secondsAt(choice, playback.frame(choice)), 2.5);
    playback.goTo(0.5, choice); // before frame 0
    EXPECT_EQ(playback.moment(choice), 1.0);
    choice.seconds.reset();
    playback.goTo(0.5, choice);
    EXPECT_EQ(playback.moment(choice), 0.5);
}

/// Such a moment could not be played on from.
TEST(Playback, RefusesAFrameAtNoFiniteMoment) {
    scene::GltfChoice choice;
    choice.framesPerSecond = 1e-308;
    EXPECT_THROW(playbackOf(choice, 4294967295), base::InputError);
    EXPECT_EQ(playbackOf(choice, 0).seconds, 0.0);
}

} // namespace

} // namespace cdr::viewer
