#include "program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace cdr::cli_test {

namespace {

using nlohmann::json;
using DetailCommand = FolderTest;

TEST_F(DetailCommand, ComparesEveryModeWithNone) {
    const ProgramResult result = succeed(
        "--validate detail boulders --frames 1 --size 96x54 --threads 2 --out pictures --json d.json");
    const json document = jsonIn("d.json");
    EXPECT_EQ(document.at("command"), "detail");
    EXPECT_EQ(document.at("options").at("split"), "count:5");
    EXPECT_EQ(document.at("scene_triangles"), 200 * 20'480);
    EXPECT_GT(document.at("levels").get<int>(), 4 * 5);
    EXPECT_GT(document.at("clusters").get<int>(), 4 * 100);
    std::vector<std::string> modes;
    for (const json& row : document.at("results")) {
        modes.push_back(row.at("mode"));
        const bool isWhole = modes.back().starts_with("none");
        EXPECT_GT(row.at("execute_ms").get<double>(), 0.0);
        EXPECT_TRUE(row.at("ci95").is_null()) << "one frame has no interval";
        EXPECT_EQ(row.at("pixels"), 96 * 54);
        EXPECT_EQ(row.at("flip").get<double>() == 0.0, isWhole);
        EXPECT_EQ(row.at("triangles").get<double>() > 3e6, isWhole);
        if (modes.back() != "cascade") {
            EXPECT_EQ(row.at("cracks"), 0);
        }
        EXPECT_TRUE(std::filesystem::exists(at("pictures") / (modes.back() + ".png")));
    }
    EXPECT_EQ(modes, (std::vector<std::string>{"none", "none-again", "object", "cascade", "cluster"}));
    EXPECT_NE(result.out.find("speed-up"), std::string::npos);
}

TEST_F(DetailCommand, RenderTakesADetailHoweverSubmitted) {
    if (!canDrawGpuDriven()) {
        GTEST_SKIP() << "the device cannot draw gpu-driven";
    }
    std::vector<std::string> hashes;
    for (const char* how : {"none", "object --submission gpu-driven", "object:0.5 --threads 3"}) {
        const json row = documentOf(std::string("--validate render " CDR_SOURCE_DIR
                                                "/tests/golden/spheres.gltf --size 96x54 "
                                                "--split count:3 --detail ") +
                                    how)["results"][0];
        EXPECT_EQ(row.at("detail"), std::string(how) == "none" ? "none" : "object:0.5");
        hashes.push_back(row.at("hash"));
    }
    EXPECT_EQ(hashes[1], hashes[2]);
    EXPECT_NE(hashes[0], hashes[1]);
}

TEST_F(DetailCommand, RenderTakesClusters) {
    std::vector<std::string> hashes;
    for (const char* how : {"cluster", "cluster:0.5 --threads 3 --targets layers", "none"}) {
        const json row = documentOf(std::string("--validate render " CDR_SOURCE_DIR
                                                "/tests/golden/spheres.gltf --size 96x54 --detail ") +
                                    how)["results"][0];
        EXPECT_EQ(row.at("detail"), std::string(how) == "none" ? "none" : "cluster:0.5");
        hashes.push_back(row.at("hash"));
    }
    EXPECT_EQ(hashes[0], hashes[1]);
    EXPECT_NE(hashes[0], hashes[2]);
}

TEST_F(DetailCommand, BadDetailsAreOneLine) {
    for (const char* bad :
         {"render cubes --detail objects", "render cubes --detail object:0", "render cubes --detail none:1",
          "render cubes --detail cascade:x", "render boulders --detail cluster --submission gpu-driven",
          "detail cubes --pixels -1", "detail cubes --pixels nan", "detail nowhere.glb",
          "detail cubes --split count:0"}) {
        expectRefusal(bad);
    }
}

} // namespace

} // namespace cdr::cli_test
