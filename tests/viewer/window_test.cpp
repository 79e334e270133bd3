#include "../support/difference_picture.h"
#include "viewer_run.h"

#include <cdr/image/codec.h>
#include <cdr/image/compose.h>
#include <scenes/cubes.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>

namespace cdr::viewer_test {

namespace {

namespace fs = std::filesystem;

/// Keeps what a test saw, small, in one picture in the build folder, for people to look at. All are of one
/// size.
void keepContactSheet(const std::string& name, const std::vector<image::ImageRgba8>& pictures) {
    constexpr std::uint32_t kShrink = 2;
    constexpr std::uint32_t kColumns = 2;
    const std::uint32_t width = pictures.front().width / kShrink;
    const std::uint32_t height = pictures.front().height / kShrink;
    const auto count = static_cast<std::uint32_t>(pictures.size());
    image::ImageRgba8 sheet(width * kColumns, height * ((count + kColumns - 1) / kColumns),
                            {255, 255, 255, 255});
    for (std::uint32_t i = 0; i < count; ++i) {
        image::paste(sheet, image::shrink(pictures[i], kShrink), i % kColumns * width, i / kColumns * height);
    }
    fs::create_directories(CDR_SCREENSHOTS);
    image::writeImage(fs::path(CDR_SCREENSHOTS) / name, sheet);
}

TEST_F(ViewerTest, DividerFollowsThePointer) {
    // 560 pixels less the panel's 348 leave 212 for the picture: the divider begins at 106.
    const RunResult run = play("--size 560x300 --compare standard,anchored cubes",
                               "wait-frame\nmove 150 250\nwait-ui 2\nstate\nwindow before.png\n"
                               "move 106 150\npress\nmove 70 150\nmove 53 150\nwait-ui 2\nrelease\n"
                               "move 150 250\nwait-frame\nwait-ui 2\nstate\nwindow after.png\nquit\n");
    const auto states = run.states(2);
    EXPECT_EQ(valueOf(states[0], "divider"), "0.5000");
    EXPECT_EQ(valueOf(states[1], "divider"), "0.2500");
    EXPECT_EQ(valueOf(states[0], "eye"), valueOf(states[1], "eye")) << "the camera moved with the divider";
    const image::ImageRgba8 before = picture("before.png");
    const image::ImageRgba8 after = picture("after.png");
    // Between the two places of the divider the technique changed, and nothing else did but the labels.
    EXPECT_GT(difference(before, after, 58, 101), 0.05);
    keepContactSheet("divider.png", {before, after});
}

TEST_F(ViewerTest, FollowsItsSize) {
    const RunResult run = play(
        "--size 560x300 cubes",
        "wait-frame\nstate\nresize 1 1\nwait-state size=1x1\nwait-frame\nwait-ui 3\nwindow one.png\nstate\n"
        "resize 500 200\nwait-state size=500x200\nwait-frame\nwait-ui 3\nwindow small.png\n"
        "resize 1280 720\nwait-state size=932x720\nwait-frame\nwait-ui 3\n"
        "window large.png\nstate\nresize 560 300\nwait-state size=212x300\nwait-frame\n"
        "wait-ui 3\nwindow back.png\nquit\n");
    const auto states = run.states(3);
    EXPECT_EQ(valueOf(states[0], "size"), "212x300");
    EXPECT_EQ(picture("one.png").width, 1u);
    EXPECT_EQ(picture("small.png").width, 500u);
    const image::ImageRgba8 large = picture("large.png");
    EXPECT_EQ(large.width, 1280u);
    EXPECT_EQ(large.height, 720u);
    EXPECT_GT(brightness(large), 15.0);
    EXPECT_GT(brightness(picture("back.png")), 15.0);
}

/// A window of its own choice is as large as on a display of 96 dots per inch.
TEST_F(ViewerTest, HasThePixelsThatItWasToldOnAScaledDisplay) {
    const RunResult set = runShell("xprop -root -f RESOURCE_MANAGER 8s -set RESOURCE_MANAGER 'Xft.dpi: 192'",
                                   folder(), environment());
    if (set.status != 0) {
        GTEST_SKIP() << "xprop: " << set.err;
    }
    const std::string script = "wait-ui 3\nwindow ";
    play("--size 560x300 cubes", script + "told.png\nwait-ui 3\nquit\n");
    EXPECT_EQ(picture("told.png").width, 560u);
    EXPECT_EQ(picture("told.png").height, 300u);
    play("cubes", script + "chosen.png\nwait-ui 3\nquit\n");
    EXPECT_EQ(picture("chosen.png").width, 2560u);
}

TEST_F(ViewerTest, ComesBackFromBeingMinimised) {
    const RunResult run =
        play("--size 560x300 --technique standard cubes",
             "wait-frame\nwait-ui 3\nwindow before.png\nminimise\nkey 6\nrestore\nwait-frame\nwait-ui 3\n"
             "wait-state technique=anchored\nwait-frame\nwait-ui 3\nwindow after.png\nquit\n");
    EXPECT_EQ(run.status, 0);
    EXPECT_GT(difference(picture("before.png"), picture("after.png")), 0.02);
    EXPECT_GT(brightness(picture("after.png")), 15.0);
}

TEST_F(ViewerTest, OpensWhatIsDropped) {
    fs::copy_file(CDR_SOURCE_DIR "/tests/golden/shapes.gltf", folder() / "Shapes.GLTF");
    std::ofstream(folder() / "broken.gltf") << "{ not a scene";
    const RunResult run = play("--size 560x300 --technique standard cubes",
                               "wait-frame\npicture cubes.png\ndrop Shapes.GLTF\nwait-frame\nstate\n"
                               "picture shapes.png\ndrop broken.gltf\nwait-frame\nwait-ui 2\nstate\n"
                               "picture still.png\nwindow message.png\nquit\n");
    const auto states = run.states(2);
    EXPECT_EQ(valueOf(states[0], "shown"), "Shapes.GLTF");
    EXPECT_GT(difference(picture("cubes.png"), picture("shapes.png")), 0.1);
    EXPECT_EQ(valueOf(states[1], "shown"), "Shapes.GLTF");
    EXPECT_EQ(valueOf(states[1], "scene"), "Shapes.GLTF");
    EXPECT_NE(valueOf(states[1], "notice").find("broken.gltf"), std::string::npos) << states[1];
    EXPECT_EQ(picture("still.png"), picture("shapes.png"));
}

/// A triangle whose texture is the file texture.png.
constexpr const char* kTexturedTriangle =
    R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1},"material":0}]}],
"materials":[{"doubleSided":true,"pbrMetallicRoughness":{"baseColorTexture":{"index":0},"metallicFactor":0}}],
"textures":[{"source":0}],"images":[{"uri":"texture.png"}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},
{"bufferView":1,"componentType":5126,"count":3,"type":"VEC2"}],
"bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":24}],
"buffers":[{"byteLength":60,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAgD8AAIA/AACAPwAAAAAAAAAA"}]})";

/// The viewer itself writes another picture over the texture.
TEST_F(ViewerTest, ReadsAFileAgainThatIsDroppedAgain) {
    std::ofstream(folder() / "textured.gltf") << kTexturedTriangle;
    image::writeImage(folder() / "texture.png", image::ImageRgba8(2, 2, {255, 255, 255, 255}));
    play("--size 560x300 --technique anchored textured.gltf",
         "wait-frame\npicture white.png\npicture texture.png\ndrop textured.gltf\nwait-frame\n"
         "picture dark.png\nquit\n");
    EXPECT_GT(difference(picture("white.png"), picture("dark.png")), 0.02);
}

TEST_F(ViewerTest, WheelAndKeysMoveTheCamera) {
    const RunResult run = play(
        "--size 560x300 --technique standard cubes",
        "wait-frame\nstate\npicture a.png\nmove 100 150\nhold alt\nscroll 5\nlet alt\nwait-frame\nstate\n"
        "picture b.png\nhold W\nwait-ui 20\nlet W\nwait-frame\nstate\npicture c.png\n"
        "key home\nwait-frame\nstate\npicture d.png\nquit\n");
    const auto states = run.states(4);
    EXPECT_LT(std::stod(valueOf(states[1], "fov")), 0.6 * std::stod(valueOf(states[0], "fov")));
    EXPECT_EQ(valueOf(states[1], "eye"), valueOf(states[0], "eye"));
    EXPECT_NE(valueOf(states[2], "eye"), valueOf(states[1], "eye"));
    EXPECT_EQ(valueOf(states[3], "eye"), valueOf(states[0], "eye"));
    EXPECT_GT(difference(picture("a.png"), picture("b.png")), 0.1);
    EXPECT_GT(difference(picture("b.png"), picture("c.png")), 0.01);
    EXPECT_EQ(picture("a.png"), picture("d.png"));
}

TEST_F(ViewerTest, PicksAndMeasures) {
    const RunResult run =
        play("--size 560x300 --technique anchored cubes",
             "wait-frame\nmove 106 150\npress\nrelease\nwait-frame\nstate\n"
             "move 40 81\npress\nrelease\nwait-frame\nwait-ui 2\nstate\nwindow w.png\nquit\n");
    const auto states = run.states(2);
    EXPECT_NE(valueOf(states[0], "picked"), "") << states[0];
    EXPECT_EQ(valueOf(states[0], "measured"), "") << "one end alone";
    EXPECT_NE(valueOf(states[1], "measured"), "") << states[1];
    EXPECT_EQ(valueOf(states[0], "under"), valueOf(states[0], "picked"));
    EXPECT_NE(valueOf(states[1], "under"), valueOf(states[0], "under")) << "the pointer went elsewhere";
    EXPECT_EQ(valueOf(states[0], "picked"), valueOf(states[1], "picked"));
    EXPECT_EQ(valueOf(states[0], "eye"), valueOf(states[1], "eye")) << "a click is no drag";
}

TEST_F(ViewerTest, RecordsAPathAndPlaysIt) {
    const RunResult run = play("--size 560x300 --technique standard cubes",
                               "wait-frame\nkey R\nhold D\nwait-ui 20\nlet D\nwait-frame\nkey R\nstate\n"
                               "key home\nwait-frame\nstate\nkey P\nwait-state motion=recording\n"
                               "wait-state motion=free\nwait-frame\nstate\nquit\n");
    ASSERT_TRUE(fs::exists(folder() / "camera-path-0001.json"));
    const auto states = run.states(3);
    EXPECT_NE(valueOf(states[1], "eye"), valueOf(states[0], "eye"));
    EXPECT_EQ(valueOf(states[2], "eye"), valueOf(states[0], "eye")) << "playing ends where recording ended";
}

TEST_F(ViewerTest, KeysReachThePanelsAndComeBack) {
    const RunResult run = play("--size 560x300 --compare standard,anchored cubes",
                               "wait-frame\nkey F4\nwait-ui 3\nwhere targets\nkey F2\nwait-ui 3\nstate\n"
                               "key down\nkey space\nwait-ui 3\nwait-frame\nstate\n"
                               "key escape\nkey V\nhold D\nwait-ui 4\nlet D\nwait-frame\nstate\nquit\n");
    const auto states = run.states(3);
    EXPECT_EQ(run.lines("targets ").size(), 1u) << "F4 shows the panel Draw";
    EXPECT_EQ(valueOf(states[0], "colours"), "bright");
    EXPECT_EQ(valueOf(states[1], "colours"), "thesis") << "the second item of the panel Look";
    EXPECT_EQ(valueOf(states[1], "eye"), valueOf(states[0], "eye")) << "arrows flew";
    EXPECT_EQ(valueOf(states[2], "view"), "cascades");
    EXPECT_NE(valueOf(states[2], "eye"), valueOf(states[1], "eye")) << "the camera has no keys";
}

/// Over the picture an open list takes the wheel.
TEST_F(ViewerTest, EscapeClosesAList) {
    const std::string wheels =
        "key escape\nwait-ui 3\nstate\nmove 50 100\nwait-ui 2\nscroll 3\nwait-ui 2\nstate\n";
    const RunResult run =
        play("--size 560x300 --technique standard cubes",
             "wait-frame\nkey F2\nwait-ui 3\nkey down\nkey up\nkey space\nwait-ui 3\nwhere scene=rotation\n" +
                 wheels + "click scene\nwait-ui 2\nwhere scene=rotation\n" + wheels + "quit\n");
    const auto states = run.states(6); // the lines that say where an entry is among them
    EXPECT_NE(valueOf(states[2], "eye"), valueOf(states[1], "eye")) << "the list that a key opened";
    EXPECT_NE(valueOf(states[5], "eye"), valueOf(states[4], "eye")) << "the list that a click opened";
}

TEST_F(ViewerTest, ShowsPicturesOfScenesToChooseFrom) {
    const RunResult run = play("--size 800x600 --technique standard cubes",
                               "wait-frame\nwait-ui 3\nwindow closed.png\nclick scene\nwait-ui 3\nwindow "
                               "open.png\nclick scene=rotation\nwait-frame\nstate\nquit\n");
    EXPECT_EQ(valueOf(run.states(1)[0], "shown"), "rotation");
    // Names alone would bring no more than shades of grey.
    EXPECT_GT(colors(picture("open.png")), colors(picture("closed.png")) + 3000);
    keepContactSheet("scenes.png", {picture("closed.png"), picture("open.png")});
}

TEST_F(ViewerTest, KeepsNoVideoWithoutAPicture) {
    const RunResult run =
        play("--size 300x200 cubes", "wait-frame\nhold F11\nhold F11\nwait-ui 2\nstate\nquit\n");
    const std::string notice = valueOf(run.states(1)[0], "notice");
    if (notice.find("ffmpeg") != std::string::npos) {
        GTEST_SKIP() << notice;
    }
    EXPECT_NE(notice.find("nothing was recorded"), std::string::npos) << notice;
    EXPECT_FALSE(fs::exists(folder() / "cdr-video-0001.mp4"));
}

TEST_F(ViewerTest, RecordsBothSidesAsAVideo) {
    const RunResult run = play("--size 561x300 --compare standard,anchored cubes",
                               "wait-frame\nkey F11\nwait-ui 10\nhold D\nwait-ui 30\nlet D\nkey F11\n"
                               "wait-ui 2\nstate\nquit\n");
    const std::string notice = valueOf(run.states(1)[0], "notice");
    if (notice.find("ffmpeg") != std::string::npos) {
        GTEST_SKIP() << notice;
    }
    // 42 frames of the interface, each a sixtieth of a second.
    EXPECT_NE(notice.find("cdr-video-0001.mp4 holds 2"), std::string::npos) << notice;
    const RunResult frame = runShell("ffmpeg -loglevel error -i cdr-video-0001.mp4 -frames:v 1 first.png && "
                                     "ffmpeg -loglevel error -i first.png -vf crop=212:300:0:0 left.png && "
                                     "ffmpeg -loglevel error -i first.png -vf crop=212:300:212:0 right.png",
                                     folder(), environment());
    ASSERT_EQ(frame.status, 0) << frame.err;
    EXPECT_EQ(picture("first.png").width, 2 * 212u) << "two pictures of 213, the odd column left out";
    EXPECT_EQ(picture("first.png").height, 300u);
    // One picture twice would differ by what the codec does to it alone.
    EXPECT_GT(brightness(test::differencePicture(picture("left.png"), picture("right.png"), 1)), 6.0);
}

TEST_F(ViewerTest, NoScriptWaitsForFramesThatNothingAsksFor) {
    const RunResult run =
        play("--size 640x360 --technique standard " CDR_SOURCE_DIR "/tests/golden/shapes.gltf",
             "wait-frame 7\nstate\nkey space\nwait-frame 7\nstate\nquit\n");
    const auto states = run.states(2);
    EXPECT_EQ(valueOf(states[1], "motion"), "free") << "a path of one frame is over at once";
    EXPECT_EQ(valueOf(states[1], "eye"), valueOf(states[0], "eye"));
}

TEST_F(ViewerTest, ScriptsScrollToWhatTheyClick) {
    const RunResult run = play("--size 640x240 --technique standard cubes",
                               "wait-frame\nclick Draw\nwhere tone mapping\nclick tone mapping\n"
                               "click tone mapping=neutral\nwait-frame\nwhere tone mapping\ncommand\nquit\n");
    const auto places = run.lines("tone mapping ");
    ASSERT_EQ(places.size(), 2u) << run.out;
    const auto rowOf = [](const std::string& place) { return std::stod(place.substr(place.rfind(' '))); };
    EXPECT_GT(rowOf(places[0]), 240.0) << "it was in view from the start";
    EXPECT_LT(rowOf(places[1]), 240.0);
    EXPECT_NE(run.out.find("--tone-map=neutral"), std::string::npos) << run.out;
}

TEST_F(ViewerTest, EveryTabDraws) {
    std::string script = "wait-frame\n";
    std::vector<std::string> names;
    for (const std::string tab : {"Look", "Camera", "Draw", "Frame", "Inside"}) {
        names.push_back(tab + ".png");
        script += "click " + tab + "\nwait-ui 3\nwindow " + names.back() + "\n";
    }
    script += "key F1\nwait-ui 3\nwindow help.png\nstate\nkey F1\nkey tab\nwait-frame\nwait-ui 3\nwindow "
              "plain.png\nquit\n";
    const RunResult run = play("--size 1000x720 --compare standard,anchored --threads 2 cubes", script);
    EXPECT_EQ(valueOf(run.states(1)[0], "hidden-help"), "0") << "the help needs scrolling";
    names.insert(names.end(), {"help.png", "plain.png"});
    std::vector<image::ImageRgba8> windows;
    for (const std::string& name : names) {
        windows.push_back(picture(name));
        if (windows.size() > 1) {
            EXPECT_GT(difference(windows[windows.size() - 2], windows.back()), 0.01) << name;
        }
    }
    keepContactSheet("contact_sheet.png", windows);
}

/// Beside a cube that lies outside the picture.
TEST_F(ViewerTest, FlightsStopAtSurfacesThatNoPictureShowed) {
    const glm::dvec3 cube = scenes::makeCubes(2013).scene.instances.position(0);
    const RunResult run = play(fmt::format("--size 640x360 --eye {},{},{} --direction 0,0,-1 --fov 30 cubes",
                                           cube.x - 8.0, cube.y, cube.z),
                               "wait-frame\nhold D\nwait-ui 40\nlet D\nwait-frame\nwait-ui 3\nstate\nquit\n");
    const auto states = run.states(1);
    constexpr double kHalfSide = 5.0;
    const double left = cube.x - kHalfSide - std::stod(valueOf(states[0], "eye"));
    EXPECT_GT(left, 0.0) << "it flew into the cube";
    EXPECT_LT(left, 0.1) << "it stopped far from the cube";
}

TEST_F(ViewerTest, QuitsAfterSoManyFramesThoughNothingMoves) {
    const RunResult run =
        runShell("timeout 1200 '" CDR_VIEWER "' --size 640x360 --frames 40 --screenshot still.png cubes",
                 folder(), environment());
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(picture("still.png").width, 640u);
}

TEST_F(ViewerTest, SurvivesRandomInput) {
    // A 900th of half an hour; the same options with --soak 1800 are the long one.
    const RunResult run = runShell("'" CDR_VIEWER_DRIVE "' --validate --size 240x180 --soak 2 --seed 7 cubes",
                                   folder(), environment());
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.err, "");
    const auto lines = run.lines("soak: ");
    ASSERT_EQ(lines.size(), 1u) << run.out;
    EXPECT_NE(lines[0].find("soak: 120 steps, "), std::string::npos) << lines[0];
}

TEST_F(ViewerTest, ASoakWhoseMemoryGrowsFails) {
    // None can shrink to nothing, so any soak is over this limit.
    const RunResult run =
        runShell("'" CDR_VIEWER_DRIVE "' --size 64x48 --soak 1 --largest 64x48 --largest-growth=-100 cubes",
                 folder(), environment());
    expectOneLine(run, 1, "memory grew by ");
    EXPECT_EQ(run.lines("soak: ").size(), 1u) << run.out;
}

TEST_F(ViewerTest, SaysWhatIsWrongInOneLine) {
    const auto expectError = [&](const std::string& arguments, int status, const std::string& text) {
        SCOPED_TRACE(arguments);
        expectOneLine(runShell("'" CDR_VIEWER "' " + arguments, folder(), environment()), status, text);
    };
    expectError("--technique nonsense", 2, "unknown technique");
    expectError("--size 0x5", 2, "WIDTHxHEIGHT");
    expectError("--compare standard", 2, "LEFT,RIGHT");
    expectError("no-such-scene", 2, "no-such-scene");
    expectError("--device 99", 2, "99");
    expectError("--script script", 2, "--script");
    expectError("--layer poster coplanar", 2, "MATERIAL=LAYER");
    expectError("--layer poster=1e39 coplanar", 2, "a layer must be");
    expectError("--layer nosuch=1 coplanar", 2, "unknown material 'nosuch'");
    for (const std::string second :
         {"--technique anchored", "--compare standard,cdr", "--compare standard,anchored"}) {
        expectError("--frames 1 --depth standard " + second + " afc", 2,
                    "give either --technique or --compare, or --depth and --split");
    }
    for (const std::string option :
         {"--ui-scale nan", "--seed -1", "--frames -1", "--threads -1", "--gltf-scene 0x1"}) {
        expectError("--frames 1 " + option + " afc", 2, option.substr(0, option.find(' ')));
    }
    // What the panels leave unused, a command line may not ask for.
    expectError("--frames 1 --shadows anchored --detail cluster alley", 2,
                "levels of detail by cascade or cluster do without shadows");
    expectError("--frames 1 --focus 10:0.3 alley", 2, "a lens with a focus needs targets layers, not single");
    expectError("--frames 1 --focus 10:0.3 --targets layers --shadows plain alley", 2,
                "a lens with a focus does without shadows");
    expectError("--frames 1 --occlusion 1:layers alley", 2, "needs layered targets");
    expectError("--frames 1 --time nan afc", 2, "--time must be finite");
    // Before the window opens, not when it quits.
    expectError("--device 99 --screenshot x.jpg afc", 2, "cannot write '.jpg' pictures");
    expectError("--device 99 --screenshot missing/x.png afc", 2, "missing/x.png: ");
    const RunResult endless =
        runShell("timeout 1000 '" CDR_VIEWER_DRIVE "' --soak nan", folder(), environment());
    EXPECT_EQ(endless.status, 2);
    expectOneLine(runShell("'" CDR_VIEWER_DRIVE "' --script missing", folder(), environment()), 2, "missing");
    const RunResult blind =
        runShell("env -u DISPLAY -u WAYLAND_DISPLAY '" CDR_VIEWER "' afc", folder(), environment());
    expectOneLine(blind, 1, "cdr render afc");
}

TEST_F(ViewerTest, ListensToTheXServer) {
    if (std::string(CDR_XDOTOOL).empty()) {
        GTEST_SKIP() << "no xdotool; tools/setup.sh installs it";
    }
    std::ofstream(folder() / "script")
        << "wait-frame\nwindow before.png\nstate\nwait-state technique=anchored\n"
           "wait-state fov=0.6\nwait-frame\nwait-ui 3\nwindow after.png\nstate\n";
    // xdotool waits for the window; then a key, the wheel twice, and the key that quits. Keys sent before the
    // script has taken its first picture would be no less right, so nothing waits for that.
    std::ofstream(folder() / "hands")
        << "set -e\n"
           "window=$('" CDR_XDOTOOL "' search --sync --onlyvisible --name cdr-viewer)\n"
           "while [ ! -s run.out ]; do read -t 0.1 <> <(:) || true; done\n"
           "'" CDR_XDOTOOL "' windowfocus --sync $window mousemove --window $window 100 150\n"
           "'" CDR_XDOTOOL "' key 6 keydown alt click 4 click 4 keyup alt\n"
           "while [ ! -s after.png ]; do read -t 0.1 <> <(:) || true; done\n"
           "'" CDR_XDOTOOL "' key ctrl+q\n";
    const RunResult run = runShell(
        "(timeout 1200 bash hands & '" CDR_VIEWER_DRIVE
        "' --validate --size 560x300 --technique standard --script script cubes; status=$?; wait; exit $status)",
        folder(), environment());
    EXPECT_EQ(run.status, 0) << run.err;
    const auto states = run.states(2);
    EXPECT_EQ(valueOf(states[0], "technique"), "standard,");
    EXPECT_EQ(valueOf(states[1], "technique"), "anchored,");
    EXPECT_GT(difference(picture("before.png"), picture("after.png")), 0.05);
}

} // namespace

} // namespace cdr::viewer_test
