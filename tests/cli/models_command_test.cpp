#include "program.h"

#include <cdr/host/file.h>
#include <cdr/image/codec.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>

namespace cdr::cli_test {

namespace {

using nlohmann::json;

const std::string kAssets = CDR_SOURCE_DIR "/tests/assets/";

TEST(ModelsCommand, HoldsModelsAgainstTheReference) {
    const TemporaryFolder folder;
    const ProgramResult result =
        runProgram("--validate models " + kAssets + "well.gltf " + kAssets +
                       "machine.glb --time 0.8 --size 240x135 --threads 2 --out m --json m.json",
                   folder.path());
    ASSERT_EQ(result.status, 0) << result.err;
    const json document = json::parse(readText(folder.path() / "m.json"));
    EXPECT_EQ(document["command"], "models");
    ASSERT_EQ(document["results"].size(), 2u);
    for (const json& row : document["results"]) {
        EXPECT_EQ(row["light"], "sky");
        EXPECT_GT(row["triangles"], 100);
        EXPECT_GT(row["covered_fraction"], 0.1);
        EXPECT_GT(row["flip"], 0.0);
        EXPECT_LE(row["flip"], 0.05);
        EXPECT_LE(row["covered_flip"], 0.1);
        EXPECT_LE(row["mean_steps"], 1.0);
        const auto name = row["model"].get<std::string>();
        const auto read = [&](const std::string& suffix) {
            return image::decodeImage(
                host::readFile(folder.path() / "m" / (name + suffix + ".png"), 1u << 30u), "m");
        };
        EXPECT_EQ(read("").width, 240u);
        EXPECT_NE(read(""), read("_plain"));
        EXPECT_NE(read(""), read("_reference"));
        EXPECT_EQ(read("_flip").height, 135u);
    }
    EXPECT_GT(
        image::decodeImage(host::readFile(folder.path() / "m" / "models_sheet.png", 1u << 30u), "m").width,
        900u);
}

TEST(ModelsCommand, TakesAModelsOwnLightsAndCamera) {
    const TemporaryFolder folder;
    const auto reference = [&](const std::string& more) {
        const ProgramResult result = runProgram("models " + kAssets + "stage.glb --camera 0 --size 240x135 " +
                                                    more + " --out m --json m.json",
                                                folder.path());
        EXPECT_EQ(result.status, 0) << result.err;
        const json row = json::parse(readText(folder.path() / "m.json"))["results"][0];
        EXPECT_LE(row["covered_flip"], 0.05) << more;
        return readText(folder.path() / "m" / "stage_reference.png");
    };
    const std::string still = reference("--light file");
    EXPECT_NE(still, reference("--light file --time 0.5"));
    EXPECT_NE(still, reference("--light lamps"));
}

} // namespace

} // namespace cdr::cli_test
