#include "program.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace cdr::cli_test {

namespace {

using ShellCommands = FolderTest;

TEST_F(ShellCommands, NothingAskedForShowsHelp) {
    const ProgramResult bare = succeed("");
    EXPECT_EQ(bare.out, run("--help").out);
    EXPECT_NE(bare.out.find("\nMeasure:\n"), std::string::npos) << bare.out;
    const ProgramResult missing = run("--quiet");
    EXPECT_EQ(missing.status, 2);
    EXPECT_EQ(missing.err, "cdr: a command is missing: cdr --help lists them\n");
}

TEST_F(ShellCommands, HelpFits100Columns) {
    std::vector<std::string> names = commandNames();
    ASSERT_GE(names.size(), 18u);
    names.emplace_back("");
    for (const std::string& name : names) {
        std::istringstream lines(run(name + " --help").out);
        std::string line;
        std::string last;
        while (std::getline(lines, line)) {
            EXPECT_LE(line.size(), 100u) << name << ": " << line;
            EXPECT_FALSE(line.empty() && last.empty()) << name << ": two blank lines";
            last = line;
        }
    }
}

TEST_F(ShellCommands, BashCompletesCommandsAndTheirOptions) {
    std::ofstream(at("cdr.bash")) << run("completions bash").out;
    const auto completed = [&](const std::string& words, int current) {
        std::ofstream(at("try.bash"))
            << "source cdr.bash; cdr() { '" CDR_PROGRAM "' \"$@\"; }; COMP_WORDS=(" << words
            << "); COMP_CWORD=" << current << "; _cdr; echo ${COMPREPLY[@]}\n";
        return run("--version > /dev/null; bash try.bash").out;
    };
    EXPECT_EQ(completed("cdr ren", 1), "render\n");
    EXPECT_EQ(completed("cdr --device 0 sc", 3), "scaling\n");
    EXPECT_EQ(completed("cdr render cubes --tech", 3), "--technique\n");
    EXPECT_EQ(completed("cdr render cu", 2), "\n"); // files
    EXPECT_EQ(completed("cdr render cubes --qui", 3), "--quiet\n") << "what every command takes";
    EXPECT_EQ(completed("cdr render cubes --hel", 3), "--help\n") << "once";
    if (run("view --version", "PATH=/nowhere").err.find("cannot be started") == std::string::npos) {
        EXPECT_EQ(completed("cdr view --vsy", 2), "--vsync\n") << "the viewer's";
    }
}

TEST_F(ShellCommands, TheViewerGetsTheOptionsOfAllCommandsAsTheyWereGiven) {
    namespace fs = std::filesystem;
    fs::copy_file(CDR_PROGRAM, at("cdr"));
    std::ofstream(at("cdr-viewer")) << "#!/bin/sh\necho \"$@\"\n";
    fs::permissions(at("cdr-viewer"), fs::perms::owner_all);
    const auto given = [&](const std::string& options) {
        return run("--version > /dev/null; ./cdr " + options + " view cubes").out;
    };
    EXPECT_EQ(given(""), "cubes\n");
    EXPECT_EQ(given("--unit none"), "--unit=none cubes\n") << "the viewer's own is auto";
    EXPECT_EQ(given("--unit km --points 2"), "--points=2 --unit=km cubes\n");
}

TEST_F(ShellCommands, ZshTakesItsScriptSourcedToo) {
    if (run("--version > /dev/null && zsh -fc true").status != 0) {
        GTEST_SKIP() << "no zsh";
    }
    std::ofstream(at("cdr.zsh")) << run("completions zsh").out;
    std::ofstream(at("try.zsh"))
        << "autoload -U compinit; compinit -D -u; source ./cdr.zsh; echo $_comps[cdr]\n";
    const ProgramResult result = run("--version > /dev/null; zsh -f try.zsh");
    EXPECT_EQ(result.out, "_cdr\n");
    EXPECT_EQ(result.err, "");
}

TEST_F(ShellCommands, EveryShellAndTheManualNameEveryCommand) {
    const std::vector<std::string> names = commandNames(); // as fish completes them
    ASSERT_GE(names.size(), 18u);
    for (const char* what : {"completions bash", "completions zsh", "manual"}) {
        const ProgramResult result = succeed(what);
        for (const std::string& name : names) {
            EXPECT_TRUE(std::regex_search(result.out, std::regex("[^-]\\b" + name + "\\b")))
                << what << ": " << name;
        }
    }
    EXPECT_EQ(run("completions tcsh").status, 2);
    EXPECT_NE(run("manual").out.find(".B \\-o,\\-\\-output FILE\n"), std::string::npos);
}

/// With or without NO_COLOR. On a terminal progress replaces its line, elsewhere it is not shown.
TEST_F(ShellCommands, NothingIsColoured) {
    const std::string render = "render cubes --size 64x36 --frames 2";
    const ProgramResult plain = run(render);
    EXPECT_EQ((plain.out + plain.err).find('\x1b'), std::string::npos) << plain.out << plain.err;
    // script(1) gives the command a terminal.
    const ProgramResult onTerminal =
        run("--version > /dev/null; script -qec \"'" CDR_PROGRAM "' " + render + "\" /dev/null < /dev/null");
    if (onTerminal.status == 127) {
        GTEST_SKIP() << "no script(1): " << onTerminal.err;
    }
    const std::string& shown = onTerminal.out;
    EXPECT_NE(shown.find("1/2 cubes"), std::string::npos) << shown;
    for (std::size_t at = shown.find('\x1b'); at != std::string::npos; at = shown.find('\x1b', at + 1)) {
        EXPECT_EQ(shown.substr(at + 1, 2), "[K") << shown;
    }
}

TEST_F(ShellCommands, ViewHandsItsArgumentsToTheViewer) {
    const ProgramResult result = run("view --version", "PATH=/nowhere");
    if (result.status == 2 && result.err.find("cannot be started") != std::string::npos) {
        GTEST_SKIP() << "cdr-viewer is not built: " << result.err;
    }
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.out.substr(0, 11), "cdr-viewer ");
}

} // namespace

} // namespace cdr::cli_test
