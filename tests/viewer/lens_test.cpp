#include "viewer_run.h"

#include <cdr/base/error.h>
#include <cdr/scene/camera_recording.h>
#include <viewer/session/player.h>
#include <viewer/session/startup.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace cdr::viewer_test {

namespace {

const std::string kMovingCamera = CDR_SOURCE_DIR "/tests/fuzz/seeds/gltf/moving_camera.gltf";
const std::string kLens = "--fov 5 --near 0.25 --far 5e5 --lens-shift 0.125,0 ";

void expectLens(const std::string& line) {
    for (const char* option : {" --fov=5 ", " --near=0.25 ", " --far=500000 ", " --lens-shift=0.125,0 "}) {
        EXPECT_NE(line.find(option), std::string::npos) << option << line;
    }
}

/// As `cdr render` draws each frame.
TEST_F(ViewerTest, PlaysTheScenesPathThroughTheLensOfTheCommandLine) {
    const RunResult run = play("--size 560x300 --technique anchored --play " + kLens + "afc",
                               "wait-frame 3\nkey space\nwait-frame\ncommand\nquit\n");
    const auto lines = run.lines("cdr render");
    ASSERT_EQ(lines.size(), 1u) << run.out;
    EXPECT_NE(lines[0].find(" --direction="), std::string::npos) << "the path has not moved it: " << lines[0];
    expectLens(lines[0]);
}

TEST_F(ViewerTest, PlaysAnAnimatedCameraThroughTheLensOfTheCommandLine) {
    const RunResult run =
        play("--size 560x300 --technique anchored --camera 0 --time 0 " + kLens + kMovingCamera,
             "wait-frame\nkey K\nwait-ui 10\nkey K\nwait-frame\ncommand\nquit\n");
    const auto lines = run.lines("cdr render");
    ASSERT_EQ(lines.size(), 1u) << run.out;
    EXPECT_NE(lines[0].find(" --direction="), std::string::npos) << "it has not moved: " << lines[0];
    expectLens(lines[0]);
}

/// The line has neither --eye nor --direction where the camera is the file's own at its --frame.
TEST_F(ViewerTest, PlaysAnAnimatedCameraTogetherWithWhatMoves) {
    const RunResult run =
        play("--size 560x300 --technique anchored --camera 0 --animation 0 --play " + kMovingCamera,
             "wait-frame 3\nwait-ui 10\ncommand\nkey space\nwait-ui 2\nstate\nwait-ui 5\nstate\n"
             "key space\nwait-ui 5\nstate\nquit\n");
    const auto lines = run.lines("cdr render");
    ASSERT_EQ(lines.size(), 1u) << run.out;
    EXPECT_NE(lines[0].find(" --frame="), std::string::npos) << "it has not moved: " << lines[0];
    EXPECT_EQ(lines[0].find(" --direction="), std::string::npos) << lines[0];
    const auto states = run.states(3);
    EXPECT_EQ(valueOf(states[1], "time"), valueOf(states[0], "time")) << "space does not stop it";
    EXPECT_NE(valueOf(states[2], "time"), valueOf(states[1], "time")) << "space does not play it again";
}

/// moving_camera.gltf with the last of its key frames at 2e38 s. Dear ImGui takes half of the largest float at most.
TEST_F(ViewerTest, AnAnimationMayBeLongerThanASliderCanShow) {
    constexpr std::size_t kTimes = 48; // where the base64 of both times begins
    std::string text = test::readText(kMovingCamera);
    const std::string base64 = "base64,";
    const std::size_t at = text.find(base64) + base64.size() + kTimes;
    ASSERT_EQ(text.substr(at, 12), "AAAAAAAAgD8A");
    std::ofstream(folder() / "long.gltf") << text.replace(at, 12, "AAAAAJl2Fn8A");
    const RunResult run = play("--size 560x300 --technique anchored --camera 0 long.gltf",
                               "wait-frame\nkey K\nkey F3\nwait-ui 3\nwhere time\nquit\n");
    EXPECT_EQ(run.lines("time ").size(), 1u) << run.out;
}

TEST_F(ViewerTest, AnotherFilesAnimationBeginsAtItsBeginning) {
    std::filesystem::copy_file(kMovingCamera, folder() / "other.gltf");
    const RunResult run =
        play("--size 560x300 --technique anchored --animation 0 " + kMovingCamera,
             "wait-frame\nkey K\nwait-ui 30\nkey K\nwait-ui 2\nstate\n"
             "drop other.gltf\nwait-state shown=other.gltf\nwait-frame\nkey K\nwait-ui 2\nstate\nquit\n");
    const auto states = run.states(2);
    EXPECT_LT(std::stod(valueOf(states[1], "time")), 0.5 * std::stod(valueOf(states[0], "time"))) << run.out;
}

/// Until the scene's own camera is asked for again.
TEST_F(ViewerTest, AnAnimatedCameraIsSteeredAway) {
    const RunResult run =
        play("--size 560x300 --technique anchored --camera 0 --time 0 " + kMovingCamera,
             "wait-frame\nstate\nkey K\nwait-ui 10\nhold W\nwait-ui 5\nlet W\nwait-ui 5\nstate\n"
             "wait-ui 20\nstate\nkey K\nkey home\nwait-ui 5\nstate\nquit\n");
    const auto states = run.states(4);
    EXPECT_NE(valueOf(states[1], "eye"), valueOf(states[0], "eye"));
    EXPECT_EQ(valueOf(states[2], "eye"), valueOf(states[1], "eye")) << "the animation has moved it";
    EXPECT_NE(valueOf(states[3], "eye"), valueOf(states[2], "eye")) << "it does not follow again";
}

/// It takes an expression too, and 0 * infinity is no number.
TEST_F(ViewerTest, ASliderMovesTheAnimatedCameraAndTakesNothingThatIsNoNumber) {
    const std::string edit = "hold control\nclick time\nlet control\nwait-ui 2\n";
    const RunResult run =
        play("--size 1000x700 --technique anchored --camera 0 --time 0 " + kMovingCamera,
             "wait-frame\nclick Camera\nwait-ui 3\ncommand\nclick time\nwait-frame\ncommand\nstate\n" + edit +
                 "type 0\nkey enter\nwait-ui 3\nstate\n" + edit +
                 "type *1e39\nwait-ui 2\nkey enter\nwait-ui 3\nwait-frame\nstate\nquit\n");
    const auto lines = run.lines("cdr render");
    ASSERT_EQ(lines.size(), 2u) << run.out;
    EXPECT_EQ(lines[0].find(" --direction="), std::string::npos) << lines[0];
    EXPECT_NE(lines[1].find(" --direction=-0.99"), std::string::npos) << "half of half a turn: " << lines[1];
    const auto states = run.states(3);
    EXPECT_GT(std::stod(valueOf(states[0], "time")), 0.0) << states[0];
    EXPECT_EQ(valueOf(states[1], "time"), "0") << states[1];
    EXPECT_EQ(valueOf(states[2], "time"), "0") << states[2];
}

/// Opening takes far longer than a step of the window.
TEST_F(ViewerTest, PlaysARecordingFromItsBeginningOnceTheSceneIsOpen) {
    scene::CameraRecording recording{.scene = "cubes", .cameras = {}};
    for (const double seconds : {0.0, 1000.0}) { // the camera's place tells the time
        const scene::Camera camera = scene::lookAt({}, {seconds, 0.0, 10.0}, {seconds, 0.0, 0.0});
        ASSERT_TRUE(scene::record(recording, seconds, camera));
    }
    scene::writeRecording(folder() / "path.json", recording);
    const RunResult run = play("--size 240x180 --technique standard --path path.json cubes",
                               "wait-state shown=\nstate\nwait-ui 10\nstate\nquit\n");
    const std::vector<std::string> states = run.states(2);
    EXPECT_LE(std::stod(valueOf(states[0], "eye")), 2.1 * viewer::Player::kStepSeconds);
    EXPECT_GE(std::stod(valueOf(states[1], "eye")), 5.0 * viewer::Player::kStepSeconds);
}

TEST(Startup, ARecordingIsPlayedThroughTheLensOfTheCommandLine) {
    const test::TemporaryFolder folder;
    scene::CameraRecording recording{.scene = "afc", .cameras = {}};
    const scene::Camera first{.fovY = 1.0, .nearView = 0.1, .farView = 100.0};
    scene::Camera last = first;
    last.position.x = 2.0;
    last.fovY = 0.5;
    ASSERT_TRUE(scene::record(recording, 0.0, first));
    ASSERT_TRUE(scene::record(recording, 1.0, last));
    viewer::Arguments arguments;
    arguments.camera.path = (folder.path() / "path.json").string();
    scene::writeRecording(arguments.camera.path, recording);
    EXPECT_EQ(viewer::initialModel(arguments).camera.recorder.recording().cameras.at(1).camera, last);
    arguments.camera.fovDegrees = 5.0;
    arguments.camera.nearView = 0.25;
    const scene::CameraRecording played = viewer::initialModel(arguments).camera.recorder.recording();
    ASSERT_EQ(played.cameras.size(), 2u);
    for (const scene::RecordedCamera& recorded : played.cameras) {
        EXPECT_EQ(recorded.camera.fovY, scene::radiansOf(5.0));
        EXPECT_EQ(recorded.camera.nearView, 0.25);
        EXPECT_EQ(recorded.camera.farView, 100.0);
    }
    EXPECT_EQ(played.cameras[1].camera.position, last.position);
    arguments.camera.nearView = 200.0; // beyond far
    EXPECT_THROW(viewer::initialModel(arguments), base::InputError);
}

} // namespace

} // namespace cdr::viewer_test
