#include "viewer_run.h"

#include <cdr/scene/camera.h>
#include <cdr/scene/camera_recording.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

namespace cdr::viewer_test {

namespace {

namespace fs = std::filesystem;

glm::dvec3 vectorOf(const std::string& text) {
    glm::dvec3 vector(0.0);
    EXPECT_EQ(std::sscanf(text.c_str(), "%lf,%lf,%lf", &vector.x, &vector.y, &vector.z), 3) << text;
    return vector;
}

/// Where a picture of that size, taken by the camera, shows a position: pixels.
glm::dvec2 pixelOf(const scene::Camera& camera, const glm::dvec3& position, double width, double height) {
    const glm::dvec3 view = camera.toView(position);
    const double unit = height / (2.0 * std::tan(camera.fovY / 2.0));
    return {width / 2.0 + unit * view.x / -view.z, height / 2.0 - unit * view.y / -view.z};
}

/// Plays a script of that folder in a folder that is gone. Root may write into any other.
RunResult playInGoneFolder(const fs::path& folder, const std::string& script,
                           const std::string& environment) {
    std::ofstream(folder / "script") << script;
    fs::create_directory(folder / "gone");
    return runShell("(cd gone && rmdir ../gone && '" CDR_VIEWER_DRIVE
                    "' --validate --size 560x300 --script " +
                        (folder / "script").string() + " cubes)",
                    folder, environment);
}

TEST_F(ViewerTest, PicksFromThePictureThatWasClickedOn) {
    std::string script = "wait-frame 3\nmove 106 150\n";
    constexpr int kClicks = 8;
    for (int i = 0; i < kClicks; ++i) {
        // By the third frame from then the click is answered: one was being drawn, one is the click's own.
        script += "press\nrelease\nwait-frame 3\nstate\nkey X\nwait-ui 1\n";
    }
    const RunResult run = play("--size 560x300 --technique anchored --play afc", script + "quit\n");
    const auto states = run.states(kClicks);
    int hits = 0;
    for (const std::string& state : states) {
        if (valueOf(state, "picked").empty()) {
            continue; // between the cubes
        }
        ++hits;
        scene::Camera camera;
        camera.fovY = scene::radiansOf(std::stod(valueOf(state, "fov")));
        camera = scene::lookAlong(camera, vectorOf(valueOf(state, "clicked-from")),
                                  vectorOf(valueOf(state, "clicked-along")));
        const glm::dvec2 pixel = pixelOf(camera, vectorOf(valueOf(state, "picked-at")), 212.0, 300.0);
        EXPECT_NEAR(pixel.x, 106.5, 0.51) << state;
        EXPECT_NEAR(pixel.y, 150.5, 0.51) << state;
    }
    EXPECT_GE(hits, 2);
    EXPECT_NE(valueOf(states.front(), "clicked-from"), valueOf(states.back(), "clicked-from"));
}

/// How far from the eye lies what an orbit goes around.
double ahead(const std::string& state) {
    return glm::length(vectorOf(valueOf(state, "pivot")) - vectorOf(valueOf(state, "eye")));
}

TEST_F(ViewerTest, OrbitsWhatItLooksAtAMillionUnitsAway) {
    const RunResult run =
        play("--size 560x300 --technique standard afc", "wait-frame\nstate\nkey O\nstate\nquit\n");
    const auto states = run.states(2);
    EXPECT_NEAR(ahead(states[0]), 1e6, 1e5) << states[0];
}

/// The distance to what was in view before would be a false one.
TEST_F(ViewerTest, OrbitsWhatItLooksAtAfterHome) {
    const RunResult run =
        play("--size 240x160 --technique anchored cubes",
             "wait-frame\nstate\nkey O\nmove 120 80\nscroll 40\nwait-ui 1\nwait-frame\nstate\nkey home\n"
             "wait-frame\nstate\npress\nmove 160 80\nwait-ui 1\nrelease\nwait-frame\nstate\nquit\n");
    const auto states = run.states(4);
    EXPECT_NEAR(ahead(states[0]), 12e3, 1.2e3) << states[0];
    ASSERT_EQ(valueOf(states[2], "eye"), valueOf(states[0], "eye"));
    EXPECT_LT(ahead(states[1]), 0.1 * ahead(states[0])) << "it has not gone nearer: " << states[1];
    EXPECT_EQ(valueOf(states[2], "orbits"), "1");
    EXPECT_NEAR(ahead(states[2]), ahead(states[0]), 0.01 * ahead(states[0])) << states[2];
    EXPECT_NE(valueOf(states[3], "eye"), valueOf(states[2], "eye")) << "it has not turned";
    EXPECT_NE(valueOf(states[3], "draws"), "0") << "the scene is lost: " << states[3];
}

TEST_F(ViewerTest, RecordsOneCameraAtRestAndNothingBeforeAScene) {
    const RunResult run = play("--size 560x300 --technique standard cubes",
                               "key R\nkey R\nwait-frame\nkey R\nkey R\nwait-ui 1\nstate\nkey P\nwait-frame\n"
                               "wait-state motion=free\nwait-frame\nstate\nkey R\nkey P\nkey R\nwait-ui 20\n"
                               "key R\nwait-ui 1\nstate\nquit\n");
    const auto states = run.states(3);
    EXPECT_EQ(valueOf(states[1], "eye"), valueOf(states[0], "eye"));
    // The same camera for 20 frames: the two ends tell all.
    ASSERT_TRUE(fs::exists(folder() / "camera-path-0002.json"));
    EXPECT_LE(scene::readRecording(folder() / "camera-path-0002.json").cameras.size(), 2u);
}

TEST_F(ViewerTest, RecordsAnewWhileItPlays) {
    const RunResult run = play("--size 560x300 --technique standard cubes",
                               "wait-frame\nkey R\nhold D\nwait-ui 60\nlet D\nkey R\nkey P\nwait-state "
                               "motion=recording\nkey R\nwait-state motion=free\nwait-ui 5\nkey R\nwait-ui "
                               "2\nstate\nquit\n");
    const auto cameras = scene::readRecording(folder() / "camera-path-0001.json").cameras;
    ASSERT_GE(cameras.size(), 2u);
    EXPECT_LE(static_cast<double>(cameras.size()), 3.0 + 30.0 * cameras.back().seconds) << "one a frame";
}

TEST_F(ViewerTest, SavesARecordingThatTheEndOfTheWindowEnds) {
    play("--size 560x300 --technique standard cubes", "wait-frame\nkey R\nhold D\nwait-ui 30\nlet D\nquit\n");
    ASSERT_TRUE(fs::exists(folder() / "camera-path-0001.json"));
    EXPECT_GE(scene::readRecording(folder() / "camera-path-0001.json").cameras.size(), 2u);
}

TEST_F(ViewerTest, EndsARecordingWhereAnotherSceneIsShown) {
    const std::string other = CDR_SOURCE_DIR "/tests/fuzz/seeds/gltf/moving_camera.gltf";
    play("--size 560x300 --technique standard cubes",
         "wait-frame\nkey R\nwait-ui 5\ndrop " + other + "\nwait-frame\nwait-ui 2\nkey R\nwait-ui 5\nquit\n");
    ASSERT_TRUE(fs::exists(folder() / "camera-path-0002.json")) << "the first went on";
    EXPECT_EQ(scene::readRecording(folder() / "camera-path-0001.json").scene, "cubes");
    EXPECT_EQ(scene::readRecording(folder() / "camera-path-0002.json").scene, other);
}

/// The tour is of one scene. Another one's camera stays where it is.
TEST_F(ViewerTest, ATourEndsWhereAnotherSceneIsOpened) {
    fs::copy_file(CDR_SOURCE_DIR "/tests/golden/shapes.gltf", folder() / "m.gltf");
    const RunResult run = play(
        "--size 300x200 cubes",
        "wait-frame\nkey T\nwait-ui 2\nstate\ndrop m.gltf\nwait-state shown=m.gltf\nwait-ui 2\nstate\nquit\n");
    const auto states = run.states(2);
    EXPECT_EQ(valueOf(states[0], "motion"), "tour") << states[0];
    EXPECT_EQ(valueOf(states[1], "shown"), "m.gltf") << states[1];
    EXPECT_EQ(valueOf(states[1], "motion"), "free") << states[1];
}

/// It is not the tour's scene that failed.
TEST_F(ViewerTest, ATourGoesOnAfterAFileThatDoesNotOpen) {
    std::ofstream(folder() / "broken.gltf") << "{";
    const RunResult run = play("--size 300x200 cubes", "wait-frame\nkey T\nwait-state shown=orbit\n"
                                                       "drop broken.gltf\nwait-state scene=broken.gltf\n"
                                                       "wait-state scene=orbit\nwait-ui 3\nstate\nquit\n");
    const auto states = run.states(1);
    EXPECT_EQ(valueOf(states[0], "motion"), "tour") << states[0];
    EXPECT_NE(valueOf(states[0], "notice").find("broken.gltf"), std::string::npos) << states[0];
}

/// Levels of detail open the scene anew. It is the same scene for whoever looks at it.
TEST_F(ViewerTest, KeepsPivotAndPickedPointWhereItsSceneIsOpenedAnew) {
    const RunResult run = play("--size 748x500 --technique anchored coplanar",
                               "wait-frame\nwait-ui 3\nmove 278 242\nwait-ui 2\npress\nrelease\nwait-ui 2\n"
                               "wait-frame\nstate\nclick Draw\nwait-ui 2\nclick detail\n"
                               "click detail=object\nwait-ui 2\nwait-frame\nstate\nquit\n");
    const auto states = run.states(2);
    EXPECT_FALSE(valueOf(states[0], "picked").empty()) << states[0];
    for (const char* kept : {"picked", "picked-at", "pivot", "eye"}) {
        EXPECT_EQ(valueOf(states[1], kept), valueOf(states[0], kept)) << kept;
    }
}

/// Wrong pixels are counted against a picture of the best technique, which takes as long again.
TEST_F(ViewerTest, CountsWrongPixelsOnceADragEnds) {
    const RunResult run =
        play("--size 300x200 cubes",
             "wait-frame\nmove 100 150\npress\nmove 115 140\nmove 130 130\nwait-frame\nstate\n"
             "release\nwait-frame\nstate\nquit\n");
    const auto states = run.states(2);
    EXPECT_EQ(valueOf(states[0], "wrong"), "") << states[0];
    EXPECT_NE(valueOf(states[1], "wrong"), "") << states[1];
    EXPECT_EQ(valueOf(states[1], "eye"), valueOf(states[0], "eye"));
}

/// The camera flies on while a file is opened again.
TEST_F(ViewerTest, StaysWhereItIsWhenAFileIsOpenedAgain) {
    fs::copy_file(CDR_SOURCE_DIR "/tests/golden/shapes.gltf", folder() / "m.gltf");
    const RunResult run =
        play("--size 300x200 m.gltf", "wait-frame\nmove 100 100\ndrop m.gltf\nscroll 3\nstate\n"
                                      "wait-ui 2\nwait-frame\nstate\nquit\n");
    const auto states = run.states(2);
    EXPECT_EQ(valueOf(states[1], "eye"), valueOf(states[0], "eye"));
}

TEST_F(ViewerTest, SaysWhoseARecordingIsThatPlaysInAnotherScene) {
    fs::copy_file(CDR_SOURCE_DIR "/tests/golden/shapes.gltf", folder() / "m.gltf");
    const RunResult run = play("--size 300x200 cubes",
                               "wait-frame\nkey R\nwait-ui 5\nkey R\nwait-ui 1\nkey P\nwait-ui 1\nstate\n"
                               "drop m.gltf\nwait-state shown=m.gltf\nkey P\nwait-ui 1\nstate\nquit\n");
    const auto states = run.states(2);
    EXPECT_EQ(valueOf(states[0], "notice").find("recorded in"), std::string::npos) << states[0];
    EXPECT_NE(valueOf(states[1], "notice").find("recorded in cubes"), std::string::npos) << states[1];
}

TEST_F(ViewerTest, SaysThatAFolderCannotBeWritten) {
    const RunResult run = playInGoneFolder(
        folder(),
        "wait-frame\nkey F12\nwait-ui 2\nstate\nkey F12 shift\nwait-ui 3\nstate\nkey R\nwait-ui 2\nkey R\n"
        "wait-ui 1\nstate\nkey 6\nwait-frame\nstate\nquit\n",
        environment());
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.err, "");
    const auto states = run.states(4);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NE(valueOf(states[i], "notice").find("cannot "), std::string::npos) << states[i];
    }
    EXPECT_EQ(valueOf(states[3], "technique"), "anchored,") << "it goes on";
}

/// Before a path is flown that would be lost.
TEST_F(ViewerTest, RecordsNothingWhereAFolderCannotBeWritten) {
    const RunResult run =
        playInGoneFolder(folder(), "wait-frame\nkey R\nwait-ui 5\nstate\nquit\n", environment());
    EXPECT_NE(valueOf(run.states(1)[0], "notice").find("cannot "), std::string::npos) << run.out;
    EXPECT_EQ(run.status, 0) << run.err;
}

/// Files that may not grow stand for a disk that is full. When it ends, nobody sees a notice any more.
TEST_F(ViewerTest, FailsWhereItEndsWithARecordingThatCannotBeSaved) {
    std::ofstream(folder() / "script")
        << "wait-frame\nkey R\nhold D\nwait-ui 90\nlet D\nkey R\nwait-ui 2\nstate\nquit\n";
    const RunResult run = runShell("(trap '' XFSZ && ulimit -f 4 && '" CDR_VIEWER_DRIVE
                                   "' --size 560x300 --script script cubes)",
                                   folder(), environment());
    EXPECT_NE(valueOf(run.states(1)[0], "notice").find("write failed"), std::string::npos) << run.out;
    EXPECT_EQ(run.status, 1);
    EXPECT_NE(run.err.find("camera-path-0001.json"), std::string::npos) << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
}

/// Files that may not grow stand for a disk that is full. What the viewer itself prints is shorter.
TEST_F(ViewerTest, SaysThatAFileCannotBeWrittenToItsEnd) {
    std::ofstream(folder() / "script")
        << "wait-frame\nkey F12\nwait-ui 2\nstate\nkey F12 shift\nwait-ui 3\nstate\nkey 6\nwait-frame\nstate\nquit\n";
    const RunResult run =
        runShell("(trap '' XFSZ && ulimit -f 4 && '" CDR_VIEWER_DRIVE "' --size 560x300 --script " +
                     (folder() / "script").string() + " cubes)",
                 folder(), environment());
    EXPECT_EQ(run.status, 0) << run.err;
    const auto states = run.states(3);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_NE(valueOf(states[i], "notice").find("write failed"), std::string::npos) << states[i];
    }
    EXPECT_EQ(valueOf(states[2], "technique"), "anchored,") << "it goes on";
    EXPECT_FALSE(fs::exists(folder() / "cdr-window-0001.png"));

    const RunResult saved = runShell("(trap '' XFSZ && ulimit -f 4 && '" CDR_VIEWER_DRIVE
                                     "' --size 560x300 --frames 20 --screenshot w.png cubes)",
                                     folder(), environment());
    EXPECT_EQ(saved.status, 1) << saved.err;
    EXPECT_NE(saved.err.find("write failed"), std::string::npos) << saved.err;
}

TEST_F(ViewerTest, OpensTheSceneAmongWhatIsDropped) {
    fs::copy_file(CDR_SOURCE_DIR "/tests/golden/shapes.gltf", folder() / "shapes.gltf");
    std::ofstream(folder() / "notes.txt") << "no scene";
    const RunResult run = play("--size 560x300 --technique standard cubes",
                               "wait-frame\ndrop notes.txt\nwait-ui 2\nwait-frame\nstate\n"
                               "drop-all notes.txt shapes.gltf\nwait-state shown=shapes.gltf\nstate\nquit\n");
    const auto states = run.states(2);
    EXPECT_EQ(valueOf(states[0], "shown"), "cubes");
    EXPECT_NE(valueOf(states[0], "notice").find("notes.txt is no scene"), std::string::npos) << states[0];
    EXPECT_EQ(valueOf(states[1], "shown"), "shapes.gltf");
}

} // namespace

} // namespace cdr::viewer_test
