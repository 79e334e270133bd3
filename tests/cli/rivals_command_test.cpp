#include "program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <map>
#include <string>

namespace cdr::cli_test {

namespace {

using nlohmann::json;

TEST(RivalsCommand, WritesWhatEachResolvesCostsAndNeeds) {
    const TemporaryFolder folder;
    const ProgramResult result = runProgram(
        "--validate rivals mixed afc --frames 2 --size 160x90 --distances 1000 --json r.json", folder.path());
    ASSERT_EQ(result.status, 0) << result.err;
    const json document = json::parse(readText(folder.path() / "r.json"));
    EXPECT_EQ(document.at("command"), "rivals");
    EXPECT_EQ(document.at("options").at("baseline"), "anchored");
    std::map<std::string, json> inMixed;
    for (const json& row : document.at("results")) {
        if (row.at("scene") == "mixed") {
            inMixed[row.at("technique")] = row;
        }
        EXPECT_GT(row.at("frame_ms").get<double>(), 0.0);
        EXPECT_EQ(row.at("ci95").size(), 2u);
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

TEST(RivalsCommand, DrawsThoseThatAreAskedForAlone) {
    const TemporaryFolder folder;
    const ProgramResult result =
        runProgram("rivals cubes --frames 1 --size 64x36 --distances 10 --techniques anchored,reversed "
                   "--rivals atomic-log,object-anchors/prepass --json r.json",
                   folder.path());
    if (result.status == 2 && result.err.find("lacks") != std::string::npos) {
        GTEST_SKIP() << result.err;
    }
    ASSERT_EQ(result.status, 0) << result.err;
    std::vector<std::string> names;
    const json document = json::parse(readText(folder.path() / "r.json"));
    for (const json& row : document.at("results")) {
        names.push_back(row.at("technique"));
    }
    EXPECT_EQ(names,
              (std::vector<std::string>{"anchored", "reversed", "atomic-log", "object-anchors/prepass"}));
}

} // namespace

} // namespace cdr::cli_test
