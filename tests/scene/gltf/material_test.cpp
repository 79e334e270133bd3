#include "fixture.h"

#include <cdr/image/codec.h>

#include <limits>
#include <numbers>
#include <tuple>

namespace cdr::scene::test {
namespace {

using Gltf = GltfFolder;

/// A square with uvs and a material whose base colour is a picture in the buffer.
Document textured() {
    Document document = square();
    document.setFloats("TEXCOORD_0", "VEC2", {0, 0, 1, 0, 1, 1, 0, 1});
    image::ImageRgba8 picture(2, 1, {10, 20, 30, 255});
    picture.at(1, 0) = {40, 50, 60, 70};
    document.root["images"] = {{{"name", "picture"},
                                {"bufferView", document.addView(image::encodePng(picture))},
                                {"mimeType", "image/png"}}};
    document.root["textures"] = {{{"source", 0}}};
    document.root["materials"] = {
        {{"name", "paint"}, {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
    document.primitive()["material"] = 0;
    return document;
}

/// A second primitive, alike but for its material: the same with texture 1.
void giveSecondMaterial(Document& document) {
    document.root["materials"].push_back(document.root["materials"][0]);
    document.root["materials"][1]["pbrMetallicRoughness"]["baseColorTexture"]["index"] = 1;
    json second = document.primitive();
    second["material"] = 1;
    document.root["meshes"][0]["primitives"].push_back(second);
}

json& baseColorTexture(Document& document) {
    return document.root["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"];
}

TEST_F(Gltf, MaterialsKeepWhatWeDraw) {
    Document document = square();
    document.root["materials"] = {{{"name", "glass"},
                                   {"alphaMode", "MASK"},
                                   {"alphaCutoff", 0.25},
                                   {"doubleSided", true},
                                   {"extensions", {{"KHR_materials_unlit", json::object()}}},
                                   {"pbrMetallicRoughness", {{"baseColorFactor", {0.5, 0.25, 2, 0.125}}}}}};
    document.primitive()["material"] = 0;
    const Scene scene = load(document).scene;
    const Material& material = scene.materials.at(scene.instances.material[0]);
    EXPECT_EQ(material.name, "glass");
    EXPECT_EQ(material.baseColorFactor, glm::vec4(0.5f, 0.25f, 1.0f, 0.125f));
    EXPECT_EQ(material.alphaMode, AlphaMode::mask);
    EXPECT_EQ(material.alphaCutoff, 0.25f);
    EXPECT_TRUE(material.doubleSided);
    EXPECT_TRUE(material.unlit);
    EXPECT_FALSE(material.baseColorTexture);
    document.root["materials"][0]["alphaCutoff"] = -1;
    EXPECT_EQ(load(document).scene.materials[0].alphaCutoff, 0.0f);
    document.root["materials"][0]["alphaCutoff"] = 1e300;
    EXPECT_EQ(load(document).scene.materials[0].alphaCutoff, std::numeric_limits<float>::max());
    document.root["materials"][0]["alphaMode"] = "BLEND";
    EXPECT_EQ(load(document).scene.materials[0].alphaMode, AlphaMode::blend);
    document.root["materials"][0]["alphaMode"] = "GLOW";
    expectSays(refusal(document), "alpha mode 'GLOW' does not exist");
}

TEST_F(Gltf, AlphaSaysHowATexturesLevelsAreMade) {
    Document document = textured();
    json& material = document.root["materials"][0];
    const auto texture = [&] { return load(document).scene.textures.at(0); };
    EXPECT_FALSE(texture().alphaWeighs);
    EXPECT_FALSE(texture().cutoff);
    material["alphaMode"] = "BLEND";
    EXPECT_TRUE(texture().alphaWeighs);
    EXPECT_FALSE(texture().cutoff);
    material["alphaMode"] = "MASK";
    material["pbrMetallicRoughness"]["baseColorFactor"] = {1, 1, 1, 0.75};
    EXPECT_TRUE(texture().alphaWeighs);
    EXPECT_EQ(texture().cutoff, 0.5f / 0.75f);
    material["alphaCutoff"] = 0.8; // all is cut away
    EXPECT_FALSE(texture().cutoff);
    material["alphaCutoff"] = 0.0; // nothing is
    EXPECT_FALSE(texture().cutoff);
}

/// What an opaque and a masked material show has levels of either kind.
TEST_F(Gltf, APictureHasLevelsForEachUseOfItsAlpha) {
    Document document = textured();
    document.root["materials"].push_back(document.root["materials"][0]);
    document.root["materials"][1]["alphaMode"] = "MASK";
    document.root["meshes"][0]["primitives"].push_back(document.primitive());
    document.root["meshes"][0]["primitives"][1]["material"] = 1;
    const Scene scene = load(document).scene;
    ASSERT_EQ(scene.textures.size(), 2u);
    EXPECT_NE(scene.textures[0].alphaWeighs, scene.textures[1].alphaWeighs);
    EXPECT_EQ(scene.textures[0].pixels, scene.textures[1].pixels);
}

TEST_F(Gltf, WithoutAMaterialTheDefaultOneIsMade) {
    Document document = square();
    document.root["meshes"][0]["primitives"].push_back(document.primitive());
    const Scene scene = load(document).scene;
    ASSERT_EQ(scene.materials.size(), 1u);
    EXPECT_EQ(scene.materials[0].baseColorFactor, glm::vec4(1));
    EXPECT_EQ(scene.materials[0].alphaMode, AlphaMode::opaque);
    EXPECT_FALSE(scene.materials[0].doubleSided);
}

TEST_F(Gltf, PicturesInTheBuffer) {
    const Scene scene = load(textured()).scene;
    ASSERT_EQ(scene.textures.size(), 1u);
    EXPECT_EQ(scene.materials[0].baseColorTexture, 0u);
    EXPECT_EQ(scene.textures[0].name, "picture");
    EXPECT_EQ(scene.textures[0].pixels.at(1, 0), (image::Rgba8{40, 50, 60, 70}));
    EXPECT_EQ(scene.textures[0].wrapU, WrapMode::repeat);
    EXPECT_EQ(scene.textures[0].wrapV, WrapMode::repeat);
    EXPECT_EQ(scene.meshes[0].vertices[2].uv, glm::vec2(1, 1));
}

TEST_F(Gltf, PicturesBesideTheFileAndAsDataUri) {
    Document document = textured();
    image::writeImage(folder() / "a picture.png", image::ImageRgba8(3, 3, {1, 2, 3, 4}));
    document.root["images"] = {{{"uri", "a%20picture.png"}}};
    EXPECT_EQ(load(document).scene.textures[0].pixels.width, 3u);
    // One white pixel.
    document.root["images"] = {{{"uri", "data:image/png;base64,"
                                        "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAQAAAC1HAwCAAAAC0lEQVR42mP8/"
                                        "x8AAwMCAO+ip1sAAAAASUVORK5CYII="}}};
    EXPECT_EQ(load(document).scene.textures.at(0).pixels.at(0, 0), (image::Rgba8{255, 255, 255, 255}));
    document.root["images"] = {{{"uri", "data:image/png;base64,!!!!"}}};
    expectSays(refusal(document), "cannot be decoded");
}

TEST_F(Gltf, OnePictureOfManyMaterialsIsDecodedOnce) {
    Document document = textured();
    document.root["textures"].push_back({{"source", 0}});
    giveSecondMaterial(document);
    const Scene scene = load(document).scene;
    EXPECT_EQ(scene.materials.size(), 2u);
    EXPECT_EQ(scene.textures.size(), 1u);
}

TEST_F(Gltf, OnePictureWrappedInTwoWaysIsTwoTextures) {
    Document document = textured();
    document.root["samplers"] = {{{"wrapS", 33071}, {"wrapT", 33071}}};
    document.root["textures"].push_back({{"source", 0}, {"sampler", 0}});
    giveSecondMaterial(document);
    const Scene scene = load(document).scene;
    ASSERT_EQ(scene.textures.size(), 2u);
    EXPECT_EQ(scene.textures[scene.materials[0].baseColorTexture.value()].wrapU, WrapMode::repeat);
    EXPECT_EQ(scene.textures[scene.materials[1].baseColorTexture.value()].wrapU, WrapMode::clampToEdge);
}

TEST_F(Gltf, WrappingOfSamplers) {
    Document document = textured();
    document.root["samplers"] = {{{"wrapS", 33071}, {"wrapT", 33648}}};
    document.root["textures"][0]["sampler"] = 0;
    const GltfImport result = load(document);
    EXPECT_EQ(result.scene.textures[0].wrapU, WrapMode::clampToEdge);
    EXPECT_EQ(result.scene.textures[0].wrapV, WrapMode::mirroredRepeat);
    EXPECT_TRUE(result.ignored.empty());
    document.root["samplers"][0]["wrapS"] = 3;
    expectSays(refusal(document), "wrap mode 3 does not exist");
    document.root["textures"][0]["sampler"] = 1;
    expectSays(refusal(document), "sampler 1 does not exist");
}

TEST_F(Gltf, FiltersOfSamplersAreKept) {
    using Filters = std::tuple<Filter, Filter, TextureLevels>;
    Document document = textured();
    document.root["textures"][0]["sampler"] = 0;
    const auto filters = [&](const json& sampler) -> Filters {
        document.root["samplers"] = {sampler};
        const GltfImport result = load(document);
        EXPECT_TRUE(result.ignored.empty());
        const Texture& texture = result.scene.textures.at(0);
        return {texture.magFilter, texture.minFilter, texture.levels};
    };
    EXPECT_EQ(filters(json::object()), Filters(Filter::linear, Filter::linear, TextureLevels::blended));
    EXPECT_EQ(filters({{"magFilter", 9729}}),
              Filters(Filter::linear, Filter::linear, TextureLevels::blended));
    EXPECT_EQ(filters({{"magFilter", 9728}}),
              Filters(Filter::nearest, Filter::linear, TextureLevels::blended));
    EXPECT_EQ(filters({{"minFilter", 9728}}), Filters(Filter::linear, Filter::nearest, TextureLevels::none));
    EXPECT_EQ(filters({{"minFilter", 9729}}), Filters(Filter::linear, Filter::linear, TextureLevels::none));
    EXPECT_EQ(filters({{"minFilter", 9984}}),
              Filters(Filter::linear, Filter::nearest, TextureLevels::nearest));
    EXPECT_EQ(filters({{"minFilter", 9985}}),
              Filters(Filter::linear, Filter::linear, TextureLevels::nearest));
    EXPECT_EQ(filters({{"minFilter", 9986}}),
              Filters(Filter::linear, Filter::nearest, TextureLevels::blended));
    EXPECT_EQ(filters({{"minFilter", 9987}}),
              Filters(Filter::linear, Filter::linear, TextureLevels::blended));
    EXPECT_EQ(filters({{"minFilter", 5}}), Filters(Filter::linear, Filter::linear, TextureLevels::blended));
}

TEST_F(Gltf, OnePictureFilteredInTwoWaysIsTwoTextures) {
    Document document = textured();
    document.root["samplers"] = {{{"minFilter", 9729}}};
    document.root["textures"].push_back({{"source", 0}, {"sampler", 0}});
    giveSecondMaterial(document);
    const Scene scene = load(document).scene;
    ASSERT_EQ(scene.textures.size(), 2u);
    EXPECT_NE(scene.textures[0].levels, scene.textures[1].levels);
}

TEST_F(Gltf, TextureTransformIsBakedIntoTheUvs) {
    Document document = textured();
    // The example of KHR_texture_transform: the lower left quadrant, turned a quarter.
    baseColorTexture(document)["extensions"]["KHR_texture_transform"] = {
        {"offset", {0, 1}}, {"rotation", std::numbers::pi / 2}, {"scale", {0.5, 0.5}}};
    document.root["extensionsRequired"] = {"KHR_texture_transform"};
    const std::vector<Vertex> vertices = load(document).scene.meshes[0].vertices;
    const std::vector<glm::vec2> expected{{0, 1}, {0, 0.5}, {0.5, 0.5}, {0.5, 1}};
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(glm::length(vertices[i].uv - expected[i]), 0.0f, 1e-6f) << i;
    }
    baseColorTexture(document)["extensions"]["KHR_texture_transform"] = {{"offset", {0, 1}},
                                                                         {"scale", {1, -1}}};
    EXPECT_EQ(load(document).scene.meshes[0].vertices[0].uv, glm::vec2(0, 1));
    EXPECT_EQ(load(document).scene.meshes[0].vertices[2].uv, glm::vec2(1, 0));
}

TEST_F(Gltf, TextureCoordinateSetsAreChosen) {
    Document document = textured();
    document.setFloats("TEXCOORD_1", "VEC2", {5, 5, 6, 5, 6, 6, 5, 6});
    baseColorTexture(document)["texCoord"] = 1;
    EXPECT_EQ(load(document).scene.meshes[0].vertices[0].uv, glm::vec2(5, 5));
    baseColorTexture(document)["extensions"]["KHR_texture_transform"] = {{"texCoord", 0}};
    EXPECT_EQ(load(document).scene.meshes[0].vertices[0].uv, glm::vec2(0, 0));
    // A set that the mesh lacks gives zeros.
    baseColorTexture(document)["extensions"]["KHR_texture_transform"] = {{"texCoord", 2}};
    EXPECT_EQ(load(document).scene.meshes[0].vertices[2].uv, glm::vec2(0, 0));
}

TEST_F(Gltf, UnsoundTextureTransformsAreRefused) {
    const auto withTransform = [&](const json& transform) {
        Document document = textured();
        baseColorTexture(document)["extensions"]["KHR_texture_transform"] = transform;
        return refusal(document);
    };
    expectSays(withTransform({{"offset", {1}}}), "'offset' is not 2 numbers");
    expectSays(withTransform({{"scale", {1, "x"}}}), "'scale' is not 2 numbers");
    expectSays(withTransform({{"rotation", "left"}}), "'rotation' is not a number");
    expectSays(withTransform({{"texCoord", -1}}), "'texCoord' is -1, not an integer from 0");
}

TEST_F(Gltf, UnsoundMaterialReferencesAreRefused) {
    expectRefused(textured(), "/meshes/0/primitives/0/material", 1, "material 1 does not exist");
    expectRefused(textured(), "/materials/0/pbrMetallicRoughness/baseColorTexture/index", 1,
                  "texture 1 does not exist");
    expectRefused(textured(), "/textures/0/source", 1, "image 1 does not exist");
    expectRefused(textured(), "/images/0/bufferView", 77, "buffer view 77 does not exist");
    expectRefused(textured(), "/images/0/uri", "both.png", "one of 'uri' and 'bufferView'");
    Document document = textured();
    document.root["bufferViews"].back()["byteLength"] = 100000;
    expectSays(refusal(document), "buffer view");
    document.root["bufferViews"].back()["byteLength"] = 50;
    expectSays(refusal(document), "image 0: damaged PNG");
}

TEST_F(Gltf, PartsThatAreNotDrawnAreSaid) {
    Document document = textured();
    document.root["extensionsUsed"] = {"KHR_materials_unlit", "KHR_xmp_json_ld"};
    document.root["materials"][0]["extensions"]["KHR_materials_clearcoat"] = json::object();
    const std::vector<std::string> ignored = load(document).ignored;
    EXPECT_TRUE(anySays(ignored, "KHR_xmp_json_ld: extension not used"));
    EXPECT_TRUE(anySays(ignored, "KHR_materials_clearcoat: extension not used"));
    EXPECT_FALSE(anySays(ignored, "KHR_materials_unlit"));
    EXPECT_EQ(ignored.size(), 2u);
}

TEST_F(Gltf, EachExtensionThatIsNotDrawnIsNamedOnce) {
    Document document = textured();
    document.root["extensionsUsed"] = {"KHR_materials_sheen", "KHR_materials_clearcoat",
                                       "KHR_materials_sheen"};
    json& material = document.root["materials"][0];
    material["extensions"] = {
        {"KHR_materials_clearcoat", json::object()},
        {"KHR_materials_volume", {{"thicknessTexture", {{"extensions", {{"A_b", 1}}}}}}}};
    material["extras"] = {{"extensions", {{"of_somebody", 1}}}};
    EXPECT_EQ(load(document).ignored, (std::vector<std::string>{"KHR_materials_sheen: extension not used",
                                                                "KHR_materials_clearcoat: extension not used",
                                                                "KHR_materials_volume: extension not used",
                                                                "A_b: extension not used"}));
    for (int i = 0; i < 1000; ++i) {
        document.root["extensionsUsed"].push_back("OF_" + std::to_string(i));
    }
    const std::vector<std::string> many = load(document).ignored;
    EXPECT_EQ(many.size(), 65u);
    EXPECT_TRUE(anySays(many, "OF_62 and 939 more: extension not used")) << many.back();
}

TEST_F(Gltf, PictureThatOnlyAnExtensionSuppliesIsSaid) {
    Document document = textured();
    document.root["textures"] = {{{"extensions", {{"EXT_texture_webp", {{"source", 0}}}}}}};
    const GltfImport result = load(document);
    EXPECT_TRUE(result.scene.textures.empty());
    EXPECT_FALSE(result.scene.materials[0].baseColorTexture);
    EXPECT_TRUE(anySays(result.ignored, "supplied by an extension"));
}

} // namespace
} // namespace cdr::scene::test
