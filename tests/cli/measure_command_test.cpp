#include "program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

namespace cdr::cli_test {

namespace {

using nlohmann::json;
using TimingCommand = FolderTest;
using ScalingCommand = FolderTest;
using RenderCommand = FolderTest;
using ProbeCommand = FolderTest;

std::size_t lineCount(const std::string& text) {
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

/// Names of a trace's tracks, each with how many events it holds.
std::map<std::string, int> tracksOf(const json& trace) {
    std::map<int, std::string> names;
    for (const json& event : trace.at("traceEvents")) {
        if (event.at("name") == "thread_name") {
            names[event.at("tid")] = event.at("args").at("name");
        }
    }
    std::map<std::string, int> events;
    for (const json& event : trace.at("traceEvents")) {
        if (event.at("ph") == "X") {
            ++events[names.at(event.at("tid"))];
        }
    }
    return events;
}

TEST_F(TimingCommand, HelpNamesWhatItsOptionsExclude) {
    const std::string help = run("timing --help").out;
    const auto meaningOf = [&help](const std::string& option) {
        const std::size_t begin = help.find("\n  --" + option);
        std::istringstream words(help.substr(begin, help.find("\n  --", begin + 1) - begin));
        std::string text;
        for (std::string word; words >> word;) {
            text += word + " ";
        }
        return text;
    };
    for (const char* option : {"scene", "in-flight", "rivals", "csv", "trace"}) {
        EXPECT_NE(meaningOf(option).find("(not with --against, --stages or --memory)"), std::string::npos)
            << option << ": " << help;
    }
    for (const char* option : {"frames", "modes"}) {
        EXPECT_NE(meaningOf(option).find("(not with --memory) (default:"), std::string::npos)
            << option << ": " << help;
    }
    EXPECT_NE(meaningOf("plot").find("(not with --against or --memory)"), std::string::npos) << help;
}

/// Never the times themselves, only what must hold of any.
TEST_F(TimingCommand, ReportsEveryModeOverStandard) {
    const ProgramResult result =
        succeed("--validate timing --frames 7 --size 64x36 --threads 2 --modes cdr-2,logcdr-5 --json t.json "
                "--csv t.csv --trace trace.json");
    const json document = jsonIn("t.json");
    EXPECT_EQ(document.at("command"), "timing");
    EXPECT_EQ(document.at("options").at("frames"), 7);
    std::vector<std::tuple<std::string, int, json>> modes;
    for (const json& row : document.at("results")) {
        modes.emplace_back(row.at("mode"), row.at("cascades"), row.at("thesis_pct"));
        const double overhead = row.at("overhead_pct");
        EXPECT_LE(row.at("ci95").at(0).get<double>(), overhead);
        EXPECT_GE(row.at("ci95").at(1).get<double>(), overhead);
        EXPECT_GT(row.at("median_us").get<double>(), 0.0);
        EXPECT_GT(row.at("record_us").get<double>(), 0.0);
        EXPECT_GT(row.at("execute_us").get<double>(), 0.0);
        if (!row.at("device_us").is_null()) { // a device that has a clock
            EXPECT_GT(row.at("device_us").get<double>(), 0.0);
            EXPECT_LE(row.at("device_us").get<double>(), row.at("median_us").get<double>());
        }
        EXPECT_GT(row.at("draws").get<double>(), 1000.0);
    }
    EXPECT_EQ(modes,
              (std::vector<std::tuple<std::string, int, json>>{
                  {"standard", 1, nullptr}, {"standard", 1, nullptr}, {"cdr", 2, 3.4}, {"logcdr", 5, 10.4}}));
    EXPECT_EQ(document.at("results").at(0).at("overhead_pct"), 0.0);
    EXPECT_EQ(document.at("noise_floor_pct"), document.at("results").at(1).at("overhead_pct"));
    EXPECT_EQ(lineCount(textIn("t.csv")), 5u);
    EXPECT_NE(result.out.find("Noise floor"), std::string::npos);

    const auto tracks = tracksOf(jsonIn("trace.json"));
    EXPECT_EQ(tracks.at("frames"), 4 * 5); // every mode's dropped frames, and no other
    EXPECT_EQ(tracks.at("device"), 4 * 5);
}

/// They could not be more than the smallest and the largest, which miss the median more often than one in 20.
TEST_F(TimingCommand, FewFramesHaveNoIntervals) {
    const ProgramResult result =
        succeed("timing --frames 5 --size 16x16 --modes log --json t.json --csv t.csv");
    const json document = jsonIn("t.json");
    EXPECT_TRUE(document.at("noise_floor_pct").is_number());
    EXPECT_TRUE(document.at("noise_floor_ci95").is_null());
    for (const json& row : document.at("results")) {
        EXPECT_TRUE(row.at("overhead_pct").is_number());
        EXPECT_TRUE(row.at("ci95").is_null());
        EXPECT_EQ(row.at("seen"), false);
    }
    EXPECT_NE(result.out.find("too few samples for a 95 % interval, 6 are needed"), std::string::npos)
        << result.out;
    EXPECT_NE(textIn("t.csv").find("\nlog,log,"), std::string::npos) << textIn("t.csv");
    EXPECT_NE(textIn("t.csv").find(",,,4.4,"), std::string::npos)
        << "both ends are empty: " << textIn("t.csv");
}

/// 100,000 objects that are placed again for each frame, in one process.
TEST_F(TimingCommand, TimesTrafficThatMoves) {
    const json document =
        documentOf("--validate timing --scene traffic --frames 3 --size 64x36 --threads 2 --modes "
                   "anchored,cdr-2");
    EXPECT_NE(document.at("options").at("scene").get<std::string>().find("100,000 cubes that move"),
              std::string::npos);
    std::vector<std::string> modes;
    for (const json& row : document.at("results")) {
        modes.push_back(row.at("mode"));
        EXPECT_GT(row.at("median_us").get<double>(), 0.0);
        EXPECT_GT(row.at("draws").get<double>(), 5'000.0);
        EXPECT_TRUE(row.at("seen").is_boolean());
    }
    EXPECT_EQ(modes, (std::vector<std::string>{"standard", "standard", "anchored", "cdr"}));
}

/// The program compared with itself. The ratios depend on the machine, so only the fields are tested.
TEST_F(TimingCommand, RunsTwoBuildsInTurns) {
    // Whatever others left in the folder for temporary files.
    std::filesystem::create_directory(at("cdr-timing.json"));
    succeed("--validate timing --against '" CDR_PROGRAM
            "' --rounds 2 --frames 2 --size 64x36 --modes log,cdr-2 --json a.json",
            "TMPDIR=.");
    const json document = jsonIn("a.json");
    EXPECT_EQ(document.at("options").at("rounds"), 2);
    EXPECT_EQ(document.at("options").at("against_commit"), document.at("commit"));
    EXPECT_EQ(document.at("options").at("arguments").at(1), "--validate");
    EXPECT_NE(document.at("device").at("driver"), "");
    EXPECT_TRUE(document.at("machine").contains("governor"));
    EXPECT_TRUE(document.at("machine").contains("load"));
    EXPECT_TRUE(document.at("machine").contains("load_after"));
    EXPECT_TRUE(document.at("machine").at("busy").is_boolean());
    std::vector<std::string> names;
    for (const json& row : document.at("results")) {
        names.push_back(row.at("name"));
        EXPECT_GT(row.at("here_us").get<double>(), 0.0);
        EXPECT_GT(row.at("against_us").get<double>(), 0.0);
        EXPECT_GT(row.at("ratio").get<double>(), 0.0);
        EXPECT_TRUE(row.at("noise_pct").is_null()) << "two rounds have no interval";
        EXPECT_TRUE(row.at("ci95").is_null());
        EXPECT_EQ(row.at("seen"), false);
    }
    EXPECT_EQ(names,
              (std::vector<std::string>{"standard", "standard-again", "log", "cdr-2", "run, CPU time"}));
}

TEST_F(TimingCommand, RefusesWhatIsNoBuild) {
    expectRefusal("timing --against true --rounds 1 --frames 1 --size 16x16 --modes log",
                  "true wrote no timing results");
}

/// A program that writes something else where its JSON is asked for.
TEST_F(TimingCommand, RefusesWhatIsNoTimingInOneLine) {
    std::ofstream(at("other")) << "#!/bin/sh\n"
                               << R"(echo '{"device": 5, "results": []}')";
    std::filesystem::permissions(at("other"), std::filesystem::perms::owner_all);
    expectRefusal("timing --against ./other --rounds 1 --frames 1 --size 16x16 --modes log",
                  "cannot be used: ");
}

/// The other program goes on, and would write where it was told.
TEST_F(TimingCommand, ASignalLeavesNoResultsOfABuild) {
    std::ofstream(at("other")) << "#!/bin/sh\n[ $1 = -version ] && exit\n"
                                  "for last; do :; done\ntouch started\n"
                                  "until [ -e go ]; do sleep 0.1; done\n"
                                  "case $last in *.json) exec >$last; esac\necho '{}'\ntouch ended\n";
    std::filesystem::permissions(at("other"), std::filesystem::perms::owner_all);
    const std::string script =
        "TMPDIR=. '" CDR_PROGRAM
        "' timing --against ./other --rounds 1 --frames 1 --size 16x16 >/dev/null 2>&1 & cdr=$!\n"
        "until [ -e started ] || ! kill -0 $cdr; do sleep 0.1; done\nkill $cdr\nwait $cdr\n"
        "[ -e started ] || exit 1\ntouch go\nuntil [ -e ended ]; do sleep 0.1; done";
    EXPECT_EQ(test::statusOf("cd '" + folder().string() + "' || exit\n" + script), 0);
    std::set<std::string> names;
    for (const auto& file : std::filesystem::directory_iterator(folder())) {
        names.insert(file.path().filename().string());
    }
    EXPECT_EQ(names, (std::set<std::string>{"other", "started", "go", "ended"}));
}

/// Never the times themselves: the stages are there, for each mode, and the frame is the last.
TEST_F(TimingCommand, TellsTheStagesOfAFrame) {
    const json document = documentOf("--validate timing --stages --frames 3 --size 64x36 --modes cdr-2");
    std::map<std::string, std::vector<std::string>> stages;
    for (const json& row : document.at("results")) {
        stages[row.at("mode")].push_back(row.at("stage"));
        EXPECT_TRUE(row.at("ci95").is_null()) << "three frames have no interval";
    }
    const std::vector<std::string> expected{"cull and bin",
                                            "record",
                                            "split and other CPU",
                                            "submit and wait",
                                            "vertices and set-up",
                                            "clear and background",
                                            "covered pixels",
                                            "lights",
                                            "frame"};
    EXPECT_EQ(stages,
              (std::map<std::string, std::vector<std::string>>{{"standard", expected}, {"cdr-2", expected}}));
    EXPECT_NEAR(document.at("results").back().at("frame_pct").get<double>(), 100.0, 1e-9);
}

TEST_F(TimingCommand, PlotsTheStagesOfEachMode) {
    const ProgramResult result = run("timing --stages --frames 2 --size 64x36 --modes cdr-2 --plot t.svg");
    if (result.err.find("need gnuplot") != std::string::npos) {
        GTEST_SKIP() << "gnuplot is not installed";
    }
    ASSERT_EQ(result.status, 0) << result.err;
    const std::string plot = textIn("t.svg");
    for (const char* word :
         {"</svg>", "standard", "cdr-2", "cull and bin", "vertices and set-up", "lights"}) {
        EXPECT_NE(plot.find(word), std::string::npos) << word;
    }
}

/// Predicted memory is measured memory, except for alignment and for what allocators round.
TEST_F(TimingCommand, ForetellsMemory) {
    if (std::string(CDR_FILE_FAULTS).empty()) {
        GTEST_SKIP() << "sanitizers replace the allocator that is asked";
    }
    const json document = documentOf("timing --memory --size 512x256");
    std::map<std::string, double> measured;
    for (const json& row : document.at("results")) {
        const double predicted = row.at("predicted_bytes");
        measured[row.at("what")] = row.at("measured_bytes");
        EXPECT_NEAR(measured[row.at("what")] / predicted, 1.0, 0.05) << row;
    }
    EXPECT_EQ(measured.size(), 9u);
    EXPECT_GT(measured.at("targets layers"), measured.at("targets single"));
}

TEST_F(TimingCommand, PlotsTheFigure) {
    const ProgramResult result = run("timing --frames 2 --size 64x36 --modes log --plot t.svg");
    if (result.err.find("need gnuplot") != std::string::npos) {
        GTEST_SKIP() << "gnuplot is not installed";
    }
    ASSERT_EQ(result.status, 0) << result.err;
    const std::string plot = textIn("t.svg");
    EXPECT_NE(plot.find("</svg>"), std::string::npos);
    EXPECT_NE(plot.find("standard-again"), std::string::npos);
}

TEST_F(ScalingCommand, DrawsTheSameImageWithAnyNumberOfThreads) {
    const json document = documentOf("--validate scaling --draws 700,3000 --threads 2,3 --cascades "
                                     "1,3 --targets single --repeats 2 --size 256x144 "
                                     "--csv s.csv");
    EXPECT_EQ(document.at("command"), "scaling");
    std::map<std::tuple<int, int>, std::set<std::string>> hashes;
    std::set<int> threads;
    for (const json& row : document.at("results")) {
        for (const char* field :
             {"record_ms", "execute_ms", "frame_ms", "cull_ms", "bin_ms", "record_ns_per_draw"}) {
            EXPECT_GT(row.at(field).get<double>(), 0.0) << field;
        }
        threads.insert(row.at("threads").get<int>());
        hashes[{row.at("cubes"), row.at("cascades")}].insert(row.at("hash").get<std::string>());
        EXPECT_TRUE(row.at("same_image").get<bool>());
        EXPECT_GE(row.at("draws"), row.at("cubes"));
        EXPECT_NEAR(row.at("efficiency").get<double>() * row.at("threads").get<double>(),
                    row.at("speedup").get<double>(), 1e-9);
        EXPECT_TRUE(row.at("spread").contains("record"));
        if (row.at("threads") == 1) {
            EXPECT_EQ(row.at("speedup"), 1.0);
        }
    }
    EXPECT_EQ(threads, (std::set<int>{1, 2, 3}));
    ASSERT_EQ(hashes.size(), 4u);
    std::set<std::string> all;
    for (const auto& [point, seen] : hashes) {
        EXPECT_EQ(seen.size(), 1u);
        all.insert(seen.begin(), seen.end());
    }
    EXPECT_EQ(all.size(), 4u); // other scenes and splits are other images
    // Secondaries and the control.
    EXPECT_EQ(document.at("results").size(), 24u);
    EXPECT_EQ(document.at("fits").size(), 8u);
    EXPECT_EQ(lineCount(textIn("s.csv")), 25u);
}

TEST_F(TimingCommand, TimesThroughputAndModesThatAreNoFigures) {
    if (!canDrawGpuDriven()) {
        GTEST_SKIP() << "the device cannot draw gpu-driven";
    }
    const json document = documentOf("--validate timing --frames 11 --in-flight 3 --size 64x36 "
                                     "--modes naive,anchored/gpu-driven,standard/primaries");
    EXPECT_EQ(document.at("options").at("mode"), "throughput");
    EXPECT_EQ(document.at("options").at("frames_in_flight"), 3);
    std::vector<std::tuple<std::string, std::string, std::string>> modes;
    for (const json& row : document.at("results")) {
        modes.emplace_back(row.at("name"), row.at("submission"), row.at("batching"));
        EXPECT_GT(row.at("median_us").get<double>(), 0.0);
        EXPECT_TRUE(row.at("device_us").is_null());
        EXPECT_TRUE(row.at("execute_us").is_null()); // frames that overlap have no parts of their own
    }
    EXPECT_EQ(modes, (std::vector<std::tuple<std::string, std::string, std::string>>{
                         {"standard", "secondaries", "instanced"},
                         {"standard-again", "secondaries", "instanced"},
                         {"naive", "secondaries", "per-object"},
                         {"anchored/gpu-driven", "gpu-driven", "instanced"},
                         {"standard/primaries", "primaries", "instanced"}}));
}

TEST_F(RenderCommand, HowDrawsAreSubmittedChangesNoHash) {
    std::set<std::string> hashes;
    struct How {
        std::string submission;
        std::string batching;
    };
    for (const How& how : {How{"secondaries", "per-object"}, How{"primaries", "instanced"},
                           How{"gpu-driven", "instanced"}, How{"secondaries", "push-constants"}}) {
        if (how.submission == "gpu-driven" && !canDrawGpuDriven()) {
            continue;
        }
        const json row = documentOf("--validate render rotation --size 96x54 --split count:3 --submission " +
                                    how.submission + " --batching " + how.batching)["results"][0];
        EXPECT_EQ(row.at("submission"), how.submission);
        EXPECT_EQ(row.at("batching"), how.batching);
        hashes.insert(row.at("hash").get<std::string>());
    }
    EXPECT_EQ(hashes.size(), 1u);
    if (!canDrawGpuDriven()) {
        GTEST_SKIP() << kNoGpuDriven;
    }
}

TEST_F(RenderCommand, TracesWorkersCascadesAndTheDevice) {
    succeed("render rotation --size 64x36 --split count:3 --threads 2 --frames 2 --trace trace.json");
    const auto tracks = tracksOf(jsonIn("trace.json"));
    EXPECT_EQ(tracks.at("frames"), 2);
    EXPECT_EQ(tracks.at("stages"), 2 * 4); // cull, split, bin, record
    EXPECT_EQ(tracks.at("device"), 2);
    EXPECT_EQ(tracks.at("cascade 1"), 2);
    int jobs = 0;
    for (const auto& [track, events] : tracks) {
        jobs += track.starts_with("worker") ? events : 0;
    }
    EXPECT_GT(jobs, 2 * 8);
}

/// A list of techniques is divided at commas, but not where a split has some.
TEST_F(ProbeCommand, TakesTechniquesWhoseNamesHaveCommas) {
    const ProgramResult result = succeed("probe --distances 1000 --size 64x36 --formats d32f --techniques "
                                         "standard/at:1,2,anchored/fitted:1px,max=2,reversed --json p.json");
    EXPECT_NE(result.out.find("no pixel tells"), std::string::npos) << result.out;
    std::vector<std::string> names;
    const json document = jsonIn("p.json");
    for (const json& row : document.at("results")) {
        names.push_back(row.at("technique"));
        EXPECT_EQ(row.at("pairs_seen"), 0);
    }
    EXPECT_EQ(names, (std::vector<std::string>{"standard/at:1,2", "anchored/fitted:1px,max=2", "reversed"}));
}

} // namespace

} // namespace cdr::cli_test
