#include "program.h"

#include <cdr/image/codec.h>
#include <cdr/platform/base64.h>
#include <cdr/platform/file.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <set>
#include <string>
#include <utility>
#include <vector>

namespace cdr::cli_test {

namespace {

using nlohmann::json;
using TranslucencyCommand = FolderTest;

/// Four pixels, all at the border: none is judged.
TEST_F(TranslucencyCommand, SaysNothingOfWhatItDidNotMeasure) {
    const std::string out = run("translucency --size 2x2 --cascades 1 --repeats 0 --json t.json").out;
    EXPECT_NE(out.find("no times"), std::string::npos) << out;
    const json document = jsonIn("t.json");
    ASSERT_EQ(document["results"].size(), 2u);
    for (const json& row : document["results"]) {
        EXPECT_TRUE(row.at("within_one_step").is_null());
    }
}

TEST_F(TranslucencyCommand, ComparesBothMethodsWithTheTruth) {
    const json document =
        documentOf("--validate translucency --size 160x90 --cascades 1,3 --repeats 1 --out p");
    EXPECT_EQ(document["command"], "translucency");
    std::set<std::pair<std::string, int>> seen;
    for (const json& row : document["results"]) {
        const auto method = row["method"].get<std::string>();
        seen.insert({method, row["cascades"].get<int>()});
        EXPECT_GT(row["pixels"], 2000);
        EXPECT_EQ(row["miscounted"], 0);
        EXPECT_GT(row["execute_ms"], 0.0);
        EXPECT_GT(row["bytes"], 160 * 90 * 4);
        EXPECT_EQ(row["note"], "");
        if (method == "sorted") {
            EXPECT_GE(row["within_one_step"], 0.9999);
            EXPECT_GT(row["fragments"], 160 * 90);
        } else {
            EXPECT_GT(row["mean_error"], 0.0);
        }
        const std::string stem = method + "_" + std::to_string(row["cascades"].get<int>());
        EXPECT_TRUE(std::filesystem::exists(at("p") / (stem + ".png")));
        EXPECT_TRUE(std::filesystem::exists(at("p") / (stem + "_error.png")));
    }
    EXPECT_EQ(seen.size(), 4u);
    EXPECT_TRUE(std::filesystem::exists(at("p/truth.png")));
}

/// Whose sums are right, so that only its values tell.
TEST_F(TranslucencyCommand, RefusesAStateWithAPictureOrAMethodOfNoSuchRun) {
    const std::string command = "translucency --size 32x18 --cascades 1 --repeats 0 --out p --state s";
    succeed(command);
    std::filesystem::remove_all(at("p"));
    const std::vector<std::string> lines = linesIn(at("s"));
    const auto expectRefused = [&](const auto& change) {
        std::vector<std::string> changed = lines;
        const auto record = recordIn(changed.at(1));
        json made = madeIn(changed.at(1));
        change(made);
        changed[1] = madeLineOf(record.at("unit"), made);
        writeLines(at("s"), changed);
        const ProgramResult result = run(command);
        EXPECT_EQ(result.status, 2);
        EXPECT_EQ(result.err,
                  "cdr: s: holds results that do not fit this run; remove it or name another file\n");
        EXPECT_FALSE(std::filesystem::exists(at("p")));
    };
    expectRefused([](json& made) { made.erase("picture"); });
    expectRefused([](json& made) {
        made["picture"] = {{"width", 1}, {"height", 1}, {"pixels", json::binary({0, 0, 0, 255})}};
    });
    expectRefused([](json& made) { // behind the number of cascades, which is aligned as what follows
        made["compared"].get_binary().at(8) = 200;
    });
}

TEST_F(TranslucencyCommand, ComparesAMomentOfAnAnimation) {
    const std::string common = "translucency " CDR_SOURCE_DIR "/tests/assets/veils.glb --size 160x90 "
                               "--cascades 1,3 --repeats 0 --out p --json t.json ";
    std::set<std::string> truths;
    for (const std::string& moment : {std::string(), std::string("--time 0.7"), std::string("--time 2"),
                                      std::string("--animation rest --time 0.7")}) {
        succeed(common + moment);
        const json document = jsonIn("t.json");
        EXPECT_EQ(document["options"].contains("time"), !moment.empty());
        EXPECT_EQ(document["options"].contains("animation"), moment.find("rest") != std::string::npos);
        for (const json& row : document["results"]) {
            EXPECT_EQ(row["miscounted"], 0) << moment;
            EXPECT_TRUE(row["method"] != "sorted" || row["max_error"] <= 2) << moment << row;
        }
        truths.insert(textIn("p/truth.png"));
    }
    EXPECT_EQ(truths.size(), 4u);
}

TEST_F(TranslucencyCommand, RefusesAMomentThatThereIsNot) {
    const std::string veils = CDR_SOURCE_DIR "/tests/assets/veils.glb";
    for (const std::string& arguments :
         {std::string("translucency --time 1"), std::string("translucency sheets --animation 0"),
          "translucency --animation fly " + veils, "translucency --time nan " + veils}) {
        expectRefusal(arguments + " --size 16x16");
    }
}

TEST_F(TranslucencyCommand, RenderTakesTheMethodAndItsMemory) {
    const std::string common = "--validate render sheets --size 320x180 --depth anchored --split count:3 ";
    const auto drawn = [&](const std::string& arguments) {
        const ProgramResult result = succeed(common + arguments + " --hash --json r.json");
        return std::pair(result.out, jsonIn("r.json")["results"][0]);
    };
    const json weighted = drawn("").second;
    const json sorted = drawn("--translucency sorted").second;
    EXPECT_EQ(weighted["translucency"], "weighted");
    EXPECT_EQ(sorted["translucency"], "sorted");
    EXPECT_NE(weighted["hash"], sorted["hash"]);
    const auto [out, refused] = drawn("--translucency sorted --translucency-memory 1");
    EXPECT_EQ(refused["translucency"], "weighted");
    EXPECT_EQ(refused["hash"], weighted["hash"]);
    EXPECT_NE(out.find("drawn with --translucency weighted: "), std::string::npos) << out;
}

TEST_F(TranslucencyCommand, CoverageIsAnOutput) {
    succeed("--validate render sheets --size 160x90 --aov coverage -o c.png");
    const image::ImageRgba8 picture = image::decodeImage(platform::readFile(at("c.png"), 1 << 20), "c.png");
    std::set<int> greys;
    for (const image::Rgba8& pixel : picture.pixels) {
        greys.insert(pixel[0]);
        EXPECT_TRUE(pixel[0] % 16 == 0 || pixel[0] == 255);
    }
    EXPECT_GE(greys.size(), 4u);
}

/// A scene without blended surfaces has a zero for each pixel.
TEST_F(TranslucencyCommand, CoverageOfNothingIsHashedByPixels) {
    std::set<std::string> hashes;
    for (const std::string size : {"16x16", "32x32"}) {
        succeed("render afc --aov coverage --hash --json r.json --size " + size);
        hashes.insert(jsonIn("r.json")["results"][0]["hash"].get<std::string>());
    }
    EXPECT_EQ(hashes.size(), 2u);
}

TEST_F(TranslucencyCommand, WhatIsNotTimedHasNoTime) {
    succeed("translucency --size 16x16 --cascades 1 --repeats 0 --json t.json");
    EXPECT_TRUE(jsonIn("t.json")["results"][0].at("execute_ms").is_null());
}

} // namespace

} // namespace cdr::cli_test
