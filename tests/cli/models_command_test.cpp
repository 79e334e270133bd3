#include "program.h"

#include <cdr/image/codec.h>
#include <cdr/platform/file.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

namespace cdr::cli_test {

namespace {

using nlohmann::json;
using ModelsCommand = FolderTest;

const std::string kAssets = CDR_SOURCE_DIR "/tests/assets/";

TEST_F(ModelsCommand, HoldsModelsAgainstTheReference) {
    const json document = documentOf("--validate models " + kAssets + "well.gltf " + kAssets +
                                     "machine.glb --time 0.8 --size 240x135 --threads 2 --out m");
    EXPECT_EQ(document["command"], "models");
    ASSERT_EQ(document["results"].size(), 2u);
    for (const json& row : document["results"]) {
        EXPECT_EQ(row["light"], "sky");
        EXPECT_GT(row["triangles"], 100);
        EXPECT_GT(row["covered_fraction"], 0.1);
        EXPECT_GT(row["flip"], 0.0);
        EXPECT_LE(row["flip"], 0.05);
        EXPECT_LE(row["covered_flip"], 0.1);
        EXPECT_LE(row["mean_steps"], 1.0); // of pixels that show the model
        EXPECT_GE(row["mean_steps"], 0.3); // background, which is right, would make it less
        const auto name = row["model"].get<std::string>();
        const auto read = [&](const std::string& suffix) {
            return image::decodeImage(platform::readFile(at("m") / (name + suffix + ".png"), 1u << 30u), "m");
        };
        EXPECT_EQ(read("").width, 240u);
        EXPECT_NE(read(""), read("_plain"));
        const auto covered = [&](const image::ImageRgba8& picture) {
            std::vector<bool> all;
            std::transform(picture.pixels.begin(), picture.pixels.end(), std::back_inserter(all),
                           [&](const image::Rgba8& pixel) { return pixel != picture.pixels.front(); });
            return all;
        };
        if (name == "machine") { // whose background differs with the light, but not what it covers
            const std::vector<bool> lit = covered(read("_reference"));
            const std::vector<bool> plain = covered(read("_plain"));
            std::size_t differing = 0;
            for (std::size_t i = 0; i < lit.size(); ++i) {
                differing += lit[i] != plain[i] ? 1 : 0;
            }
            EXPECT_LT(differing, lit.size() / 100); // the same moment
        }
        EXPECT_NE(read(""), read("_reference"));
        EXPECT_EQ(read("_flip").height, 135u);
    }
    EXPECT_GT(image::decodeImage(platform::readFile(at("m/models_sheet.png"), 1u << 30u), "m").width, 900u);
}

/// A lawn at a low angle, leaves whose normals face away, smooth and rough balls: under a sky, where most is mirrored.
TEST_F(ModelsCommand, ModelsUnderASkyAreCloseToTheReferenceWhereTheyCover) {
    const json document = documentOf("models " + kAssets + "garden.glb " + kAssets + "materials.glb " +
                                     kAssets + "stage.glb --size 320x180 --threads 2");
    ASSERT_EQ(document["results"].size(), 3u);
    for (const json& row : document["results"]) {
        EXPECT_LE(row["covered_flip"], 0.05) << row;
        EXPECT_LE(row["mean_steps"], 3.0) << row; // of pixels that show the model
    }
}

/// Five textures that are read as three, under a sky and under lamps.
TEST_F(ModelsCommand, AModelWithPackedTexturesIsCloseToTheReference) {
    for (const std::string light : {"sky", "lamps"}) {
        const json row = documentOf("models " + kAssets + "shield.glb --size 320x180 --threads 2 --light " +
                                    light)["results"][0];
        EXPECT_EQ(row["textures"], 5) << row;
        EXPECT_GT(row["covered_fraction"], 0.3) << row;
        EXPECT_LE(row["flip"], 0.05) << row;
        EXPECT_LE(row["mean_steps"], 2.0) << row;
    }
}

/// Nothing of it is opaque.
TEST_F(ModelsCommand, AModelThatBlendsAloneIsCovered) {
    json model = json::parse(readText(kAssets + "well.gltf"));
    for (json& material : model["materials"]) {
        material["alphaMode"] = "BLEND";
        material["pbrMetallicRoughness"]["baseColorFactor"] = {0.8, 0.7, 0.6, 0.5};
    }
    platform::writeText(at("glass.gltf"), model.dump());
    for (const char* name : {"well.bin", "stone.jpg"}) {
        std::filesystem::copy_file(kAssets + name, at(name));
    }
    const json row = documentOf("models glass.gltf --size 240x135 --threads 2")["results"][0];
    EXPECT_GT(row["covered_fraction"], 0.1) << row;
    EXPECT_GT(row["covered_flip"], row["flip"]) << row;
    EXPECT_LE(row["covered_flip"], 0.05) << row;
}

/// Whose sheet would be shrunk by more than they are high.
TEST_F(ModelsCommand, TakesLowWidePictures) {
    succeed("models " + kAssets + "well.gltf --size 640x1 --out m");
    EXPECT_TRUE(std::filesystem::exists(at("m/models_sheet.png")));
}

TEST_F(ModelsCommand, TakesAModelsOwnLightsAndCamera) {
    const auto reference = [&](const std::string& more) {
        const json row = documentOf("models " + kAssets + "stage.glb --camera 0 --size 240x135 " + more +
                                    " --out m")["results"][0];
        EXPECT_LE(row["covered_flip"], 0.05) << more;
        return textIn("m/stage_reference.png");
    };
    const std::string still = reference("--light file");
    EXPECT_NE(still, reference("--light file --time 0.5"));
    EXPECT_NE(still, reference("--light lamps"));
}

TEST_F(ModelsCommand, PicturesOfFilesOfOneNameHaveTheirFoldersNamesToo) {
    for (const char* place : {"a/model", "b/model", "c"}) {
        std::filesystem::create_directories(at(place));
        std::filesystem::copy_file(CDR_SOURCE_DIR "/tests/golden/shapes.gltf", at(place) / "shapes.gltf");
    }
    const json rows = documentOf("models a/model/shapes.gltf b/model/shapes.gltf c/shapes.gltf " + kAssets +
                                 "stage.glb --size 64x36 --out m")["results"];
    ASSERT_EQ(rows.size(), 4u);
    EXPECT_EQ(rows[0]["model"], "a_model_shapes");
    EXPECT_EQ(rows[1]["model"], "b_model_shapes");
    EXPECT_EQ(rows[2]["model"], "c_shapes");
    EXPECT_EQ(rows[3]["model"], "stage");
    for (const char* name :
         {"a_model_shapes.png", "b_model_shapes_flip.png", "c_shapes.png", "stage_plain.png"}) {
        EXPECT_TRUE(std::filesystem::exists(at("m") / name)) << name;
    }
}

/// Where folders do not tell names apart: a_b, and b in a folder a.
TEST_F(ModelsCommand, NamesThatStayAlikeAreRefused) {
    const std::string deep = "1/2/3/4/5/6/7/8/9/";
    for (const std::string& file : {deep + "a_b.gltf", deep + "a/b.gltf", std::string("c/b.gltf")}) {
        std::filesystem::create_directories((at(file)).parent_path());
        std::filesystem::copy_file(CDR_SOURCE_DIR "/tests/golden/shapes.gltf", at(file));
    }
    expectRefusal("models " + deep + "a_b.gltf " + deep + "a/b.gltf c/b.gltf --size 64x36 --out m",
                  "two models would both be written as ");
}

} // namespace

} // namespace cdr::cli_test
