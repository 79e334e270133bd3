#include "rank_test.h"

#include <cdr/platform/thread_placement.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <map>
#include <regex>
#include <string>
#include <utility>
#include <vector>

namespace cdr::cli_test {
namespace {

using CpuList = std::vector<std::size_t>;

class RankMachine : public RankTest {
  protected:
    /// For tests that bind ranks apart.
    static bool hasOneCpu() { return platform::allowedCpus().size() < 2; }
};

/// For a shell: two ranks, of which each may use those CPUs alone, as if MPI had bound it.
std::string boundTo(const std::string& ofFirst, const std::string& ofSecond) {
    return test::launched(CDR_MPIEXEC, 2) +
           " sh -c 'case $OMPI_COMM_WORLD_RANK$PMI_RANK in 0) cpus=" + ofFirst + ";; *) cpus=" + ofSecond +
           ";; esac; exec taskset --cpu-list $cpus \"$@\"' sh";
}

std::string listText(const CpuList& cpus) {
    std::string text;
    for (const std::size_t cpu : cpus) {
        text.append(text.empty() ? "" : ",").append(std::to_string(cpu));
    }
    return text;
}

struct TimedRun {
    std::string choice;
    std::map<std::size_t, CpuList> cpus{}; ///< by rank that timed a frame
    std::string line;                      ///< the first that was printed
    std::size_t hostCpus = 0;
};

TimedRun timeAs(const std::string& launcher, const std::string& option = "") {
    const TemporaryFolder folder;
    const ProgramResult result = succeed("--share-machine " + option +
                                             " timing --frames 9 --modes anchored --size 64x36 --json a.json",
                                         folder.path(), launcher);
    const auto document = nlohmann::json::parse(readText(folder.path() / "a.json"));
    TimedRun run{.choice = document.at("cpu_choice"),
                 .line = result.out.substr(0, result.out.find('\n')),
                 .hostCpus = document.at("host").at("cpus")};
    for (const auto& row : document.at("measured_by")) {
        run.cpus[row.at("rank")] = row.at("cpus").get<CpuList>();
    }
    return run;
}

TEST_F(RankMachine, RanksThatAreNotBoundShareItsProcessors) {
    const CpuList all = platform::allowedCpus();
    const TimedRun free = timeAs(test::launched(CDR_MPIEXEC, 3));
    EXPECT_EQ(free.choice, "shared");
    ASSERT_FALSE(free.cpus.empty());
    for (const auto& [rank, cpus] : free.cpus) {
        EXPECT_EQ(cpus, all) << rank;
    }
    EXPECT_NE(free.line.find("; they share " + std::to_string(all.size()) + " processor"), std::string::npos)
        << free.line;
    EXPECT_EQ(free.line.find("keeps to"), std::string::npos);

    const TimedRun bound = timeAs(test::launched(CDR_MPIEXEC, 2), "--bind");
    EXPECT_EQ(bound.choice, "shared");
    EXPECT_TRUE(bound.line.ends_with(", and each keeps to its part")) << bound.line;
    ASSERT_FALSE(bound.cpus.empty());
    for (const auto& [rank, cpus] : bound.cpus) {
        const std::size_t half = all.size() / 2;
        const CpuList expected = all.size() == 1 ? all
                                 : rank == 0     ? CpuList(all.begin(), all.begin() + static_cast<long>(half))
                                                 : CpuList(all.begin() + static_cast<long>(half), all.end());
        EXPECT_EQ(cpus, expected) << rank;
    }
}

/// A machine has more CPUs than a job may use.
TEST_F(RankMachine, WhatTheRanksMayNotUseIsNotDivided) {
    const std::string last = std::to_string(platform::allowedCpus().back());
    const ProgramResult result =
        succeed("--bind render cubes --size 32x18 --json a.json",
                "taskset --cpu-list " + last + " env " + test::launched(CDR_MPIEXEC, 3));
    EXPECT_EQ(
        result.out.substr(0, result.out.find('\n')),
        "3 ranks, 3 of them on this machine; lavapipe draws with 1 thread in each; they share 1 processor, "
        "and each keeps to its part");
    EXPECT_EQ(jsonIn("a.json").at("host").at("cpus"), 1);
}

TEST_F(RankMachine, WhatMpiBoundIsFollowed) {
    if (hasOneCpu()) {
        GTEST_SKIP() << "needs two CPUs";
    }
    const CpuList all = platform::allowedCpus();
    const std::string first = std::to_string(all.front());
    const std::string second = std::to_string(all.back());
    for (const char* option : {"", "--bind"}) {
        const TimedRun apart = timeAs(boundTo(first, second), option);
        EXPECT_EQ(apart.choice, "followed");
        EXPECT_EQ(apart.hostCpus, 1u) << "that the first rank had";
        EXPECT_TRUE(
            apart.line.ends_with("; lavapipe draws with 1 thread in each; MPI bound each to its own of 2 "
                                 "processors"))
            << apart.line;
        ASSERT_FALSE(apart.cpus.empty());
        for (const auto& [rank, cpus] : apart.cpus) {
            EXPECT_EQ(cpus, CpuList{rank == 0 ? all.front() : all.back()});
        }
    }
    const TimedRun overlapping = timeAs(boundTo(first, first + "," + second), "--bind");
    EXPECT_EQ(overlapping.choice, "overlapping");
    EXPECT_TRUE(
        overlapping.line.ends_with("; MPI bound them to overlapping parts of 2 processors, and each keeps "
                                   "to its part"))
        << overlapping.line;
    ASSERT_FALSE(overlapping.cpus.empty());
    for (const auto& [rank, cpus] : overlapping.cpus) {
        EXPECT_EQ(cpus, CpuList{rank == 0 ? all.front() : all.back()});
    }
}

/// The first rank alone measures times, and JSON names no other rank.
TEST_F(RankMachine, JsonOfTimesCountsTheProcessorsOfTheRankThatTimed) {
    if (hasOneCpu()) {
        GTEST_SKIP() << "needs two CPUs";
    }
    const std::string first = std::to_string(platform::allowedCpus().front());
    for (const char* command : {"detail cubes --frames 1", "translucency --cascades 1 --repeats 1"}) {
        succeed(std::string(command) + " --size 64x36 --json a.json", boundTo(first, first));
        EXPECT_EQ(jsonIn("a.json").at("host").at("cpus"), 1);
    }
}

TEST_F(RankMachine, ARankThatCannotBeBoundIsNamed) {
    if (hasOneCpu() || std::string(CDR_FILE_FAULTS).empty()) {
        GTEST_SKIP() << "needs two CPUs, and a build without sanitizers";
    }
    const ProgramResult result =
        run("--bind render cubes --size 32x18 -o a.png",
            test::launched(CDR_MPIEXEC, 2) +
                " sh -c '[ $OMPI_COMM_WORLD_RANK$PMI_RANK = 0 ] || export CDR_AFFINITY_FAULT=1 " +
                preloading(CDR_FILE_FAULTS) + "; exec \"$@\"' sh");
    EXPECT_EQ(result.status, 1);
    EXPECT_TRUE(std::regex_match(
        result.err,
        std::regex(
            "cdr: rank 1 on .+: --bind: the system does not allow this rank to use processors? [0-9, ]+\n")))
        << result.err;
    EXPECT_TRUE(folderIsEmpty());
}

/// Times apart: JSON says how many CPUs one process would have.
TEST_F(RankMachine, BoundRanksLeaveTheBytesOfOneProcess) {
    if (hasOneCpu()) {
        GTEST_SKIP() << "needs two CPUs";
    }
    const auto filesOf = [](const std::string& launcher, const std::string& option) {
        const TemporaryFolder folder;
        cli_test::succeed(
            option + " render afc --technique anchored --size 64x36 --frames 4 -o f%d.png --json a.json",
            folder.path(), launcher);
        return filesIn(folder.path());
    };
    const auto alone = filesOf("", "");
    ASSERT_EQ(alone.size(), 5u);
    const std::string all = listText(platform::allowedCpus());
    for (const auto& [launcher, option] :
         {std::pair(test::launched(CDR_MPIEXEC, 2) + " --bind-to core", ""),
          std::pair(test::launched(CDR_MPIEXEC, 1) + " --bind-to core", "--bind"),
          std::pair(test::launched(CDR_MPIEXEC, 2), "--bind"),
          std::pair(boundTo(all.substr(0, all.find(',')), all), "--bind")}) {
        EXPECT_TRUE(filesOf(launcher, option) == alone) << launcher;
    }
}

} // namespace
} // namespace cdr::cli_test
