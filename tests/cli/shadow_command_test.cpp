#include "program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <map>
#include <string>

namespace cdr::cli_test {

namespace {

using nlohmann::json;
using ShadowCommand = FolderTest;

TEST_F(ShadowCommand, ComparesBothMethodsWithTheTruth) {
    const json document = documentOf(
        "--validate shadows alley --size 320x180 --shadow-texels 64 --methods plain,anchored --out p");
    ASSERT_EQ(document["results"].size(), 2u);
    for (const json& row : document["results"]) {
        EXPECT_GT(row["pixels"], 10000);
        EXPECT_GT(row["shadowed"], 100);
        EXPECT_GT(row["maps"], 2);
        EXPECT_GT(row["casters"], row["maps"]);
        EXPECT_TRUE(std::filesystem::exists(at("p") / row["picture"].get<std::string>()));
        EXPECT_TRUE(std::filesystem::exists(at("p") / row["wrong_picture"].get<std::string>()));
    }
    EXPECT_EQ(document["results"][0]["method"], "plain");
    EXPECT_EQ(document["results"][1]["method"], "anchored");
    EXPECT_LT(document["results"][1]["wrong_fraction"], document["results"][0]["wrong_fraction"]);
}

/// All frames' truth is kept at once, so what has no room ends before the first ray.
TEST_F(ShadowCommand, SaysHowMuchMemoryTheTruthNeeds) {
    expectOneLine(run("shadows alley --frames 1000000 --size 1920x1080"), 1,
                  "the truth of 1000000 frames under ");
}

/// A technique's name is a part of the names of pictures.
TEST_F(ShadowCommand, TechniquesWithASplitHavePictures) {
    const auto picture =
        documentOf("shadows alley --techniques standard/count:3 --methods plain --size 64x36 --out p")
            ["results"][0]["picture"]
                .get<std::string>();
    EXPECT_EQ(picture.find("standard-count:3"), 0u) << picture;
    EXPECT_TRUE(std::filesystem::exists(at("p") / picture));
}

/// Of frames after the first, where the camera moves.
TEST_F(ShadowCommand, CountsFlipsSinceTheFrameBefore) {
    const json rows = documentOf("shadows afc --size 320x180 --frames 3 --methods plain,anchored")["results"];
    std::map<std::string, std::uint64_t> flips;
    std::size_t first = 0;
    for (const json& row : rows) {
        if (row["frame"] == 0) {
            EXPECT_FALSE(row.contains("flips"));
            ++first;
            continue;
        }
        EXPECT_GT(row["flips_compared"], 500);
        EXPECT_LE(row["flips"], row["flips_compared"]);
        flips[row["method"].get<std::string>()] += row["flips"].get<std::uint64_t>();
    }
    EXPECT_EQ(first, 2u);
    EXPECT_GT(flips["plain"], 0u);
    EXPECT_LT(flips["anchored"], flips["plain"]);
}

TEST_F(ShadowCommand, RenderCastsThem) {
    const auto hashWith = [&](const std::string& options) {
        succeed("--validate render alley --size 160x90 --hash --json r.json " + options);
        return jsonIn("r.json")["results"][0]["hash"].get<std::string>();
    };
    const std::string lit = hashWith("");
    EXPECT_EQ(hashWith("--shadows none"), lit);
    EXPECT_NE(hashWith("--shadows anchored"), lit);
    const json row = jsonIn("r.json")["results"][0];
    EXPECT_EQ(row["shadows"], "anchored");
    EXPECT_GT(row["shadow_maps"], 2);
    EXPECT_GT(row["shadow_casters"], row["shadow_maps"]);
    EXPECT_GT(row["shadows_ms"], 0.0);
    EXPECT_GT(row["split_ms"], 0.0);
    EXPECT_EQ(row["translucent_ms"], 0.0);
}

} // namespace

} // namespace cdr::cli_test
