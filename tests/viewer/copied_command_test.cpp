#include "viewer_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <ostream>

namespace cdr::viewer_test {

namespace {

/// What was on screen, and the keys and clicks that put it there.
struct Shown {
    const char* name;
    std::string arguments;
    std::string script;
    const char* size = "560x300";

    friend std::ostream& operator<<(std::ostream& out, const Shown& shown) { return out << shown.name; }
};

class CopiedCommand : public ViewerTest, public testing::WithParamInterface<Shown> {};

/// Bit for bit what F12 saves, whatever frames came before.
TEST_P(CopiedCommand, DrawsWhatTheWindowShows) {
    const RunResult run = play(GetParam().arguments + " --size " + GetParam().size,
                               "wait-frame\nwait-ui 3\n" + GetParam().script +
                                   "wait-frame\ncommand\nstate\nkey F12\nwait-ui 3\nquit\n");
    const auto commands = run.lines("cdr render");
    const bool isSplit = GetParam().arguments.find("--compare") != std::string::npos;
    ASSERT_EQ(commands.size(), isSplit ? 2u : 1u) << run.out;
    std::vector<image::ImageRgba8> pictures;
    for (const std::string& command : commands) {
        pictures.push_back(drawnBy(command));
    }
    const image::ImageRgba8 shown = picture("cdr-picture-0001.png");
    EXPECT_GT(colors(shown), 20u);
    const double divider = isSplit ? std::stod(valueOf(run.lines("scene=").at(0), "divider")) : 1.0;
    const auto column = static_cast<std::uint32_t>(std::lround(divider * shown.width));
    const std::uint32_t line = isSplit ? 1 : 0; // a pixel of the divider on either side
    EXPECT_EQ(difference(pictures.front(), shown, 0, column - line), 0.0);
    if (isSplit) {
        EXPECT_EQ(difference(pictures.back(), shown, column + line, shown.width), 0.0);
        EXPECT_GT(difference(pictures.front(), pictures.back()), 0.01) << "one line for both sides";
    }
}

/// The copied line again, in the viewer: it shows the same picture and copies the same line.
TEST_F(ViewerTest, OpensWhatItCopied) {
    const std::string chosen = "wait-frame\nhold D\nwait-ui 2\nlet D\nclick Draw\nclick occlusion\n"
                               "click occlusion=1\nclick fog\nclick fog=100\nkey V\nwait-frame\n";
    const std::string copies = "command\nkey F12\nwait-ui 3\nquit\n";
    const RunResult first = play("alley --technique log-fragment/count:4 --size 560x300", chosen + copies);
    const auto line = first.lines("cdr render");
    ASSERT_EQ(line.size(), 1u) << first.out;
    const RunResult second = play(line[0].substr(std::string("cdr render ").size()), "wait-frame\n" + copies);
    EXPECT_EQ(second.lines("cdr render"), line) << second.out;
    EXPECT_EQ(picture("cdr-picture-0002.png"), picture("cdr-picture-0001.png"));
}

/// Its --size is that of one eye.
TEST_F(ViewerTest, OpensTheTwoEyesThatItCopied) {
    const std::string copies = "wait-frame\ncommand\nkey F12\nwait-ui 3\nquit\n";
    const RunResult first =
        play("alley --technique cdr --stereo parallel --eye-distance 0.2 --size 560x300", copies);
    const auto line = first.lines("cdr render");
    ASSERT_EQ(line.size(), 1u) << first.out;
    const RunResult second = play(line[0].substr(std::string("cdr render ").size()), copies);
    EXPECT_EQ(second.lines("cdr render"), line) << second.out;
    EXPECT_EQ(picture("cdr-picture-0002.png"), picture("cdr-picture-0001.png"));
}

/// All that a line says of the finish comes back, numbers too.
TEST_F(ViewerTest, CopiesWhatItWasGiven) {
    const std::vector<std::string> given{
        "--detail=object:4", "--translucency=sorted", "--translucency-memory=1",
        "--antialias=edges", "--shadows=anchored",    "--shadow-texels=512",
        "--device=0"};
    std::string arguments = "alley --technique anchored --size 560x300";
    for (const std::string& option : given) {
        arguments += " " + option;
    }
    const RunResult run = play(arguments, "wait-frame\ncommand\nquit\n");
    const auto lines = run.lines("cdr render");
    ASSERT_EQ(lines.size(), 1u) << run.out;
    for (const std::string& option : given) {
        EXPECT_NE(lines[0].find(" " + option + " "), std::string::npos) << option << ": " << lines[0];
    }
}

/// As it is printed, except for where the program was built, in a small window.
TEST_F(ViewerTest, RunsWhatTheReadmePrints) {
    std::ifstream readme(CDR_SOURCE_DIR "/README.md");
    const std::string program = "build/release/bin/cdr-viewer ";
    std::string line;
    while (std::getline(readme, line) && line.find(program) != 0) {
    }
    const RunResult run = play("--size 560x300 " + line.substr(std::min(program.size(), line.size())),
                               "wait-frame\nstate\nquit\n");
    ASSERT_EQ(run.lines("scene=orbit").size(), 1u) << line << "\n" << run.out;
    EXPECT_NE(run.out.find("technique=reversed"), std::string::npos);
}

const std::string kMoved =
    "hold D\nwait-ui 2\nlet D\nmove 100 150\npress\nmove 115 140\nmove 130 130\nwait-ui 2\n"
    "release\nhold W\nwait-ui 2\nlet W\n";

INSTANTIATE_TEST_SUITE_P(
    Views, CopiedCommand,
    testing::Values(
        Shown{"plain", "afc --technique anchored", ""}, Shown{"moved", "afc --technique anchored", kMoved},
        Shown{"narrowed", "afc --technique anchored", kMoved + "move 100 150\nhold alt\nscroll 6\nlet alt\n"},
        Shown{"played", "afc --technique anchored", "key space\nwait-frame 12\nkey space\n"},
        Shown{"finished", "alley --technique anchored",
              kMoved + "click Draw\nclick edges\nclick edges=edges\nclick occlusion\nclick occlusion=1\n"
                       "click fog\nclick fog=100\n"},
        Shown{"gpuDriven", "afc --technique logcdr",
              kMoved + "click Draw\nclick submission\n"
                       "click submission=gpu-driven\n"},
        Shown{"sideBySide", "alley --technique anchored", kMoved + "key G\nkey G shift\n"},
        Shown{"anaglyph", "alley --technique anchored", kMoved + "key G\nkey G\n"},
        Shown{"eyesOfTheLine", "alley --technique cdr --stereo parallel --eye-distance 0.2", kMoved},
        Shown{"split", "afc --compare standard,anchored", kMoved},
        Shown{"splitMoved", "mixed --compare cdr,reversed",
              "move 106 150\npress\nmove 70 150\nmove 53 150\nwait-ui 2\nrelease\n"}),
    [](const auto& view) { return std::string(view.param.name); });

} // namespace

} // namespace cdr::viewer_test
