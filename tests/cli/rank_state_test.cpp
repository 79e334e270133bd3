#include "rank_test.h"

#include <cdr/platform/file.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <program/sha256.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace cdr::cli_test {
namespace {

namespace fs = std::filesystem;
using Lines = std::vector<std::string>;

/// A command that keeps its results.
struct Kept {
    const char* arguments;
    std::size_t units;
    std::size_t shown;                  ///< a unit whose result shows in JSON
    std::size_t other;                  ///< one of another result
    const char* otherwise = "--seed 7"; ///< options of another run

    friend std::ostream& operator<<(std::ostream& out, const Kept& kept) { return out << kept.arguments; }
};

class RankState : public RankTest, public testing::WithParamInterface<Kept> {
  protected:
    void SetUp() override {
        RankTest::SetUp();
        if (!IsSkipped() && std::string(GetParam().arguments).starts_with("orbit") &&
            !fs::exists(CDR_SOURCE_DIR "/.cache/orbit-data")) {
            GTEST_SKIP() << "the Earth of the scene orbit is not installed; tools/setup.sh fetches it";
        }
    }

    fs::path state() const { return at("s"); }

    /// All commands keep results by one mechanism, so one command tries all of it.
    static bool triesAll() {
        return takesAllCases() || std::string(GetParam().arguments).starts_with("probe");
    }
    static bool takesFolder() { return std::string(GetParam().arguments).starts_with("flicker"); }
    static std::vector<int> rankCounts() { return triesAll() ? std::vector<int>{0, 2} : std::vector<int>{2}; }

    /// @param ranks 0 for one process that no launcher starts.
    ProgramResult run(int ranks, const std::string& more = "--state s") const {
        for (const char* made : {"all.json", "out"}) {
            fs::remove_all(at(made));
        }
        return RankTest::run(GetParam().arguments + (" --json all.json " + more),
                             test::launched(CDR_MPIEXEC, ranks));
    }

    /// All that was written except for the state.
    std::map<std::string, std::string> results() const {
        auto files = filesIn(folder());
        files.erase("s");
        return files;
    }

    /// JSON with its times, except for what is measured at each start.
    std::string wholeJson() const {
        return std::regex_replace(textIn("all.json"), std::regex("\"make_levels_ms\": [^,\n]+"), "");
    }

    Lines stateLines() const { return linesIn(state()); }
    void writeState(const Lines& lines, const std::string& cutOff = "") const {
        writeLines(state(), lines, cutOff);
    }

    void expectRefused(int ranks, const std::string& line, const std::string& more = "--state s") const {
        const std::string before = readText(state());
        const ProgramResult result = run(ranks, more);
        EXPECT_EQ(result.status, 2) << more;
        EXPECT_EQ(result.err, "cdr: " + line + "\n");
        EXPECT_TRUE(results().empty());
        EXPECT_EQ(readText(state()), before);
    }
};

/// Unit by unit, each once.
std::set<std::size_t> unitsIn(const Lines& lines) {
    std::set<std::size_t> units;
    for (std::size_t i = 1; i < lines.size(); ++i) {
        EXPECT_TRUE(units.insert(recordIn(lines[i]).at("unit").get<std::size_t>()).second) << "made again";
    }
    return units;
}

const Kept kProbe{
    "probe --distances 10,1e3,1e6,1e7 --techniques reversed,anchored --formats d32f --size 96x54", 4, 1, 0};
/// A scene without levels, since these are made at each start.
const Kept kDetail{
    "detail rotation --depth anchored --frames 4 --split fitted:0.1,max=3 --size 96x54 --out out", 5, 3, 2};
const std::vector<Kept> kAllKept{
    kProbe,
    {"coplanar --frames 5 --search-views 1 --size 64x36 --techniques standard --out out", 6, 3, 1},
    {"orbit --frames 4 --size 96x54 --techniques reversed,anchored --out out", 4, 2, 1, "--threads 2"},
    kDetail,
    // Its pictures are not kept, and its state may be a folder.
    {"flicker --frames 4 --size 96x54 --techniques standard,anchored --tga out", 4, 1, 0},
    // Its pictures lie beside the state, which RenderState tries.
    {"render cubes --frames 5 --size 64x36 --technique anchored", 5, 3, 1},
    {"render afc-near --technique cdr --ranks cascades --frames 5 --size 64x36", 5, 3, 1},
    {"translucency --size 96x54 --cascades 1,3 --repeats 1 --out out", 5, 1, 0}};

/// What may stand in a state, which does not depend on the command: two of them, or all with CDR_ALL_CASES.
class RankStateFile : public RankState {};

INSTANTIATE_TEST_SUITE_P(Commands, RankState, testing::ValuesIn(kAllKept));
INSTANTIATE_TEST_SUITE_P(Commands, RankStateFile,
                         testing::ValuesIn(takesAllCases() ? kAllKept : std::vector<Kept>{kProbe, kDetail}));

/// As a run leaves it that was killed after some results, while it wrote the next one.
TEST_P(RankState, MakesOnlyWhatIsMissingWithAnyNumberOfRanks) {
    const std::size_t units = GetParam().units;
    ASSERT_EQ(run(0, "").status, 0);
    const auto expected = results();
    ASSERT_EQ(run(3).status, 0);
    EXPECT_EQ(results(), expected);
    const Lines lines = stateLines();
    ASSERT_EQ(lines.size(), units + 1);
    ASSERT_EQ(unitsIn(lines).size(), units);
    const std::vector<std::size_t> all{0, 1, units / 2, units - 1};
    for (const std::size_t kept : triesAll() ? all : std::vector<std::size_t>{1}) {
        const Lines before(lines.begin(), lines.begin() + static_cast<long>(kept) + 1);
        writeState(before, lines[kept + 1].substr(0, lines[kept + 1].size() / 2));
        const ProgramResult again = run(static_cast<int>(kept % 3) * 2); // alone, as two and as four
        EXPECT_EQ(again.status, 0) << again.err;
        EXPECT_EQ(results(), expected) << kept;
        const std::string number = std::to_string(kept);
        const std::regex says("(results kept in s: " + number + "|" + number +
                              " of 5 frames are kept in s)\n");
        EXPECT_EQ(std::regex_search(again.out, says), kept > 0) << again.out;
        const Lines after = stateLines();
        ASSERT_EQ(after.size(), units + 1) << kept;
        EXPECT_EQ(Lines(after.begin(), after.begin() + static_cast<long>(kept) + 1), before);
        EXPECT_EQ(unitsIn(after).size(), units);
    }
}

TEST_P(RankStateFile, TakesWhatTheStateHolds) {
    ASSERT_EQ(run(0).status, 0);
    const auto expected = results();
    const std::string json = wholeJson();
    Lines lines = stateLines();
    for (const int ranks : rankCounts()) { // nothing is made or measured again
        ASSERT_EQ(run(ranks).status, 0);
        EXPECT_EQ(wholeJson(), json);
        EXPECT_EQ(stateLines(), lines);
    }
    const auto lineOfUnit = [&](std::size_t unit) -> std::string& {
        return *std::find_if(lines.begin() + 1, lines.end(),
                             [&](const std::string& line) { return recordIn(line).at("unit") == unit; });
    };
    const auto made = recordIn(lineOfUnit(GetParam().other)).at("made");
    lineOfUnit(GetParam().shown) = stateLineOf(GetParam().shown, made);
    writeState(lines);
    ASSERT_EQ(run(0).status, 0);
    EXPECT_NE(results().at("all.json"), expected.at("all.json"));
    EXPECT_EQ(stateLines(), lines);
}

TEST_P(RankStateFile, RefusesWhatIsNoStateOfItsOwn) {
    const std::string elsewhere = "; remove it or name another file";
    ASSERT_EQ(run(0).status, 0);
    const Lines lines = stateLines();
    for (const int ranks : triesAll() ? rankCounts() : std::vector<int>{0}) {
        writeState(lines);
        expectRefused(ranks,
                      "s: is the state of a run with other options or files, another version or device" +
                          elsewhere,
                      std::string("--state s ") + GetParam().otherwise);
        Lines damaged = lines;
        damaged[2][damaged[2].size() / 2] ^= 1;
        writeState(damaged);
        expectRefused(ranks, "s: is damaged" + elsewhere);
        for (const auto& other :
             {nlohmann::ordered_json(7), nlohmann::ordered_json::binary({})}) { // of another kind, and none
            damaged = lines;
            damaged[2] = madeLineOf(recordIn(damaged[2]).at("unit"), other);
            writeState(damaged);
            expectRefused(ranks, "s: holds results that do not fit this run" + elsewhere);
        }
        if (!triesAll()) {
            continue;
        }
        for (const auto& [option, line] :
             {std::pair("--state .", ".: names a folder, not a file to write"),
              std::pair("--state no/s", "no/s: cannot be written, its folder is missing or read-only"),
              std::pair("--state /dev/full", "/dev/full: not a regular file"),
              std::pair("--state all.json", "all.json: both --json and --state would write it")}) {
            if (std::string(option) != "--state ." || !takesFolder()) {
                expectRefused(ranks, line, option);
            }
        }
    }
}

/// A report whose sections a state keeps, beside the files that they wrote.
class RankReportState : public FolderTest {
  protected:
    ProgramResult report(int ranks, const std::string& more = "") const {
        return run("report --smallest --sections precision,advise,pictures,flicker-near,probe,effects,"
                   "certificates-mixed -o r --state s " +
                       more,
                   test::launched(CDR_MPIEXEC, ranks));
    }
    /// Where a report of this state lies until it is whole.
    fs::path unfinished() const {
        return at(".r." + program::sha256Of(fs::canonical(at(".")).string() + "/s").substr(0, 12) + ".new");
    }
    Lines stateLines() const { return linesIn(at("s")); }
    /// With times.
    std::map<std::string, std::string> reportFiles() const {
        std::map<std::string, std::string> files;
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(at("r"))) {
            if (entry.is_regular_file()) {
                files[entry.path().lexically_relative(at("r")).string()] = readText(entry.path());
            }
        }
        return files;
    }
    /// By section, how long it took.
    std::map<std::string, double> secondsOfSections() const {
        std::map<std::string, double> seconds;
        const auto manifest = jsonIn("r/report.json");
        for (const auto& row : manifest.at("results")) {
            seconds[row.at("section")] = row.at("seconds");
        }
        return seconds;
    }
};

/// Names of sections whose time is another one.
std::set<std::string> changedIn(const std::map<std::string, double>& after,
                                const std::map<std::string, double>& before) {
    std::set<std::string> changed;
    for (const auto& [section, seconds] : after) {
        if (before.at(section) != seconds) {
            changed.insert(section);
        }
    }
    return changed;
}

TEST_F(RankReportState, MakesOnlyTheSectionsThatAreMissing) {
    if (std::string(CDR_MPIEXEC).empty()) {
        GTEST_SKIP() << "built without MPI (libopenmpi-dev, openmpi-bin)";
    }
    const ProgramResult first = report(3);
    if (lacksPage(first)) {
        GTEST_SKIP() << kNoPage;
    }
    const auto files = reportFiles();
    const auto seconds = secondsOfSections();
    const Lines lines = stateLines();
    const auto manifest = nlohmann::json::parse(files.at("report.json"));
    const auto wentWell =
        static_cast<std::size_t>(std::count_if(manifest.at("results").begin(), manifest.at("results").end(),
                                               [](const auto& row) { return row.at("failure").is_null(); }));
    ASSERT_EQ(lines.size(), seconds.size() + 1);
    ASSERT_GE(wentWell, 8u);

    // As a run that was killed leaves it: the first lines, and in the folder more than they say.
    fs::rename(at("r"), unfinished());
    platform::writeText(unfinished() / "pictures/half.png", "half a picture");
    writeLines(at("s"), Lines(lines.begin(), lines.end() - 2));
    const ProgramResult second = report(2);
    EXPECT_EQ(second.status, first.status) << second.err;
    EXPECT_FALSE(fs::exists(unfinished()));
    EXPECT_EQ(reportFiles().size(), files.size());
    const std::regex isAnew("report.json|data.js|data/certificates-mixed-(reversed|anchored).json");
    for (const auto& [name, text] : reportFiles()) {
        if (!std::regex_match(name, isAnew)) {
            EXPECT_TRUE(files.at(name) == text) << name;
        }
    }
    std::set<std::string> again{"certificates-mixed-reversed",
                                "certificates-mixed-anchored"}; // the last that measure time
    for (const auto& row : manifest.at("results")) {
        if (!row.at("failure").is_null()) {
            again.insert(row.at("section"));
        }
    }
    EXPECT_EQ(changedIn(secondsOfSections(), seconds), again);

    // A picture is another one, a file is gone, and the report stands where it was put.
    const auto secondsThen = secondsOfSections();
    platform::writeText(at("r/effects/plain.png"), "another picture");
    fs::remove(at("r/data/probe.json"));
    again = {"effects", "probe"};
    for (const auto& row : manifest.at("results")) {
        if (!row.at("failure").is_null()) {
            again.insert(row.at("section"));
        }
    }
    EXPECT_EQ(report(0).status, first.status);
    EXPECT_EQ(changedIn(secondsOfSections(), secondsThen), again);
    EXPECT_EQ(reportFiles().size(), files.size());
    EXPECT_TRUE(reportFiles().at("data/probe.json") == files.at("data/probe.json"));
}

TEST_F(RankReportState, RefusesAStateInItsFolderOrOfAnother) {
    const ProgramResult inside = runProgram("report --smallest -o r --state r/s", at("."));
    if (lacksPage(inside)) {
        GTEST_SKIP() << kNoPage;
    }
    EXPECT_EQ(inside.err,
              "cdr: r/s: lies in the folder of the report, which may only hold files of the report\n");
    platform::writeText(at("s"), "{}\n");
    const ProgramResult result = report(0);
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.err, "cdr: s: is no state; remove it or name another file\n");
    EXPECT_EQ(filesIn(at(".")).size(), 1u);
}

} // namespace
} // namespace cdr::cli_test
