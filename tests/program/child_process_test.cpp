#include "../support/temporary_folder.h"

#include <cdr/base/error.h>
#include <cdr/platform/file.h>

#include <gtest/gtest.h>
#include <program/child_process.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <string>
#include <thread>

namespace cdr::program {

namespace {

namespace fs = std::filesystem;

class ChildProcessTest : public testing::Test {
  protected:
    fs::path file(const std::string& name) const { return m_folder.path() / name; }

  private:
    cdr::test::TemporaryFolder m_folder;
};

std::string whatOf(const std::function<void()>& action) {
    try {
        action();
    } catch (const std::exception& error) {
        return error.what();
    }
    return "";
}

TEST_F(ChildProcessTest, StreamsItsInputToItsOutput) {
    platform::Bytes sent(3'000'000);
    for (std::size_t i = 0; i < sent.size(); ++i) {
        sent[i] = static_cast<std::uint8_t>(i * 7 + i / 251);
    }
    ChildProcess cat({"cat"}, {.file = file("out")});
    cat.write(std::span(sent).first(1'000'001));
    cat.write(std::span(sent).subspan(1'000'001));
    cat.finish();
    EXPECT_EQ(platform::readFile(file("out"), 1 << 24), sent);
}

TEST_F(ChildProcessTest, WhatIsNoProgramIsBadInput) {
    platform::writeText(file("notes"), "no program");
    for (const std::string& name : {std::string("/"), file("notes").string()}) {
        EXPECT_THROW(ChildProcess({name}, {}), base::InputError) << name;
    }
}

TEST_F(ChildProcessTest, AnOutputThatCannotBeWrittenIsNoMissingProgram) {
    const std::string said = whatOf([&] { ChildProcess({"cat"}, {.file = file("none/out")}); });
    EXPECT_TRUE(said.starts_with(file("none/out").string() + ": cannot be written: ")) << said;
}

/// No shell reads the arguments.
TEST_F(ChildProcessTest, ArgumentsArriveAsTheyAre) {
    ChildProcess({"printf", "%s", "a b'\"$HOME;`id`"}, {.file = file("out")}).finish();
    const platform::Bytes out = platform::readFile(file("out"), 1000);
    EXPECT_EQ(std::string(out.begin(), out.end()), "a b'\"$HOME;`id`");
}

/// Each must see the end of its input while the others' is still open.
/// Whoever starts it may hold signals back.
TEST_F(ChildProcessTest, ASignalEndsAChildOfAParentThatHoldsItBack) {
    sigset_t held;
    sigset_t before;
    ::sigemptyset(&held);
    ::sigaddset(&held, SIGTERM);
    ::pthread_sigmask(SIG_BLOCK, &held, &before);
    ChildProcess child({"sh", "-c", "kill -TERM $$; exit 0"}, {.file = {}});
    ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
    EXPECT_THROW(child.finish(), base::RunError);
}

TEST_F(ChildProcessTest, ChildrenDoNotHoldEachOthersInput) {
    ChildProcess first({"cat"}, {.file = file("1")});
    ChildProcess second({"cat"}, {.file = file("2")});
    const platform::Bytes text{'x'};
    first.write(text);
    first.finish();
    second.write(text);
    second.finish();
    EXPECT_EQ(platform::readFile(file("1"), 10), text);
    EXPECT_EQ(platform::readFile(file("2"), 10), text);
}

TEST_F(ChildProcessTest, FailureIsReportedInItsOwnWords) {
    ChildProcess failing({"ls", "/nowhere-at-all"}, {});
    EXPECT_NE(whatOf([&] { failing.finish(); }).find("nowhere-at-all"), std::string::npos);
}

TEST_F(ChildProcessTest, TheEndOfALongErrorIsQuoted) {
    ChildProcess failing({"sh", "-c", "printf '%01000d\\n' 0 >&2; echo cause >&2; exit 1"}, {});
    const std::string said = whatOf([&] { failing.finish(); });
    EXPECT_TRUE(said.ends_with("0\ncause")) << said;
    EXPECT_LT(said.size(), 500u);
}

TEST_F(ChildProcessTest, WritingToOneThatHasEndedIsAnError) {
    ChildProcess ended({"true"}, {});
    const platform::Bytes block(1 << 16);
    EXPECT_THROW(
        {
            for (int i = 0; i < 1000; ++i) {
                ended.write(block); // more than any buffer holds
            }
        },
        base::RunError);
}

TEST_F(ChildProcessTest, AMissingProgramIsBadInput) {
    EXPECT_THROW(ChildProcess({"no-such-program-cdr"}, {}), base::InputError);
    EXPECT_FALSE(isInstalled("no-such-program-cdr"));
    EXPECT_TRUE(isInstalled("cat"));
}

TEST_F(ChildProcessTest, OneThatIsNotWaitedForIsEnded) {
    std::string id;
    {
        const ChildProcess endless({"sh", "-c",
                                    "echo $$ >\"$0.new\"; mv \"$0.new\" \"$0\"; exec cat /dev/zero",
                                    file("id").string()},
                                   {});
        while (!fs::exists(file("id"))) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        std::ifstream(file("id")) >> id;
        ASSERT_EQ(::kill(std::stoi(id), 0), 0);
    }
    EXPECT_EQ(::kill(std::stoi(id), 0), -1);
}

TEST(ShellQuoted, GivesTheWordBackInAShell) {
    EXPECT_EQ(shellQuoted("plain-1.5e-7,x"), "plain-1.5e-7,x");
    EXPECT_EQ(shellQuoted(""), "''");
    EXPECT_EQ(shellQuoted("a b"), "'a b'");
    EXPECT_EQ(shellQuoted("it's"), "'it'\\''s'");
    EXPECT_EQ(shellQuoted("$(rm -rf ~)\n;`x`"), "'$(rm -rf ~)\n;`x`'");
    EXPECT_EQ(shellQuoted("~/a"), "'~/a'");
    // What a shell makes of them, by a shell.
    for (const std::string word : {"it's a $HOME \\ \"x\" `y`", "*", "a&b|c>d<e;f", "!x #y", "--", "ö"}) {
        const std::string command = "printf %s " + shellQuoted(word);
        FILE* pipe = popen(command.c_str(), "r");
        ASSERT_NE(pipe, nullptr);
        char read[256] = {};
        const std::size_t size = fread(read, 1, sizeof(read) - 1, pipe);
        pclose(pipe);
        EXPECT_EQ(std::string(read, size), word);
    }
}

} // namespace

} // namespace cdr::program
