#include "program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <map>
#include <set>
#include <string>

namespace cdr::cli_test {

namespace {

using nlohmann::json;
using FocusCommand = FolderTest;

TEST_F(FocusCommand, ComparesEveryLensWithManyCameras) {
    const ProgramResult result = succeed(
        "--validate focus --frames 6 --cameras 16 --size 320x180 --aperture 0.5 --out pictures --json f.json");
    const json document = jsonIn("f.json");
    EXPECT_EQ(document.at("command"), "focus");
    EXPECT_EQ(document.at("options").at("split"), "circles");
    std::map<std::string, json> rows;
    for (const json& row : document.at("results")) {
        const std::string mode = row.at("mode");
        rows[mode] = row;
        EXPECT_GT(row.at("execute_ms").get<double>(), 0.0);
        EXPECT_EQ(row.at("rmse").get<double>() == 0.0, mode == "cameras");
        EXPECT_TRUE(std::filesystem::exists(at("pictures") / (mode + ".png")));
    }
    ASSERT_EQ(rows.size(), 5u);
    EXPECT_TRUE(rows["cameras"].at("ci95").is_null()); // drawn once
    EXPECT_EQ(rows["focus"].at("ci95").size(), 2u);
    EXPECT_EQ(result.out.find("0 to 0"), std::string::npos) << result.out;
    EXPECT_EQ(rows["single"].at("rmse"), rows["layers"].at("rmse"));
    EXPECT_LT(rows["focus-blend"].at("rmse"), rows["focus"].at("rmse"));
    EXPECT_LT(rows["focus-blend"].at("rmse"), rows["layers"].at("rmse"));
    EXPECT_LT(2 * rows["focus"].at("pixels").get<int>(), rows["layers"].at("pixels").get<int>());
    std::set<int> scales;
    for (const json& cascade : document.at("cascades")) {
        scales.insert(cascade.at("scale").get<int>());
    }
    EXPECT_TRUE(scales.contains(1));
    EXPECT_TRUE(scales.contains(8));
}

TEST_F(FocusCommand, DrawsTheSplitThatWasAskedFor) {
    const json document = documentOf("focus --split none --frames 1 --cameras 1 --size 64x36");
    EXPECT_EQ(document.at("options").at("split"), "none");
    EXPECT_EQ(document.at("cascades").size(), 1u);
}

TEST_F(FocusCommand, RenderTakesALens) {
    std::set<std::string> hashes;
    for (const char* lens : {"12:0.3", "12:0.3:blend", "6:0.3"}) {
        const json row = documentOf(
            std::string("--validate render alley --size 96x54 --split count:4 --targets layers --focus ") +
            lens)["results"][0];
        hashes.insert(row.at("hash").get<std::string>());
    }
    EXPECT_EQ(hashes.size(), 3u);
}

} // namespace

} // namespace cdr::cli_test
