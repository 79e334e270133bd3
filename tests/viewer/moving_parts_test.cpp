#include "viewer_run.h"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

namespace cdr::viewer_test {

namespace {

/// The upper of two boxes that an animation has lifted away from where they lie at rest.
const std::string kMachine =
    "--size 560x300 --technique anchored --camera 0 --animation work --time 0.75 " CDR_SOURCE_DIR
    "/tests/assets/machine.glb";
const std::string kPickRider = "wait-frame\nmove 188 134\npress\nrelease\nwait-frame\n";

class MovingPartsOfTheViewer : public ViewerTest {};

TEST_F(MovingPartsOfTheViewer, AreFramedWhereTheyAre) {
    const RunResult run =
        play(kMachine, kPickRider + "key F\nwait-frame\nmove 106 150\nwait-frame\nwait-ui 2\nstate\nquit\n");
    const auto states = run.states(1);
    EXPECT_EQ(valueOf(states[0], "picked").substr(0, 6), "rider,") << states[0];
    EXPECT_EQ(valueOf(states[0], "under").substr(0, 6), "rider,")
        << "in the middle of the picture: " << states[0];
}

/// Pictures that follow each other come without surfaces, so a click has its picture drawn again. At rest the drop is there.
TEST_F(MovingPartsOfTheViewer, ArePickedWhereTheyAre) {
    std::string clicks =
        "wait-frame\nclick Frame\nwait-ui 3\nclick render without pause\nwait-ui 3\nmove 188 134\n";
    constexpr int kClicks = 6;
    for (int i = 0; i < kClicks; ++i) {
        clicks += "wait-frame 3\npress\nrelease\nwait-ui 40\nstate\n";
    }
    const RunResult run = play(kMachine, clicks + "quit\n");
    for (const std::string& state : run.states(kClicks)) {
        EXPECT_EQ(valueOf(state, "picked").substr(0, 6), "rider,") << state;
    }
}

double zOf(const std::string& state) {
    const std::string eye = valueOf(state, "eye");
    return std::stod(eye.substr(eye.rfind(',') + 1));
}

/// The same bits, and the camera keeps as far away from what is bent.
TEST_F(MovingPartsOfTheViewer, AreBentByTheDeviceAsByTheCpu) {
    const std::string bending =
        CDR_SOURCE_DIR "/tests/assets/machine.glb --animation work --fps 24 --frame 13";
    const RunResult rendered = runShell(
        "'" CDR_PROGRAM "' render " + bending + " --size 32x18 --deform device", folder(), environment());
    if (rendered.status != 0 && rendered.err.find("lacks") != std::string::npos) {
        GTEST_SKIP() << rendered.err;
    }
    std::map<std::string, std::vector<std::string>> states;
    for (const std::string who : {"cpu", "device"}) {
        const RunResult run = play("--size 560x300 --technique anchored --deform " + who + " " + bending,
                                   "wait-frame\npicture " + who +
                                       ".png\nstate\nhold W\nwait-ui 8\nlet W\nwait-frame 2\nstate\nquit\n");
        states[who] = run.states(2);
    }
    EXPECT_EQ(picture("cpu.png"), picture("device.png"));
    EXPECT_LT(zOf(states["device"][1]), zOf(states["device"][0]) - 1.0) << "it flew";
    // When pictures come changes the speed a little.
    EXPECT_NEAR(zOf(states["device"][1]), zOf(states["cpu"][1]), 0.01);
}

/// The frame of a camera path, which `cdr render` takes too.
TEST_F(ViewerTest, BeginsAtTheFrameOfTheScenesPath) {
    const RunResult run =
        play("--size 560x300 --technique anchored --frame 40 afc", "wait-frame\npicture shown.png\nquit\n");
    const RunResult rendered = runShell(
        "'" CDR_PROGRAM "' render afc --technique anchored --frame 40 --colours bright --size 212x300 "
        "-o rendered.png",
        folder(), environment());
    ASSERT_EQ(rendered.status, 0) << rendered.err;
    EXPECT_EQ(picture("shown.png"), picture("rendered.png"));
}

} // namespace

} // namespace cdr::viewer_test
