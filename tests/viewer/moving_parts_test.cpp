#include "viewer_run.h"

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <sstream>
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

/// The same bits, and the camera still keeps away from what is bent.
TEST_F(MovingPartsOfTheViewer, AreBentByTheDeviceAsByTheCpu) {
    const std::string bending =
        CDR_SOURCE_DIR "/tests/assets/machine.glb --animation work --fps 24 --frame 13";
    const RunResult rendered = runShell(
        "'" CDR_PROGRAM "' render " + bending + " --size 32x18 --deform device", folder(), environment());
    if (rendered.status != 0 && rendered.err.find("lacks") != std::string::npos) {
        GTEST_SKIP() << rendered.err;
    }
    std::vector<glm::dvec3> eyes;
    for (const std::string who : {"cpu", "device"}) {
        const RunResult run = play("--size 560x300 --technique anchored --deform " + who + " " + bending,
                                   "wait-frame\npicture " + who +
                                       ".png\nhold W\nwait-ui 8\nlet W\nwait-frame 2\nstate\npicture near-" +
                                       who + ".png\nquit\n");
        std::istringstream eye(valueOf(run.states(1).at(0), "eye"));
        char comma = 0;
        glm::dvec3& place = eyes.emplace_back(0.0);
        eye >> place.x >> comma >> place.y >> comma >> place.z;
        ASSERT_TRUE(eye);
    }
    EXPECT_EQ(picture("cpu.png"), picture("device.png"));
    EXPECT_GT(colors(picture("near-device.png")), 1u);
    // How far away the surfaces are sets the pace; pictures may come a little earlier or later.
    EXPECT_LT(glm::distance(eyes[0], eyes[1]), 1e-2);
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
