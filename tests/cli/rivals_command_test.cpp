#include "program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace cdr::cli_test {

namespace {

using nlohmann::json;
using RivalsCommand = FolderTest;

TEST_F(RivalsCommand, WritesWhatEachResolvesCostsAndNeeds) {
    const ProgramResult result =
        succeed("--validate rivals mixed afc --frames 2 --size 160x90 --distances 1000 --json r.json");
    const json document = jsonIn("r.json");
    EXPECT_EQ(document.at("command"), "rivals");
    EXPECT_EQ(document.at("options").at("baseline"), "anchored");
    std::map<std::string, json> inMixed;
    for (const json& row : document.at("results")) {
        if (row.at("scene") == "mixed") {
            inMixed[row.at("technique")] = row;
        }
        EXPECT_GT(row.at("frame_ms").get<double>(), 0.0);
        EXPECT_TRUE(row.at("ci95").is_null()) << "two frames have no interval";
    }
    EXPECT_EQ(document.at("results").size(), 2 * inMixed.size());
    EXPECT_EQ(document.at("needs").size(), inMixed.size());
    EXPECT_EQ(document.at("resolved").size(), inMixed.size());
    EXPECT_EQ(document.at("whole_frames").size(), 2u);
    EXPECT_EQ(inMixed.at("anchored").at("frame_ratio"), 1.0);
    // Every rival is there, or the reason why it is not.
    for (const std::string name :
         {"atomic-log", "two-float", "atomic-log-object", "atomic-fixed", "object-anchors"}) {
        const bool isThere = inMixed.count(name) == 1 && inMixed.count(name + "/prepass") == 1;
        const bool isLeftOut =
            result.out.find("left out: " + name + ", since the device lacks") != std::string::npos;
        EXPECT_NE(isThere, isLeftOut) << name << "\n" << result.out;
    }
}

/// Equal cubes, of which a distance from the object tells all.
TEST_F(RivalsCommand, SaysWhereALadderEnds) {
    const ProgramResult result =
        run("rivals cubes --frames 1 --size 640x360 --distances 1e4 --techniques anchored "
            "--rivals atomic-fixed --json r.json");
    if (result.status == 2 && result.err.find("lacks") != std::string::npos) {
        GTEST_SKIP() << result.err;
    }
    ASSERT_EQ(result.status, 0) << result.err;
    const json rows = jsonIn("r.json")["resolved"];
    EXPECT_EQ(rows[0]["resolves_all"], false);
    EXPECT_EQ(rows[1]["resolves_all"], true);
    EXPECT_EQ(rows[1]["resolves_all_unlike"], false);
    EXPECT_NE(result.out.find(" or less"), std::string::npos) << result.out;
}

TEST_F(RivalsCommand, DrawsThoseThatAreAskedForAlone) {
    const ProgramResult result =
        run("rivals cubes --frames 1 --size 64x36 --distances 10 --techniques anchored,reversed "
            "--rivals atomic-log,object-anchors/prepass --json r.json");
    if (result.status == 2 && result.err.find("lacks") != std::string::npos) {
        GTEST_SKIP() << result.err;
    }
    ASSERT_EQ(result.status, 0) << result.err;
    std::vector<std::string> names;
    const json document = jsonIn("r.json");
    for (const json& row : document.at("results")) {
        names.push_back(row.at("technique"));
    }
    EXPECT_EQ(names,
              (std::vector<std::string>{"anchored", "reversed", "atomic-log", "object-anchors/prepass"}));
    // At this size no pixel shows a pair off edges, which is no result.
    EXPECT_EQ(document.at("resolved").at(0).at("pairs_seen"), 0);
    EXPECT_EQ(document.at("resolved").at(0).at("pairs_seen_unlike"), 0);
    EXPECT_NE(result.out.find("no pixel tells"), std::string::npos) << result.out;
    EXPECT_EQ(result.out.find("none, >"), std::string::npos) << result.out;
}

/// Rivals as rows of commands that measure techniques.
class RivalsBeside : public FolderTest {
  protected:
    void SetUp() override {
        if (!deviceInfo().hasInt64Atomics || !deviceInfo().hasFragmentStores) {
            GTEST_SKIP() << "the device has no 64-bit atomics";
        }
    }

    json run(const std::string& command) const { return documentOf("--validate " + command); }

    /// Rows by technique, each of which has one.
    static std::map<std::string, json> byTechnique(const json& rows) {
        std::map<std::string, json> by;
        for (const json& row : rows) {
            by[row.at("technique")] = row;
        }
        EXPECT_EQ(by.size(), rows.size());
        return by;
    }

    /// Rows of a run with rivals hold those of one without, unchanged, and in front of each group's two.
    static void expectBeside(const json& with, const json& without, std::size_t techniques) {
        json others = json::array();
        std::vector<std::string> rivals;
        for (std::size_t i = 0; i < with.at("results").size(); ++i) {
            const json& row = with.at("results")[i];
            const bool isRival = i % (techniques + 2) >= techniques;
            EXPECT_EQ(row.contains("rival"), isRival) << row;
            if (isRival) {
                rivals.push_back(row.at("technique"));
            } else {
                others.push_back(row);
            }
        }
        EXPECT_EQ(others, without.at("results"));
        ASSERT_EQ(rivals.size() * techniques, 2 * others.size());
        for (std::size_t i = 0; i < rivals.size(); ++i) {
            EXPECT_EQ(rivals[i], i % 2 == 0 ? "object-anchors" : "atomic-log/prepass");
        }
        EXPECT_FALSE(without.contains("needs"));
        ASSERT_EQ(with.at("needs").size(), 2u);
        EXPECT_EQ(with.at("needs")[1].at("geometry_passes"), 2);
    }

    static constexpr const char* kRivals = " --rivals object-anchors,atomic-log/prepass";
};

TEST_F(RivalsBeside, ProbeFindsWhatTheyResolve) {
    const std::string command =
        "probe --distances 1000,1e6 --size 640x360 --techniques reversed,anchored --formats d32f";
    const json with = run(command + kRivals);
    expectBeside(with, run(command), 2);
    const auto at1e6 = byTechnique(json(with.at("results").begin() + 4, with.at("results").end()));
    const json& rival = at1e6.at("object-anchors");
    EXPECT_TRUE(rival.at("format").is_null());
    EXPECT_TRUE(rival.at("predicted").is_null());
    EXPECT_EQ(rival.at("cascades"), 1);
    EXPECT_EQ(rival.at("resolves_all"), true); // equal cubes, down to the ladder's end
    EXPECT_LT(rival.at("resolved"), at1e6.at("anchored").at("resolved"));
    const json& log = at1e6.at("atomic-log/prepass");
    EXPECT_EQ(log.at("resolves_all"), false);
    EXPECT_GT(log.at("resolved"), 1000.0 * rival.at("resolved").get<double>());
}

TEST_F(RivalsBeside, FlickerCountsWhatTheyGetWrongAndKeepsIt) {
    const std::string command = "flicker --frames 3 --size 320x180 --techniques log,reversed";
    const json with = run(command + kRivals + " --tga tga --state s");
    expectBeside(with, run(command), 2);
    const auto rows = byTechnique(with.at("results"));
    const json& rival = rows.at("object-anchors");
    EXPECT_EQ(rival.at("frames"), 3);
    EXPECT_TRUE(rival.at("mean_flip").is_null()); // nothing is shaded
    EXPECT_GT(rows.at("log").at("mean_flip"), 0.0);
    EXPECT_EQ(rival.at("pixels"), rows.at("log").at("pixels"));
    EXPECT_EQ(rival.at("compared"), rows.at("log").at("compared"));
    EXPECT_LT(rival.at("wrong"), rows.at("log").at("wrong"));
    EXPECT_LT(rival.at("wrong"), rows.at("atomic-log/prepass").at("wrong"));
    EXPECT_TRUE(std::filesystem::exists(at("tga/reversed/0002.tga")));
    EXPECT_FALSE(std::filesystem::exists(at("tga/object-anchors")));

    EXPECT_EQ(run(command + kRivals + " --tga tga --state s").at("results"), with.at("results"));
    expectRefusal(command + " --rivals object-anchors --state s", "other options");
}

TEST_F(RivalsBeside, OrbitCountsWhatTheyGetWrong) {
    if (!std::filesystem::exists(CDR_SOURCE_DIR "/.cache/orbit-data")) {
        GTEST_SKIP() << "the Earth of the scene orbit is not installed; tools/setup.sh fetches it";
    }
    const std::string command = "orbit --frames 2 --size 160x90 --techniques reversed,anchored --out out";
    const json with = run(command + kRivals);
    expectBeside(with, run(command), 2);
    const auto runway = byTechnique(json(with.at("results").begin() + 4, with.at("results").end()));
    EXPECT_EQ(runway.at("object-anchors").at("wrong"), runway.at("anchored").at("wrong"));
    EXPECT_GT(runway.at("atomic-log/prepass").at("wrong_fraction"), 0.02);
    EXPECT_FALSE(runway.at("object-anchors").contains("picture"));
    EXPECT_FALSE(std::filesystem::exists(at("out/orbit_object-anchors.png")));
}

/// Never the times themselves, only what must hold of any.
TEST_F(RivalsBeside, TimingHoldsThemAgainstADepthTestThatShadesAsLittle) {
    const json with =
        run(std::string("timing --frames 3 --size 64x36 --modes log --csv t.csv --trace t") + kRivals);
    std::vector<std::string> names;
    for (const json& row : with.at("results")) {
        const bool isRival = row.contains("rival");
        names.push_back(row.at("name"));
        EXPECT_EQ(row.contains("over"), isRival) << row;
        EXPECT_EQ(row.at("targets").is_null(), names.size() > 3) << row;
        EXPECT_GT(row.at("execute_us").get<double>(), 0.0);
        EXPECT_GT(row.at("draws").get<double>(), 1000.0);
        if (isRival) {
            EXPECT_EQ(row.at("over"), "standard/ids");
        }
    }
    EXPECT_EQ(names, (std::vector<std::string>{"standard", "standard-again", "log", "standard/ids",
                                               "object-anchors", "atomic-log/prepass"}));
    EXPECT_EQ(with.at("needs").size(), 2u);
}

TEST_F(RivalsBeside, AreRefusedInOneLineWhereTheyCannotBeTimed) {
    for (const auto& [with, says] :
         {std::pair("--scene traffic", "needs a scene that does not move, not traffic"),
          std::pair("--in-flight 2", "draws one frame at a time, not several in flight"),
          std::pair("--stages", "--rivals cannot be combined with --against, --stages or --memory"),
          std::pair("--memory", "--rivals cannot be combined with --against, --stages or --memory")}) {
        expectRefusal(std::string("timing --frames 1 --size 16x16 --rivals atomic-log --json t.json ") + with,
                      says);
    }
    EXPECT_TRUE(folderIsEmpty());
}

} // namespace

} // namespace cdr::cli_test
