#include "fixture.h"

#include <cdr/image/codec.h>

namespace cdr::scene::test {
namespace {

using GltfShine = GltfFolder;

/// A square whose material has these factors and textures.
Document withFactors(const json& factors) {
    Document document = square();
    document.root["materials"] = {{{"name", "paint"}, {"pbrMetallicRoughness", factors}}};
    document.primitive()["material"] = 0;
    return document;
}

/// The same with a metallic-roughness texture: blue is metallic, green is roughness.
Document withTexture(json factors, const image::ImageRgba8& picture) {
    factors["metallicRoughnessTexture"] = {{"index", 0}};
    Document document = withFactors(factors);
    document.root["images"] = {
        {{"bufferView", document.addView(image::encodePng(picture))}, {"mimeType", "image/png"}}};
    document.root["textures"] = {{{"source", 0}}};
    return document;
}

image::ImageRgba8 twoTexels() {
    image::ImageRgba8 picture(2, 1, {255, 51, 0, 255});
    picture.at(1, 0) = {0, 102, 204, 0};
    return picture;
}

constexpr float kMeanMetallic = 0.4f;  // 0 and 204 of 255
constexpr float kMeanRoughness = 0.3f; // 51 and 102

TEST_F(GltfShine, FactorsAreKept) {
    const GltfImport result = load(withFactors({{"metallicFactor", 0.25}, {"roughnessFactor", 0.75}}));
    EXPECT_EQ(result.scene.materials.at(0).shine, (Shine{.metallic = 0.25f, .roughness = 0.75f}));
    EXPECT_TRUE(result.ignored.empty());
}

TEST_F(GltfShine, FactorsThatAreLeftOutAreOne) {
    EXPECT_EQ(load(withFactors({{"metallicFactor", 0.25}})).scene.materials.at(0).shine,
              (Shine{.metallic = 0.25f, .roughness = 1.0f}));
    EXPECT_EQ(load(withFactors({{"roughnessFactor", 0.25}})).scene.materials.at(0).shine,
              (Shine{.metallic = 1.0f, .roughness = 0.25f}));
    Document document = square();
    document.root["materials"] = {{{"name", "bare"}}};
    document.primitive()["material"] = 0;
    EXPECT_EQ(load(document).scene.materials.at(0).shine, (Shine{.metallic = 1.0f, .roughness = 1.0f}));
    // And of the material that is used where a primitive names none.
    EXPECT_EQ(load(square()).scene.materials.at(0).shine, (Shine{.metallic = 1.0f, .roughness = 1.0f}));
}

TEST_F(GltfShine, FactorsAreClamped) {
    EXPECT_EQ(
        load(withFactors({{"metallicFactor", -2}, {"roughnessFactor", 1e300}})).scene.materials.at(0).shine,
        (Shine{.metallic = 0.0f, .roughness = 1.0f}));
}

/// The default would show another material than the file means.
TEST_F(GltfShine, FactorsThatAreNoNumbersAreRefused) {
    expectSays(refusal(withFactors({{"metallicFactor", "0.5"}})),
               "material 'paint': 'metallicFactor' is not a number");
    expectSays(refusal(withFactors({{"roughnessFactor", {0.5}}})), "'roughnessFactor' is not a number");
    Document document = withFactors(json::object());
    document.root["materials"][0]["alphaCutoff"] = "0.5";
    expectSays(refusal(document), "'alphaCutoff' is not a number");
}

TEST_F(GltfShine, UnlitMaterialsHaveNone) {
    // What they would look like elsewhere is not read: the texture does not exist.
    Document document = withFactors({{"metallicFactor", 0.5}, {"metallicRoughnessTexture", {{"index", 9}}}});
    document.root["materials"][0]["extensions"] = {{"KHR_materials_unlit", json::object()}};
    const GltfImport result = load(document);
    EXPECT_FALSE(result.scene.materials.at(0).shine);
    EXPECT_TRUE(result.scene.materials.at(0).unlit);
    EXPECT_TRUE(result.ignored.empty());
}

TEST_F(GltfShine, TexturesAreAveragedAndSaid) {
    const GltfImport result = load(withTexture(json::object(), twoTexels()));
    const Shine shine = result.scene.materials.at(0).shine.value();
    EXPECT_NEAR(shine.metallic, kMeanMetallic, 1e-6f);
    EXPECT_NEAR(shine.roughness, kMeanRoughness, 1e-6f);
    EXPECT_TRUE(
        anySays(result.ignored, "material 'paint': metallic-roughness textures are drawn as their mean"));
    EXPECT_EQ(result.ignored.size(), 1u);
    EXPECT_TRUE(result.scene.textures.empty()); // and take no memory
}

TEST_F(GltfShine, TexturesScaleTheFactors) {
    const GltfImport result =
        load(withTexture({{"metallicFactor", 0.5}, {"roughnessFactor", 0.25}}, twoTexels()));
    const Shine shine = result.scene.materials.at(0).shine.value();
    EXPECT_NEAR(shine.metallic, 0.5f * kMeanMetallic, 1e-6f);
    EXPECT_NEAR(shine.roughness, 0.25f * kMeanRoughness, 1e-6f);
}

TEST_F(GltfShine, EachPictureHasAMeanOfItsOwn) {
    Document document = withTexture(json::object(), twoTexels());
    const image::ImageRgba8 other(1, 1, {9, 153, 51, 255});
    document.root["images"].push_back(
        {{"bufferView", document.addView(image::encodePng(other))}, {"mimeType", "image/png"}});
    document.root["textures"] = {{{"source", 1}}, {{"source", 0}}};
    document.root["materials"].push_back(document.root["materials"][0]);
    document.root["materials"][1]["pbrMetallicRoughness"]["metallicRoughnessTexture"]["index"] = 1;
    json second = document.primitive();
    second["material"] = 1;
    document.root["meshes"][0]["primitives"].push_back(second);
    const Scene scene = load(document).scene;
    ASSERT_EQ(scene.materials.size(), 2u);
    EXPECT_NEAR(scene.materials[0].shine.value().metallic, 0.2f, 1e-6f);
    EXPECT_NEAR(scene.materials[0].shine.value().roughness, 0.6f, 1e-6f);
    EXPECT_NEAR(scene.materials[1].shine.value().metallic, kMeanMetallic, 1e-6f);
    EXPECT_NEAR(scene.materials[1].shine.value().roughness, kMeanRoughness, 1e-6f);
}

TEST_F(GltfShine, OnePictureMayBeColorAndShine) {
    Document document = withTexture(json::object(), twoTexels());
    document.root["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
    document.root["materials"].push_back(document.root["materials"][0]);
    json second = document.primitive();
    second["material"] = 1;
    document.root["meshes"][0]["primitives"].push_back(second);
    const Scene scene = load(document).scene;
    ASSERT_EQ(scene.materials.size(), 2u);
    EXPECT_EQ(scene.materials[0].shine, scene.materials[1].shine);
    EXPECT_EQ(scene.textures.size(), 1u);
}

TEST_F(GltfShine, TexturesThatOnlyAnExtensionSuppliesLeaveTheFactors) {
    Document document = withTexture({{"metallicFactor", 0.5}, {"roughnessFactor", 0.25}}, twoTexels());
    document.root["textures"] = {{{"extensions", {{"EXT_texture_webp", {{"source", 0}}}}}}};
    const GltfImport result = load(document);
    EXPECT_EQ(result.scene.materials.at(0).shine, (Shine{.metallic = 0.5f, .roughness = 0.25f}));
    EXPECT_TRUE(anySays(result.ignored, "supplied by an extension"));
    EXPECT_FALSE(anySays(result.ignored, "mean"));
}

TEST_F(GltfShine, UnsoundTexturesAreRefused) {
    const Document sound = withTexture(json::object(), twoTexels());
    Document document = sound;
    document.root["materials"][0]["pbrMetallicRoughness"]["metallicRoughnessTexture"]["index"] = 1;
    expectSays(refusal(document), "texture 1 does not exist");
    document = sound;
    document.root["textures"][0]["source"] = 1;
    expectSays(refusal(document), "image 1 does not exist");
    document = sound;
    document.root["images"][0]["bufferView"] = 77;
    expectSays(refusal(document), "buffer view 77 does not exist");
    document = sound;
    document.root["bufferViews"].back()["byteLength"] = 50;
    expectSays(refusal(document), "image 0: damaged PNG");
    document = sound;
    document.root["materials"][0]["pbrMetallicRoughness"]["metallicRoughnessTexture"] = json::object();
    EXPECT_NE(refusal(document), "loaded");
}

} // namespace
} // namespace cdr::scene::test
