#include "viewer_run.h"

#include <gtest/gtest.h>

#include <string>

namespace cdr::viewer_test {

namespace {

/// With room for the panel, which leaves 400 columns to the picture. In its middle a poster hangs over a sign, in one plane.
const std::string kPosters = "--size 748x500 coplanar ";
const std::string kOpened = "wait-frame\nwait-ui 3\n";
const std::string kPickPoster =
    "move 278 242\nwait-ui 2\npress\nrelease\nwait-ui 2\nwait-frame\nclick Camera\nwait-ui 2\n";
const std::string kBehindTheWall = "click 8/layer\ntype -1\nkey enter\nwait-ui 2\nwait-frame\n";

class LayersOfTheViewer : public ViewerTest {};

TEST_F(LayersOfTheViewer, AreSetAndClearedForWhatIsPicked) {
    const RunResult run = play(
        kPosters + "--technique anchored",
        kOpened + "picture own.png\n" + kPickPoster + "window before.png\n" + kBehindTheWall +
            "state\npicture set.png\nwindow after.png\nmove 278 242\nwait-ui 2\nwait-frame\nstate\ncommand\n" +
            "key V\nkey V\nkey V\nkey V\nwait-frame\nstate\nkey V\nkey V\nwait-frame\n" +
            "click 8/layer\ntype 1e-40\nkey enter\nwait-ui 2\nwait-frame\nstate\n" +
            "click the scene's own\nwait-ui 2\nwait-frame\nstate\npicture cleared.png\nquit\n");
    const auto states = run.states(5);
    EXPECT_EQ(valueOf(states[0], "picked").substr(0, 6), "poster") << states[0];
    EXPECT_EQ(valueOf(states[0], "layer"), "poster=-1");
    EXPECT_GT(difference(picture("set.png"), picture("own.png")), 0.003);
    EXPECT_EQ(valueOf(states[1], "under").substr(0, 4), "sign")
        << "not what the new layer shows: " << states[1];
    EXPECT_EQ(valueOf(states[2], "view"), "wrong");
    EXPECT_EQ(valueOf(states[2], "wrong"), "0") << "the answer has another layer";
    EXPECT_EQ(valueOf(states[3], "layer"), "poster=0.0001")
        << "the command line refuses less than a normal float";
    EXPECT_EQ(valueOf(states[4], "layer"), "");
    EXPECT_EQ(picture("cleared.png"), picture("own.png"));
    const auto commands = run.lines("cdr render");
    ASSERT_EQ(commands.size(), 1u);
    EXPECT_NE(commands[0].find("--layer=poster=-1"), std::string::npos) << commands[0];
    EXPECT_EQ(drawnBy(commands[0]), picture("set.png"));
}

/// Each colour is a material. The grey scene has one, which the cube has then; its layer was of a colour that is gone.
TEST_F(LayersOfTheViewer, AreOfTheMaterialsThatThePickedObjectHasInOtherColours) {
    const std::string pickCube = "move 190 258\nwait-ui 2\npress\nrelease\nwait-ui 2\nwait-frame\n";
    const std::string otherColours =
        "click Look\nwait-ui 2\nclick bright colours\nwait-ui 2\nwait-frame\nclick Camera\nwait-ui 2\n";
    const RunResult run = play("cubes --size 748x500 --technique anchored",
                               kOpened + pickCube + "click Camera\nwait-ui 2\nclick 3/layer\ntype 1\n" +
                                   "key enter\nwait-ui 2\nwait-frame\nstate\n" + otherColours +
                                   "where 0/layer\nstate\n" + otherColours + "where 3/layer\nstate\nquit\n");
    const auto states = run.states(3);
    EXPECT_EQ(valueOf(states[0], "picked").substr(0, 8), "object 9") << states[0];
    EXPECT_EQ(valueOf(states[0], "layer"), "#3=1");
    EXPECT_EQ(valueOf(states[1], "colours"), "thesis");
    EXPECT_EQ(valueOf(states[1], "layer"), "");
    EXPECT_EQ(valueOf(states[1], "notice").find("material"), std::string::npos) << states[1];
    EXPECT_EQ(valueOf(states[1], "picked"), valueOf(states[0], "picked"));
    EXPECT_EQ(valueOf(states[2], "colours"), "bright");
}

/// Of both sides, and of a scene that is opened again with them.
TEST_F(LayersOfTheViewer, HoldInAComparisonAndWhenTheSceneIsOpenedAnew) {
    const RunResult run = play(kPosters + "--compare reversed,anchored --layer poster=-1",
                               kOpened + "state\npicture both.png\ncommand\nclick Draw\nwait-ui 2\n" +
                                   "click detail\nclick detail=object\nwait-ui 2\nwait-frame\n" +
                                   "state\npicture anew.png\nquit\n");
    for (const std::string& state : run.states(2)) {
        EXPECT_EQ(valueOf(state, "layer"), "poster=-1") << state;
    }
    const auto commands = run.lines("cdr render");
    ASSERT_EQ(commands.size(), 2u);
    const image::ImageRgba8 both = picture("both.png");
    const std::uint32_t middle = both.width / 2;
    EXPECT_EQ(difference(drawnBy(commands[0]), both, 0, middle - 1), 0.0);
    EXPECT_EQ(difference(drawnBy(commands[1]), both, middle + 1, both.width), 0.0);
    EXPECT_EQ(picture("anew.png"), both);
}

} // namespace

} // namespace cdr::viewer_test
