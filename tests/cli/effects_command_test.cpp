#include "program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <map>
#include <string>

namespace cdr::cli_test {

namespace {

using nlohmann::json;
using EffectsCommand = FolderTest;

TEST_F(EffectsCommand, LooksAlikeUnderEveryTechniqueAndLosesPerLayer) {
    const json document = documentOf("--validate effects --frames 2 --size 320x180 --out pictures");
    EXPECT_EQ(document.at("command"), "effects");
    std::map<std::string, json> rows;
    for (const json& row : document.at("results")) {
        const std::string mode = row.at("mode");
        rows[mode] = row;
        EXPECT_GT(row.at("execute_ms").get<double>(), 0.0);
        EXPECT_TRUE(std::filesystem::exists(at("pictures") / (mode + ".png")));
    }
    ASSERT_EQ(rows.size(), 5u);
    const double plain = rows["plain"].at("differing");
    for (const char* mode : {"edges", "occlusion", "fog"}) {
        EXPECT_LT(rows[mode].at("differing").get<double>(), plain + 0.005) << mode;
    }
    EXPECT_GT(document.at("lost_per_layer").get<double>(), 0.0);
}

TEST_F(EffectsCommand, ComparesTheTechniquesThatAreGiven) {
    const json document = documentOf("--validate effects --frames 1 --size 32x18 --techniques log");
    EXPECT_EQ(document.at("options").at("techniques"), json::array({"log"}));
    for (const json& row : document.at("results")) {
        EXPECT_EQ(row.at("least_alike"), "log");
        EXPECT_TRUE(row.at("ci95").is_null()) << "one frame has no interval";
    }
}

/// One byte of a surface is either how it shines or its occlusion per cascade.
TEST_F(EffectsCommand, OcclusionPerLayerDrawsShinyScenesMattAndSaysSo) {
    const std::string render =
        "--validate render '" CDR_SOURCE_DIR "/tests/golden/spheres.gltf' --size 64x36 ";
    const std::string saying = "not drawn as requested: surfaces are matt";
    const ProgramResult perLayer = succeed(render + "--targets accumulate --occlusion 1:layers");
    EXPECT_NE(perLayer.out.find(saying), std::string::npos) << perLayer.out;
    const ProgramResult whole = succeed(render + "--occlusion 1");
    EXPECT_EQ(whole.out.find(saying), std::string::npos) << whole.out;
}

TEST_F(EffectsCommand, RefusesWhatCannotBe) {
    expectRefusal("effects --occlusion=-1", "not negative");
}

} // namespace

} // namespace cdr::cli_test
