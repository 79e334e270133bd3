#include "../support/fault.h"
#include "rank_test.h"

#include <cdr/platform/file.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <map>
#include <regex>
#include <string>
#include <vector>

namespace cdr::cli_test {
namespace {

namespace fs = std::filesystem;

/// The program as several ranks on this machine.
ProgramResult runAsRanks(int ranks, const std::string& arguments, const fs::path& folder) {
    return runProgram(arguments, folder, test::launched(CDR_MPIEXEC, ranks));
}

using RanksCommand = RankTest;
using Devices = FolderTest;

/// The numbers of ranks that divide what all commands divide by one mechanism: one of them, or all with CDR_ALL_CASES.
std::vector<int> usualCounts() {
    return takesAllCases() ? std::vector<int>{1, 2, 4} : std::vector<int>{3};
}

/// Whether so many ranks leave the files that one process leaves.
void expectSameFiles(const std::string& arguments, std::size_t fileCount,
                     const std::vector<int>& counts = usualCounts()) {
    const TemporaryFolder alone;
    cli_test::succeed(arguments, alone.path());
    const auto expected = filesIn(alone.path());
    EXPECT_EQ(expected.size(), fileCount);
    for (const int ranks : counts) {
        const TemporaryFolder folder;
        const ProgramResult several = runAsRanks(ranks, arguments, folder.path());
        EXPECT_EQ(several.status, 0) << several.err;
        const auto files = filesIn(folder.path());
        ASSERT_EQ(files.size(), expected.size()) << arguments << ", " << ranks << " ranks";
        for (const auto& [name, text] : expected) {
            EXPECT_TRUE(files.at(name) == text) << arguments << ", " << ranks << " ranks: " << name;
        }
    }
}

/// A fitted split keeps to the frames before, whoever renders them, and 16 bits of depth show where it cut.
TEST_F(RanksCommand, RenderWritesTheFilesOfOneProcess) {
    expectSameFiles(
        "render afc-near --depth standard --split fitted:1,max=2 --format d16 --size 160x90 --frames 24 "
        "-o f%03d.png --json all.json",
        25, {1, 2, 4});
    expectSameFiles(
        "render traffic --technique anchored --size 96x54 --frame 3 --frames 6 --aov distance -o f%02d.exr "
        "--json all.json",
        7);
}

/// Presets of each kind, two with many ranks, and with fitted splits that keep to the frames before. CDR_ALL_CASES takes every
/// preset.
TEST_F(RanksCommand, CascadesAreLaidOverEachOther) {
    const std::vector<int> few{2};
    const std::vector<int> all{1, 2, 3, 8};
    std::vector<std::pair<const char*, std::vector<int>>> presets{
        {"logcdr", few},
        {"cdr", takesAllCases() ? all : std::vector{8}},
        {"anchored", takesAllCases() ? all : std::vector{3}}};
    if (takesAllCases()) {
        presets.insert(presets.end(), {{"standard", few}, {"log", few}, {"reversed", few}});
    }
    for (const auto& [technique, counts] : presets) {
        expectSameFiles(
            std::string("render afc-near --ranks cascades --size 160x90 --frame 7 -o f%d.png --json all.json "
                        "--technique ") +
                technique,
            2, counts);
    }
    const std::string fitted =
        " afc-near --depth anchored --split fitted:0.1,max=4 --targets layers --size 160x90 "
        "--frames 3 --aov distance -o f%d.exr --json all.json";
    expectSameFiles("render --ranks cascades" + fitted, 4, {4});
    const TemporaryFolder frames;
    const TemporaryFolder cascades;
    cli_test::succeed("render --ranks frames" + fitted, frames.path());
    ASSERT_EQ(runAsRanks(3, "render --ranks cascades" + fitted, cascades.path()).status, 0);
    EXPECT_EQ(filesIn(frames.path()), filesIn(cascades.path()));
    expectSameFiles(
        "render traffic --ranks cascades --technique cdr --size 96x54 --frame 3 --frames 4 -o f%02d.png "
        "--json all.json",
        5, {3});
    expectSameFiles(
        "render mixed --ranks cascades --technique cdr --aov wrong --size 96x54 -o f.png --json all.json", 2,
        {2});
}

TEST_F(RanksCommand, CascadesThatCannotBeDividedAreRefusedInOneLine) {
    const auto expectUndivided = [](const ProgramResult& result, const std::string& what) {
        EXPECT_EQ(result.status, 2);
        EXPECT_EQ(result.err, "cdr: cascades cannot be divided: " + what + " need all of them\n");
    };
    const std::string render = "render --ranks cascades -o a.png --size 32x18 ";
    for (const auto& [arguments, what] :
         {std::pair("cubes --antialias edges", "smoothed edges"), std::pair("sheets", "blended materials"),
          std::pair("cubes --occlusion 2", "ambient occlusion over the whole picture"),
          std::pair("cubes --shadows plain", "shadows"),
          std::pair("cubes --occlusion-culling", "occlusion culling"),
          std::pair("cubes --aov linear", "pictures of linear light"),
          std::pair("cubes --submission gpu-driven", "gpu-driven draws")}) {
        expectUndivided(run(render + arguments), what);
    }
    expectUndivided(runAsRanks(2, render + "sheets", folder()), "blended materials");
    EXPECT_NE(run("render cubes --ranks cascade").err.find("did you mean 'cascades'"), std::string::npos);
    EXPECT_TRUE(folderIsEmpty());
}

TEST_F(RanksCommand, ScalingMeasuresRanksWhereToldTo) {
    const std::string small = " --draws 10000 --repeats 2 --json all.json";
    const ProgramResult swept =
        runAsRanks(3, "scaling --ranks --heights 360 --cascades 1,4" + small, folder());
    ASSERT_EQ(swept.status, 0) << swept.err;
    const auto points = jsonIn("all.json").at("results");
    ASSERT_EQ(points.size(), 6u);
    for (std::size_t i = 0; i < 6; ++i) {
        const auto& point = points[i];
        const std::size_t ranks = std::vector<std::size_t>{1, 2, 3}[i % 3];
        EXPECT_EQ(point.at("ranks"), ranks);
        EXPECT_EQ(point.at("cascades"), i < 3 ? 1 : 4);
        EXPECT_EQ(point.at("same_image"), true);
        EXPECT_TRUE(point.at("speedup_ci95").is_null()) << "two repeats have no interval";
        ASSERT_EQ(point.at("shares").size(), ranks);
        // Only a rank that has cascades and is not the first has anything to send.
        EXPECT_EQ(point.at("bytes_sent") > 1000, i > 3) << point;
    }
    EXPECT_LT(points[5].at("most_device_bytes"), points[3].at("most_device_bytes"));

    const ProgramResult projected = runAsRanks(2, "scaling --project 1000 --size 160x90" + small, folder());
    ASSERT_EQ(projected.status, 0) << projected.err;
    const auto document = jsonIn("all.json");
    EXPECT_EQ(document.at("results").size(), 11u);
    EXPECT_EQ(document.at("results").back().at("nodes"), 1000);
    EXPECT_EQ(document.at("check").at("frames"), 24);
    EXPECT_GT(document.at("costs").at("send_ms"), 0.0);
    EXPECT_TRUE(document.at("check").at("predicted_interval").is_null());
    EXPECT_NE(projected.out.find("(a 95 % interval needs 6 frames)"), std::string::npos) << projected.out;
    const auto alone = documentOf("scaling --project 4 --size 16x16 --draws 1 --repeats 1");
    EXPECT_EQ(alone.at("costs").at("send_ms"), nullptr); // nothing to measure
    EXPECT_EQ(alone.at("costs").at("claim_ms"), nullptr);

    EXPECT_EQ(
        runAsRanks(2, "scaling --draws 300", folder()).err,
        "cdr: scaling without --ranks or --project runs in one process, and not as 2 ranks: start it without "
        "mpirun\n");
    EXPECT_EQ(run("scaling --ranks --draws 1,2").err,
              "cdr: scaling --ranks and --project take one number of --draws\n");
}

TEST_F(RanksCommand, FlickerFindsWhatOneProcessDoes) {
    expectSameFiles(
        "flicker --frames 21 --size 96x54 --near-object --techniques standard,anchored --fitted-range --format d16 "
        "--flip-every 2 --tga tga --json all.json",
        1 + 3 * 21);
}

TEST_F(RanksCommand, FlickerWritesTheVideosOfOneProcess) {
    if (run("flicker --frames 1 --size 128x72 --techniques standard,log --videos v")
            .err.find("need ffmpeg") != std::string::npos) {
        GTEST_SKIP() << "ffmpeg is not installed";
    }
    expectSameFiles("flicker --frames 9 --size 128x72 --techniques standard,log --videos v --json all.json",
                    3, {3});
}

TEST_F(RanksCommand, RivalsAreMeasuredAsInOneProcess) {
    if (!deviceInfo().hasInt64Atomics || !deviceInfo().hasFragmentStores) {
        GTEST_SKIP() << "the device has no 64-bit atomics";
    }
    expectSameFiles("probe --distances 10,1e3 --techniques anchored --formats d32f --size 96x54 "
                    "--rivals two-float,object-anchors --json all.json",
                    1, {3});
    expectSameFiles(
        "flicker --frames 9 --size 96x54 --techniques log --rivals two-float,object-anchors/prepass "
        "--tga tga --json all.json",
        1 + 9, {3});
}

/// A model with levels; RankState has a scene without.
TEST_F(RanksCommand, DetailComparesWhatOneProcessDoes) {
    expectSameFiles("detail " CDR_SOURCE_DIR
                    "/tests/golden/spheres.gltf --frames 2 --size 96x54 --out out --json all.json",
                    1 + 2 * 5, {2});
}

/// Where memory is short; RankState has a run with enough.
TEST_F(RanksCommand, TranslucencyComparesWhatOneProcessDoes) {
    const std::string refused =
        "translucency --size 320x180 --cascades 3 --repeats 0 --translucency-memory 1 --json all.json";
    const TemporaryFolder alone;
    cli_test::succeed(refused, alone.path());
    EXPECT_NE(runAsRanks(3, refused, folder()).out.find("\n3 cascades drawn weighted: "), std::string::npos);
    EXPECT_EQ(filesIn(folder()), filesIn(alone.path()));
}

/// What measures time is left out, and so are the manifest and the page, which say how long sections took.
TEST_F(RanksCommand, ReportHoldsWhatOneProcessFinds) {
    const TemporaryFolder alone;
    const std::string report = "report --smallest -o r --sections advise,pictures,probe,inspect,timing,"
                               "certificates-mixed";
    const ProgramResult one = runProgram(report, alone.path());
    if (lacksPage(one)) {
        GTEST_SKIP() << kNoPage;
    }
    const ProgramResult three = runAsRanks(3, report, folder());
    EXPECT_EQ(three.status, one.status) << three.err;
    EXPECT_EQ(three.err, one.err);
    const auto expected = filesIn(alone.path());
    const auto files = filesIn(folder());
    ASSERT_GT(expected.size(), 30u);
    ASSERT_EQ(files.size(), expected.size());
    const std::regex isTimed("r/(report.json|data.js|data/(timing|certificates-[a-z-]+).json)");
    for (const auto& [name, text] : expected) {
        ASSERT_TRUE(files.contains(name)) << name;
        EXPECT_TRUE(std::regex_match(name, isTimed) || files.at(name) == text) << name;
    }
    const auto manifest = [](const fs::path& in) {
        auto rows = nlohmann::json::parse(readText(in / "r/report.json")).at("results");
        for (auto& row : rows) {
            row.erase("seconds");
        }
        return rows;
    };
    EXPECT_EQ(manifest(folder()), manifest(alone.path()));
}

TEST_F(RanksCommand, OnlyTheFirstPrints) {
    const ProgramResult one = run("precision");
    const ProgramResult three = runAsRanks(3, "precision", folder());
    EXPECT_EQ(three.status, 0) << three.err;
    EXPECT_EQ(three.out, one.out);
    for (const char* arguments : {"--help", "manual", "completions fish"}) {
        EXPECT_EQ(runAsRanks(3, arguments, folder()).out, run(arguments).out);
    }
    EXPECT_NE(runAsRanks(3, "render cubes --size 32x18", folder())
                  .out.find("3 ranks, 3 of them on this machine; lavapipe draws with "),
              std::string::npos);
}

TEST_F(RanksCommand, BadInputIsOneLine) {
    for (const char* arguments : {"render nosuch", "render cubes --size 0x0", "render cubes -o missing/a.png",
                                  "render cubes --device each --format d17",
                                  "flicker --frames 2 --size 32x18 --state missing/state.json"}) {
        const ProgramResult one = run(arguments);
        const ProgramResult three = runAsRanks(3, arguments, folder());
        EXPECT_EQ(three.status, 2) << arguments;
        EXPECT_EQ(three.err, one.err) << arguments;
        EXPECT_EQ(three.out.find("cascades"), std::string::npos) << three.out;
    }
    EXPECT_TRUE(folderIsEmpty());
}

TEST_F(RanksCommand, WhatMeasuresTimeSharesNoMachineUnlessTold) {
    for (const std::string name : {"timing", "effects", "focus"}) {
        const ProgramResult result = runAsRanks(2, name + " --json all.json", folder());
        EXPECT_EQ(result.status, 2) << name;
        EXPECT_EQ(result.err, "cdr: " + name +
                                  " measures time, and 2 ranks share this machine: start one on each, or add "
                                  "--share-machine\n");
    }
    for (const std::string name : {"inspect cubes", "timing --memory", "view cubes"}) {
        const ProgramResult result = runAsRanks(2, "--share-machine " + name, folder());
        EXPECT_EQ(result.status, 2) << name;
        EXPECT_NE(result.err.find(" runs in one process, and not as 2 ranks: start it without mpirun\n"),
                  std::string::npos)
            << result.err;
    }
    // The launcher's variables are there for one rank, too.
    const ProgramResult one = runAsRanks(1, "timing --against '" CDR_PROGRAM "'", folder());
    EXPECT_EQ(one.status, 2);
    EXPECT_EQ(one.err, "cdr: timing --against starts programs that would join this run of ranks: start it "
                       "without mpirun\n");
    EXPECT_TRUE(folderIsEmpty());
}

/// Of every unit one rank. The first rank's draws are counted in it too, and are those of one process.
void expectTimedByAll(const std::string& arguments, const std::string& units, std::size_t count) {
    const TemporaryFolder folder;
    const std::string command = arguments + " --size 64x36 --json all.json";
    succeed(command, folder.path());
    const auto alone = nlohmann::json::parse(readText(folder.path() / "all.json"));
    EXPECT_FALSE(alone.contains("measured_by"));
    const ProgramResult two = runAsRanks(2, "--share-machine " + command, folder.path());
    ASSERT_EQ(two.status, 0) << two.err;
    const auto document = nlohmann::json::parse(readText(folder.path() / "all.json"));
    std::map<std::size_t, std::size_t> rankOf;
    for (const auto& row : document.at("measured_by")) {
        EXPECT_EQ(row.at("ranks_on_node"), 2);
        EXPECT_NE(row.at("node"), "");
        EXPECT_LT(row.at("rank"), 2);
        for (const auto& unit : row.at(units)) {
            EXPECT_TRUE(rankOf.emplace(unit, row.at("rank")).second) << unit;
        }
    }
    ASSERT_EQ(rankOf.size(), count) << document.at("measured_by");
    EXPECT_EQ(rankOf.rbegin()->first, count - 1);
    ASSERT_EQ(document.at("results").size(), alone.at("results").size());
    for (std::size_t i = 0; i < alone.at("results").size(); ++i) {
        for (const char* same : {"mode", "name", "cascades", "draws", "differing", "flip", "rmse"}) {
            EXPECT_EQ(document["results"][i].value(same, nlohmann::json()),
                      alone["results"][i].value(same, nlohmann::json()))
                << same;
        }
    }
}

TEST_F(RanksCommand, WhatIsTimedTogetherSaysWhoTimedWhat) {
    expectTimedByAll("timing --frames 4 --modes anchored,cdr-2", "frames", 4);
    expectTimedByAll("timing --frames 20 --modes anchored --in-flight 2", "runs", 3);
    if (takesAllCases()) { // its frames are divided as those of any scene
        expectTimedByAll("timing --frames 3 --modes anchored --scene traffic", "frames", 3);
    }
    expectTimedByAll("timing --frames 3 --stages", "frames", 3);
    expectTimedByAll("effects --frames 3", "frames", 3);
    expectTimedByAll("focus --frames 3 --cameras 2", "frames", 3);
}

/// Whichever draw of whichever frame fails, before or after a merge.
TEST_F(RanksCommand, ADeviceLostAmongCascadesEndsAllInOneLine) {
    const std::string script = folder().string() + ".sh";
    for (const int rank : {0, 1, 3}) {
        for (const long after : {0, 1, 3}) {
            if (!takesAllCases() && after != rank && rank + after != 3) {
                continue;
            }
            const test::Fault fault{.call = "vkQueueSubmit2", .after = after};
            platform::writeText(script, "[ \"$OMPI_COMM_WORLD_RANK$PMI_RANK\" != " + std::to_string(rank) +
                                            " ] || export " + fault.environment() + "\nexec \"$@\"\n");
            const ProgramResult result = run(
                "render afc-near --depth standard --split count:4 --ranks cascades --frames 4 --size 64x36 "
                "-o f%d.png --json a.json",
                "timeout 1200 env " + test::launched(CDR_MPIEXEC, 4) + " sh '" + script + "'");
            EXPECT_EQ(result.status, 1) << rank << " " << after;
            const std::string by = rank == 0 ? "" : "rank " + std::to_string(rank) + " on .+: ";
            EXPECT_TRUE(
                std::regex_match(result.err, std::regex("cdr: " + by + "the Vulkan device was lost.*\n")))
                << rank << " " << after << ": " << result.err;
            EXPECT_FALSE(fs::exists(at("a.json")));
        }
    }
    fs::remove(script);
}

/// With a machine of one device they all take that.
TEST_F(RanksCommand, DealOutTheDevicesOfAMachineUnderValidation) {
    expectSameFiles(
        "--device each --validate render cubes --size 64x36 --frames 3 -o f%d.png --json all.json", 4, {2});
}

/// A job's scripts, as Slurm would start them.
TEST_F(RanksCommand, JobsOfSlurmRun) {
    const auto runJob = [&](const std::string& command) {
        return std::system(("cd '" + folder().string() + "' && CDR='" CDR_PROGRAM "' " + command + " >'" +
                            folder().string() + ".log' 2>&1")
                               .c_str());
    };
    const std::string jobs = "'" CDR_SOURCE_DIR "/tools/slurm/";
    EXPECT_EQ(runJob("SLURM_ARRAY_TASK_ID=3 " + jobs + "sweep.sh' out --size 64x36 --techniques reversed"),
              0);
    const auto row = jsonIn("out/probe_3.json").at("results").at(0);
    EXPECT_EQ(row.at("distance"), 1000.0);
    EXPECT_NE(runJob(jobs + "sweep.sh' out"), 0);

    const std::string launcher = test::launched(CDR_MPIEXEC, 2);
    const std::string environment = launcher.substr(0, launcher.find('\''));
    EXPECT_EQ(runJob("MPIRUN='" CDR_MPIEXEC "' " + environment + jobs +
                     "frames.sh' cubes frames/%02d.png --size 32x18 --frames 2"),
              0)
        << readText(folder().string() + ".log");
    EXPECT_TRUE(fs::exists(at("frames/01.png")));
    EXPECT_NE(runJob(jobs + "frames.sh' cubes"), 0);
    fs::remove(folder().string() + ".log");
}

TEST_F(Devices, SayWhetherMpiIsIn) {
    const ProgramResult result = run("devices --json");
    const auto mpi = nlohmann::json::parse(result.out).at("mpi");
    EXPECT_EQ(mpi.is_null(), std::string(CDR_MPIEXEC).empty());
    EXPECT_NE(result.err.find(mpi.is_null() ? "built without MPI" : "built with " + mpi.get<std::string>()),
              std::string::npos);
}

} // namespace
} // namespace cdr::cli_test
