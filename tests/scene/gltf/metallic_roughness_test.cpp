#include "fixture.h"

#include <cdr/image/codec.h>

namespace cdr::scene::test {
namespace {

using GltfMetallicRoughness = GltfFolder;

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

TEST_F(GltfMetallicRoughness, FactorsAreKept) {
    const GltfImport result = load(withFactors({{"metallicFactor", 0.25}, {"roughnessFactor", 0.75}}));
    EXPECT_EQ(result.scene.materials.at(0).metallicRoughness,
              (MetallicRoughness{.metallic = 0.25f, .roughness = 0.75f}));
    EXPECT_TRUE(result.ignored.empty());
}

TEST_F(GltfMetallicRoughness, FactorsThatAreLeftOutAreOne) {
    EXPECT_EQ(load(withFactors({{"metallicFactor", 0.25}})).scene.materials.at(0).metallicRoughness,
              (MetallicRoughness{.metallic = 0.25f, .roughness = 1.0f}));
    EXPECT_EQ(load(withFactors({{"roughnessFactor", 0.25}})).scene.materials.at(0).metallicRoughness,
              (MetallicRoughness{.metallic = 1.0f, .roughness = 0.25f}));
    Document document = square();
    document.root["materials"] = {{{"name", "bare"}}};
    document.primitive()["material"] = 0;
    EXPECT_EQ(load(document).scene.materials.at(0).metallicRoughness,
              (MetallicRoughness{.metallic = 1.0f, .roughness = 1.0f}));
    // And of the material that is used where a primitive names none.
    EXPECT_EQ(load(square()).scene.materials.at(0).metallicRoughness,
              (MetallicRoughness{.metallic = 1.0f, .roughness = 1.0f}));
}

TEST_F(GltfMetallicRoughness, FactorsAreClamped) {
    EXPECT_EQ(load(withFactors({{"metallicFactor", -2}, {"roughnessFactor", 1e300}}))
                  .scene.materials.at(0)
                  .metallicRoughness,
              (MetallicRoughness{.metallic = 0.0f, .roughness = 1.0f}));
}

/// The default would show another material than the file means.
TEST_F(GltfMetallicRoughness, FactorsThatAreNoNumbersAreRefused) {
    expectSays(refusal(withFactors({{"metallicFactor", "0.5"}})),
               "material 'paint': 'metallicFactor' is not a number");
    expectSays(refusal(withFactors({{"roughnessFactor", {0.5}}})), "'roughnessFactor' is not a number");
    expectRefused(withFactors(json::object()), "/materials/0/alphaCutoff", "0.5",
                  "'alphaCutoff' is not a number");
}

TEST_F(GltfMetallicRoughness, UnlitMaterialsHaveNone) {
    // What they would look like elsewhere is not read: the texture does not exist.
    Document document = withFactors({{"metallicFactor", 0.5}, {"metallicRoughnessTexture", {{"index", 9}}}});
    document.root["materials"][0]["extensions"] = {{"KHR_materials_unlit", json::object()}};
    const GltfImport result = load(document);
    EXPECT_FALSE(result.scene.materials.at(0).metallicRoughness);
    EXPECT_TRUE(result.scene.materials.at(0).unlit);
    EXPECT_TRUE(result.ignored.empty());
}

TEST_F(GltfMetallicRoughness, TexturesAreKeptAsDataBesideTheFactors) {
    const GltfImport result =
        load(withTexture({{"metallicFactor", 0.5}, {"roughnessFactor", 0.25}}, twoTexels()));
    const Material& material = result.scene.materials.at(0);
    EXPECT_EQ(material.metallicRoughness, (MetallicRoughness{.metallic = 0.5f, .roughness = 0.25f}));
    const Texture& texture = result.scene.textures.at(material.detail.metallicRoughness.value().texture);
    EXPECT_EQ(texture.content, TextureContent::data);
    EXPECT_EQ(texture.pixels.at(1, 0), (image::Rgba8{0, 102, 204, 0}));
    EXPECT_TRUE(result.ignored.empty());
}

TEST_F(GltfMetallicRoughness, OnePictureMayBeColorAndData) {
    Document document = withTexture(json::object(), twoTexels());
    document.root["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
    const Scene scene = load(document).scene;
    ASSERT_EQ(scene.textures.size(), 2u); // an image is either encoded or not
    const Material& material = scene.materials.at(0);
    EXPECT_EQ(scene.textures.at(material.baseColorTexture.value()).content, TextureContent::color);
    EXPECT_EQ(scene.textures.at(material.detail.metallicRoughness.value().texture).content,
              TextureContent::data);
}

TEST_F(GltfMetallicRoughness, TexturesThatOnlyAnExtensionSuppliesLeaveTheFactors) {
    Document document = withTexture({{"metallicFactor", 0.5}, {"roughnessFactor", 0.25}}, twoTexels());
    document.root["textures"] = {{{"extensions", {{"EXT_texture_webp", {{"source", 0}}}}}}};
    const GltfImport result = load(document);
    EXPECT_EQ(result.scene.materials.at(0).metallicRoughness,
              (MetallicRoughness{.metallic = 0.5f, .roughness = 0.25f}));
    EXPECT_TRUE(anySays(result.ignored, "supplied by an extension"));
    EXPECT_FALSE(result.scene.materials.at(0).detail.metallicRoughness);
}

TEST_F(GltfMetallicRoughness, UnsoundTexturesAreRefused) {
    const Document sound = withTexture(json::object(), twoTexels());
    expectRefused(sound, "/materials/0/pbrMetallicRoughness/metallicRoughnessTexture/index", 1,
                  "texture 1 does not exist");
    expectRefused(sound, "/textures/0/source", 1, "image 1 does not exist");
    expectRefused(sound, "/images/0/bufferView", 77, "buffer view 77 does not exist");
    Document document = sound;
    document.root["bufferViews"].back()["byteLength"] = 50;
    expectSays(refusal(document), "image 0: damaged PNG");
    document = sound;
    document.root["materials"][0]["pbrMetallicRoughness"]["metallicRoughnessTexture"] = json::object();
    EXPECT_NE(refusal(document), "loaded");
}

} // namespace
} // namespace cdr::scene::test
