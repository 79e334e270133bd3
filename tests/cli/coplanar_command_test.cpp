#include "program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace cdr::cli_test {

namespace {

using nlohmann::json;
using CoplanarCommand = FolderTest;

TEST_F(CoplanarCommand, CountsWhichOfTwoFacesIsSeen) {
    const ProgramResult result =
        succeed("--validate coplanar --frames 2 --search-views 1 --size 160x90 --techniques "
                "reversed,anchored --out pictures --json c.json");
    const json document = jsonIn("c.json");
    EXPECT_EQ(document.at("command"), "coplanar");
    std::vector<std::string> methods;
    for (const json& row : document.at("results")) {
        methods.push_back(row.at("technique").get<std::string>() + ", " +
                          row.at("method").get<std::string>());
        EXPECT_GT(row.at("pixels").get<int>(), 1000);
        const bool isNone = row.at("method") == "none";
        EXPECT_EQ(row.at("wrong_share").get<double>() > 0.01, isNone) << methods.back();
        EXPECT_GE(row.at("wrong").get<int>(), row.at("wrong_views").get<int>());
        EXPECT_LE(row.at("coverage_flips").get<int>(), row.at("flips").get<int>());
        if (row.at("method") == "layers") {
            EXPECT_EQ(row.at("wrong"), 0) << methods.back();
        }
        EXPECT_EQ(row.at("slope_factor").is_null(), row.at("method") != "polygon offset");
        if (isNone) {
            EXPECT_TRUE(std::filesystem::exists(at("pictures") / row.at("picture").get<std::string>()));
        }
    }
    EXPECT_EQ(methods,
              (std::vector<std::string>{"reversed, none", "reversed, polygon offset", "reversed, layers",
                                        "anchored, none", "anchored, polygon offset", "anchored, layers"}));
    EXPECT_NE(result.out.find("through a wall"), std::string::npos);
}

TEST_F(CoplanarCommand, SaysWhichTruthFindsNoMemory) {
    const ProgramResult result = run("coplanar --search-views 10000 --size 8192x8192");
    EXPECT_EQ(result.status, 1);
    EXPECT_NE(result.err.find("the truth of 10000 views to search settings by"), std::string::npos)
        << result.err;
}

/// One setting that does nothing draws what no method draws.
TEST_F(CoplanarCommand, SearchesTheSettingsThatAreGiven) {
    const std::string command =
        "coplanar --frames 1 --search-views 1 --size 64x36 --techniques reversed --json c.json --slopes ";
    const ProgramResult result = succeed("--validate " + command + "0 --constants 0");
    EXPECT_NE(result.out.find("the best of 1 settings"), std::string::npos) << result.out;
    const json document = jsonIn("c.json");
    EXPECT_EQ(document.at("options").at("slopes"), json::array({0.0}));
    const json& rows = document.at("results");
    EXPECT_GT(rows.at(0).at("wrong").get<int>(), 0);
    EXPECT_EQ(rows.at(1).at("wrong"), rows.at(0).at("wrong"));
    succeed(command + "0.25,0.5 --constants 0,4");
    const json chosen = jsonIn("c.json").at("results").at(1);
    EXPECT_LT(chosen.at("wrong"), rows.at(0).at("wrong"));
    EXPECT_GE(chosen.at("slope_factor"), 0.25);
    EXPECT_EQ(run(command + "1e7").status, 2);
}

/// Vertices that are rounded to halves of a pixel cover pixels that no ray meets them in, and some of these flip.
TEST_F(CoplanarCommand, TellsFlipsByCoverageFromOthers) {
    const json results = documentOf(
        "--quiet coplanar --frames 8 --search-views 1 --size 160x90 --techniques anchored --snap-bits 1")
        ["results"];
    const json& none = results.at(0);
    EXPECT_GT(none.at("coverage_flips").get<int>(), 0);
    EXPECT_LE(none.at("coverage_flips").get<int>(), none.at("coverage").get<int>());
    EXPECT_GT(none.at("flips").get<int>(), 10 * none.at("coverage_flips").get<int>());
}

} // namespace

} // namespace cdr::cli_test
