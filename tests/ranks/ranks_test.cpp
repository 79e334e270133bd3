#include "../support/all_cases.h"
#include "../support/launched.h"
#include "../support/shell.h"
#include "../support/temporary_folder.h"

#include <gtest/gtest.h>
#include <ranks/join.h>
#include <ranks/unit_order.h>

#include <algorithm>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace cdr::ranks {
namespace {

using Outcome = test::ShellResult;

Outcome runAs(int ranks, const std::string& arguments) {
    const test::TemporaryFolder folder;
    const std::string out = (folder.path() / "out").string();
    const std::string err = (folder.path() / "err").string();
    return {.status = test::statusOf("timeout 1200 env " + test::launched(CDR_MPIEXEC, ranks) +
                                     " '" RANK_PROGRAM "' " + arguments + " >'" + out + "' 2>'" + err +
                                     "' </dev/null"),
            .out = test::readText(out),
            .err = test::withoutWarningsOfEvents(test::readText(err))};
}

std::string whatOneProcessPrints(std::size_t count) {
    return runAs(0, std::to_string(count)).out;
}

/// MPICH's launcher kills all ranks when it sees one gone, so a busy machine may leave no time to say who it was.
bool killsAtOnce() {
    return mpiLibrary().starts_with("MPICH");
}

class LaunchedRanks : public testing::TestWithParam<int> {
  protected:
    void SetUp() override {
        if (std::string(CDR_MPIEXEC).empty()) {
            GTEST_SKIP() << "built without MPI (libopenmpi-dev, openmpi-bin), or under ThreadSanitizer";
        }
    }
};

/// One, two, and as many as meet in a tree of three levels; with CDR_ALL_CASES a whole tree too.
INSTANTIATE_TEST_SUITE_P(Counts, LaunchedRanks,
                         testing::ValuesIn(test::takesAllCases() ? std::vector{1, 2, 7, 4}
                                                                 : std::vector{1, 2, 7}));

/// They merge first what they hold, in the order of the ranks, though they meet in a tree.
TEST_P(LaunchedRanks, HandOverEveryUnitOnceAndInOrder) {
    for (const std::size_t count : {0u, 3u, 40u}) {
        const Outcome outcome = runAs(GetParam(), std::to_string(count));
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        EXPECT_EQ(outcome.err, "");
        EXPECT_TRUE(outcome.out.starts_with("merged whole\n")) << outcome.out;
        EXPECT_EQ(outcome.out, whatOneProcessPrints(count));
    }
}

/// None waits for it.
TEST_P(LaunchedRanks, EndWhereOneCannotMerge) {
    if (GetParam() == 1) {
        GTEST_SKIP() << "needs another rank";
    }
    const std::string last = std::to_string(GetParam() - 1);
    const Outcome packs = runAs(GetParam(), "0 pack " + last + " 0");
    EXPECT_EQ(packs.status, 1);
    EXPECT_TRUE(std::regex_match(packs.err, std::regex("rank " + last + " on .+: it broke\n"))) << packs.err;
    const Outcome lays = runAs(GetParam(), "0 lay 0 0");
    EXPECT_EQ(lays.status, 2);
    EXPECT_EQ(lays.err, "no such thing\n");
    if (GetParam() > 3) {
        const Outcome inTree = runAs(GetParam(), "0 lay 2 0");
        EXPECT_EQ(inTree.status, 2);
        EXPECT_TRUE(std::regex_match(inTree.err, std::regex("rank 2 on .+: no such thing\n"))) << inTree.err;
    }
}

/// What goes wrong on the last rank, with the status and the end of the line.
TEST_P(LaunchedRanks, EndAsTheOneThatFailed) {
    struct Case {
        const char* kind;
        int status;
        const char* line;
    };
    const int last = GetParam() - 1;
    for (const Case& each :
         {Case{"input", 2, "no such thing"}, Case{"run", 1, "it broke"}, Case{"start", 2, "cannot start"},
          Case{"before", 2, "cannot begin"}, Case{"after", 1, "cannot end"}}) {
        const Outcome outcome =
            runAs(GetParam(), "60 " + std::string(each.kind) + " " + std::to_string(last) + " 5");
        EXPECT_EQ(outcome.status, each.status) << each.kind;
        const std::string by = last == 0 ? "" : "rank " + std::to_string(last) + " on .+: ";
        EXPECT_TRUE(std::regex_match(outcome.err, std::regex(by + each.line + "\n")))
            << each.kind << ": " << outcome.err;
    }
}

TEST_P(LaunchedRanks, EndWhereTheFirstCannotTakeAUnit) {
    const Outcome outcome = runAs(GetParam(), "60 take 0 20");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.err, "the disk is full\n");
    EXPECT_EQ(outcome.out, whatOneProcessPrints(60).substr(0, outcome.out.size()));
    EXPECT_NE(outcome.out.find("\n19 "), std::string::npos) << outcome.out;
    EXPECT_EQ(outcome.out.find("\n20 "), std::string::npos) << outcome.out;
}

TEST_P(LaunchedRanks, RefuseOneThatWasStartedOtherwise) {
    const int last = GetParam() - 1;
    const Outcome outcome = runAs(GetParam(), "3 differ " + std::to_string(last) + " 0");
    EXPECT_EQ(outcome.status, last == 0 ? 0 : 2);
    EXPECT_TRUE(last == 0 || outcome.err.find(": is not alike\n") != std::string::npos) << outcome.err;
}

/// The others wait for the text that theirs is compared with.
TEST_P(LaunchedRanks, EndWhereTheFirstCannotStart) {
    const Outcome outcome = runAs(GetParam(), "3 start 0 0");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.err, "cannot start\n");
}

/// What lines of standard error say of one rank. MPI may add lines of its own, and one of these may begin while another
/// process writes a line in pieces.
std::vector<std::string> linesOnRanks(const std::string& text) {
    static const std::regex kLine("rank [0-9]+ of [0-9]+ on [^\n]*");
    const std::sregex_iterator first(text.begin(), text.end(), kLine);
    std::vector<std::string> lines;
    std::transform(first, std::sregex_iterator(), std::back_inserter(lines),
                   [](const std::smatch& match) { return match.str(); });
    return lines;
}

/// One of those that are left says who it was, where there is one.
TEST_P(LaunchedRanks, EndWhereOneIsKilled) {
    for (const int rank : std::set{0, GetParam() / 2, GetParam() - 1}) {
        const Outcome outcome = runAs(GetParam(), "60 die " + std::to_string(rank) + " 30");
        EXPECT_NE(outcome.status, 0);
        // MPICH's launcher puts a frame of "=" into what the ranks print.
        const std::string out = outcome.out.substr(0, outcome.out.find("\n====="));
        EXPECT_EQ(out, whatOneProcessPrints(60).substr(0, out.size()));
        const std::vector<std::string> lines = linesOnRanks(outcome.err);
        if (GetParam() == 1 || (killsAtOnce() && lines.empty())) {
            EXPECT_TRUE(lines.empty()) << outcome.err;
            continue;
        }
        ASSERT_EQ(lines.size(), 1u) << outcome.err;
        EXPECT_TRUE(std::regex_match(lines.front(), std::regex("rank " + std::to_string(rank) + " of " +
                                                               std::to_string(GetParam()) +
                                                               " on .+ was killed; nothing is kept")))
            << lines.front();
    }
}

TEST_P(LaunchedRanks, EndWhereOneCrashes) {
    if (GetParam() != 2 && GetParam() != 4) {
        GTEST_SKIP() << "two and four ranks are tried";
    }
    const std::string last = std::to_string(GetParam() - 1);
    for (const auto& [kind, cause] :
         {std::pair("segv", "segmentation fault"), std::pair("overflow", "segmentation fault"),
          std::pair("terminate", "aborted"), std::pair("bus", "bus error"),
          std::pair("fpe", "arithmetic error"), std::pair("ill", "illegal instruction")}) {
        const Outcome outcome = runAs(GetParam(), "60 " + std::string(kind) + " " + last + " 30");
        EXPECT_NE(outcome.status, 0);
        const std::vector<std::string> lines = linesOnRanks(outcome.err);
        if (killsAtOnce() && lines.empty()) {
            continue;
        }
        ASSERT_EQ(lines.size(), 1u) << kind << ": " << outcome.err;
        EXPECT_TRUE(std::regex_match(lines.front(), std::regex("rank " + last + " of .+ on .+ crashed [(]" +
                                                               cause + "[)]; nothing is kept")))
            << lines.front();
    }
}

/// A launcher asks all ranks to end as soon as one is killed. A rank that is asked waits until the killed one is named. On a
/// busy machine it may not wait long enough.
TEST_P(LaunchedRanks, NameTheOneThatWasKilledAndNotTheOneThatWasAskedThen) {
    if (GetParam() == 1) {
        GTEST_SKIP() << "needs another rank";
    }
    std::vector<std::string> all;
    for (int attempt = 0; attempt < 5; ++attempt) {
        const Outcome outcome = runAs(GetParam(), "60 both " + std::to_string(GetParam() - 1) + " 30");
        const std::vector<std::string> lines = linesOnRanks(outcome.err);
        if (killsAtOnce() && lines.empty()) {
            return;
        }
        ASSERT_EQ(lines.size(), 1u) << outcome.err;
        if (lines.front().ends_with(" was killed; nothing is kept")) {
            return;
        }
        all.push_back(lines.front());
    }
    FAIL() << all.front();
}

/// What the first rank holds until an earlier unit comes has a bound. All units are several times as many.
TEST_P(LaunchedRanks, BeginNoUnitFarAheadOfOneThatIsLate) {
    const test::TemporaryFolder folder;
    const Outcome outcome = runAs(GetParam(), "400 tarry 0 0 '" + (folder.path() / "begun").string() + "'");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    std::smatch found;
    std::string out = outcome.out;
    std::size_t rounds = 0;
    for (; std::regex_search(out, found, std::regex("meanwhile ([0-9]+)\n")); out = found.suffix()) {
        EXPECT_LT(std::stoul(found[1]), 8u * static_cast<unsigned>(GetParam()));
        ++rounds;
    }
    EXPECT_EQ(rounds, 2u);
}

/// The one that was asked says so. Those that its launcher asks then do not.
TEST_P(LaunchedRanks, EndWhereOneIsAskedTo) {
    const int last = GetParam() - 1;
    for (const std::string signal : {"HUP", "INT", "TERM"}) {
        if (last == 0 && signal == "HUP") {
            continue; // a rank that is alone leaves signals to MPI, and MPICH's takes this one
        }
        const Outcome outcome = runAs(GetParam(), "3000 " + signal + " " + std::to_string(last) + " 30");
        EXPECT_NE(outcome.status, 0);
        const std::vector<std::string> lines = linesOnRanks(outcome.err);
        if (last == 0) { // of one rank the launcher says it
            EXPECT_TRUE(lines.empty()) << outcome.err;
            continue;
        }
        ASSERT_EQ(lines.size(), 1u) << signal << ": " << outcome.err;
        EXPECT_TRUE(std::regex_match(lines.front(), std::regex("rank " + std::to_string(last) +
                                                               " of .+ on .+ was asked to end by SIG" +
                                                               signal + "; nothing is kept")))
            << lines.front();
    }
}

/// As under nohup.
TEST_P(LaunchedRanks, GoOnAfterASignalThatIsIgnored) {
    const Outcome outcome = runAs(GetParam(), "60 ignore " + std::to_string(GetParam() - 1) + " 30");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(outcome.out, whatOneProcessPrints(60));
}

TEST(WhatRanksSay, IsAllButTheWarningsOfEvents) {
    const std::string warning =
        "[warn] Epoll MOD(1) on fd 25 failed. Old events were 6; read change was 0 (none): Bad file descriptor\n";
    EXPECT_EQ(
        test::withoutWarningsOfEvents(warning + "rank 2: a\n" + warning + warning + "[warn] other\nend"),
        "rank 2: a\n[warn] other\nend");
    EXPECT_EQ(test::withoutWarningsOfEvents("\n\n"), "\n\n");
    EXPECT_EQ(test::withoutWarningsOfEvents(warning), "");
}

TEST(UnitOrder, WaitsForTheUnitThatIsMissing) {
    UnitOrder order;
    std::vector<std::size_t> taken;
    const auto take = [&](std::size_t unit, const platform::Bytes& made) {
        EXPECT_EQ(made, platform::Bytes{static_cast<std::uint8_t>(unit)});
        taken.push_back(unit);
    };
    order.put(2, {2});
    order.put(1, {1});
    order.handOn(take);
    EXPECT_TRUE(taken.empty());
    order.put(0, {0});
    order.put(4, {4});
    order.handOn(take);
    EXPECT_EQ(taken, (std::vector<std::size_t>{0, 1, 2}));
    EXPECT_EQ(order.done(), 3u);
}

TEST(OneProcess, IsFirstAndAloneWithoutALauncher) {
    const std::unique_ptr<ranks::Run> ranks =
        join([](const std::exception_ptr&) { return Ending{}; }, [](const std::string&) {});
    EXPECT_TRUE(ranks->isFirst());
    EXPECT_TRUE(ranks->isAlone());
    EXPECT_EQ(ranks->share({7}), platform::Bytes{7});
    EXPECT_EQ(ranks->end({.status = 3}).status, 3);
}

} // namespace
} // namespace cdr::ranks
