#include "viewer_run.h"

#include <gtest/gtest.h>

#include <array>

namespace cdr::viewer_test {

namespace {

constexpr std::array<const char*, 6> kPresets{"standard", "cdr", "log", "logcdr", "reversed", "anchored"};

/// Small, since validation on a software device is slow; with room for the panel beside the picture.
const std::string kSmall = "--size 560x300 ";

TEST_F(ViewerTest, ShowsWhatTheCommandLineRenders) {
    const RunResult run = play("cubes --technique logcdr --size 560x300",
                               "wait-frame\npicture shown.png\nwindow window.png\ncommand\nquit\n");
    const auto commands = run.lines("cdr render");
    ASSERT_EQ(commands.size(), 1u);
    const image::ImageRgba8 shown = picture("shown.png");
    EXPECT_GT(brightness(shown), 20.0);
    EXPECT_EQ(shown, drawnBy(commands[0]));
    // In the window the picture stands at the left, its label over it, the panel beside it.
    const image::ImageRgba8 window = picture("window.png");
    ASSERT_EQ(window.width, 560u);
    ASSERT_LT(shown.width, window.width);
    image::ImageRgba8 left(shown.width, shown.height);
    for (std::uint32_t y = 0; y < left.height; ++y) {
        std::copy_n(&window.at(0, y), left.width, &left.at(0, y));
    }
    EXPECT_LT(difference(left, shown), 0.1);
    EXPECT_GT(difference(left, shown), 0.001);
}

/// Where the tour is stopped, its 100,000 objects are where the command puts them, and none is wrong.
TEST_F(ViewerTest, ShowsTrafficWhereItsFramePutsIt) {
    const RunResult run =
        play(kSmall + "--technique anchored --play traffic",
             "wait-frame 4\nkey space\nwait-state motion=free\nwait-frame\npicture shown.png\n"
             "command\nkey V\nkey V\nkey V\nkey V\nwait-frame\nstate\nquit\n");
    const auto commands = run.lines("cdr render");
    ASSERT_EQ(commands.size(), 1u);
    const std::size_t frame = commands[0].find("--frame=");
    ASSERT_NE(frame, std::string::npos) << commands[0];
    EXPECT_GT(std::stoi(commands[0].substr(frame + 8)), 0) << "the tour has begun";
    EXPECT_GT(colors(picture("shown.png")), 100u);
    EXPECT_EQ(picture("shown.png"), drawnBy(commands[0]));
    const auto states = run.states(1);
    EXPECT_EQ(valueOf(states[0], "view"), "wrong");
    EXPECT_EQ(valueOf(states[0], "wrong"), "0");
}

TEST_F(ViewerTest, KeysPickThePresets) {
    std::string script = "key V\nkey V\nkey V\nkey V\nwait-frame\n"; // the view of wrong pixels
    for (std::size_t i = 0; i < kPresets.size(); ++i) {
        const std::string number = std::to_string(i + 1);
        script += "key " + number + "\nwait-frame\nstate\npicture " + number + ".png\n";
    }
    const RunResult run = play(kSmall + "cubes", script + "quit\n");
    const auto states = run.states(kPresets.size());
    for (std::size_t i = 0; i < kPresets.size(); ++i) {
        EXPECT_EQ(valueOf(states[i], "technique"), std::string(kPresets[i]) + ",");
        EXPECT_EQ(valueOf(states[i], "view"), "wrong");
    }
    EXPECT_GT(std::stoi(valueOf(states[0], "wrong")), 1000);
    for (std::size_t i = 1; i < kPresets.size(); ++i) {
        EXPECT_LT(std::stoi(valueOf(states[i], "wrong")), 100) << kPresets[i];
    }
    EXPECT_EQ(std::stoi(valueOf(states[5], "wrong")), 0);
    EXPECT_GT(difference(picture("1.png"), picture("6.png")), 0.01);
}

TEST_F(ViewerTest, CombosChooseMappingSplitAndFormat) {
    std::string script = "wait-frame\nwait-ui 3\n";
    const auto choose = [&](const std::string& combo, const std::string& entry) {
        script += "click " + combo + "\nclick " + combo + "=" + entry + "\nwait-frame\nstate\n";
    };
    const std::array<const char*, 6> mappings{"reversed",          "log",     "log-fragment", "anchored",
                                              "anchored-reversed", "standard"};
    for (const char* mapping : mappings) {
        choose("technique/mapping", mapping);
    }
    choose("technique/split", "count:4");
    choose("technique/split", "fitted");
    choose("technique/format", "d16");
    const RunResult run =
        play("--size 560x400 --technique standard cubes", script + "picture end.png\nquit\n");
    const auto states = run.states(mappings.size() + 3);
    EXPECT_NE(states[2].find("log-fragment/none"), std::string::npos) << states[2];
    EXPECT_NE(states[4].find("anchored-reversed/none"), std::string::npos) << states[4];
    EXPECT_EQ(valueOf(states[5], "cascades"), "1");
    EXPECT_EQ(valueOf(states[6], "cascades"), "4");
    EXPECT_NE(states[7].find("standard/fitted"), std::string::npos) << states[7];
    EXPECT_NE(states[8].find("d16"), std::string::npos) << states[8];
    EXPECT_GT(brightness(picture("end.png")), 20.0);
}

TEST_F(ViewerTest, TargetsAndThreadsChangeNothingOfThePicture) {
    std::string script = "wait-frame\nwait-ui 3\nclick Draw\nwait-frame\npicture single.png\n";
    for (const std::string targets : {"accumulate", "pool", "layers"}) {
        script +=
            "click targets\nclick targets=" + targets + "\nwait-frame\nstate\npicture " + targets + ".png\n";
    }
    const RunResult run = play("--size 560x400 --technique cdr cubes --threads 2", script + "quit\n");
    const auto states = run.states(3);
    EXPECT_EQ(valueOf(states[2], "targets"), "layers");
    for (const std::string targets : {"accumulate", "pool", "layers"}) {
        EXPECT_EQ(picture(targets + ".png"), picture("single.png")) << targets;
    }
}

TEST_F(ViewerTest, ViewsShowTheSameSceneDifferently) {
    std::string script = "key space\nwait-frame 3\nkey space\nwait-frame\n";
    const std::array<const char*, 6> views{"shaded", "cascades", "distance", "ids", "wrong", "flips"};
    for (const char* view : views) {
        script += std::string("state\nwait-frame\npicture ") + view + ".png\nkey V\nwait-frame\n";
    }
    const RunResult run = play(kSmall + "afc --technique cdr", script + "quit\n");
    const auto states = run.states(views.size());
    for (std::size_t i = 0; i < views.size(); ++i) {
        EXPECT_EQ(valueOf(states[i], "view"), views[i]);
        EXPECT_GT(colors(picture(std::string(views[i]) + ".png")), 3u) << views[i];
        for (std::size_t j = 0; j < i && i < 5; ++j) { // flips at rest may be the plain dim picture
            EXPECT_GT(
                difference(picture(std::string(views[i]) + ".png"), picture(std::string(views[j]) + ".png")),
                0.05)
                << views[i] << " and " << views[j];
        }
    }
    EXPECT_GT(std::stoi(valueOf(states[4], "wrong")), 100);
}

TEST_F(ViewerTest, FlipsShowWhileTheCameraMoves) {
    const std::string script =
        "key V\nkey V\nkey V\nkey V\nkey V\nwait-frame\nkey space\nwait-frame 8\n"
        "wait-state flipped=\nstate\npicture standard.png\nkey space\nwait-frame\nstate\nquit\n";
    const RunResult standard = play(kSmall + "afc --technique standard", script);
    const auto states = standard.states(2);
    EXPECT_GT(std::stoi(valueOf(states[0], "flipped")), 100) << states[0];
    EXPECT_EQ(valueOf(states[1], "flipped"), "0") << "they fade at rest: " << states[1];
    const RunResult anchored = play(kSmall + "afc --technique anchored", script);
    EXPECT_LT(std::stoi(valueOf(anchored.states(2)[0], "flipped")), 10);
}

/// As the keys 1 to 6 do.
TEST_F(ViewerTest, PresetsOfThePanelKeepTheFormat) {
    const RunResult run = play(kSmall + "--technique standard --format d16 cubes",
                               "wait-frame\nwindow before.png\nclick technique/anchored\nwait-frame\n"
                               "state\nquit\n");
    ASSERT_EQ(run.lines("scene=cubes technique=anchored, d16 ").size(), 1u) << run.out;
}

} // namespace

} // namespace cdr::viewer_test
