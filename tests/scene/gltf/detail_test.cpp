#include "fixture.h"

#include <cmath>

namespace cdr::scene::test {
namespace {

using GltfDetail = GltfFolder;

/// A square with two sets of UVs, a picture and a material of one normal texture.
Document bumpy() {
    Document document = square();
    document.setFloats("NORMAL", "VEC3", {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
    document.setFloats("TEXCOORD_0", "VEC2", {0, 1, 1, 1, 1, 0, 0, 0});
    document.setFloats("TEXCOORD_1", "VEC2", {0, 0, 0, 2, 2, 2, 2, 0});
    giveNormalTexture(document);
    document.root["materials"][0]["name"] = "paint";
    return document;
}

/// Tangents of the file, so that nothing derives them and notes how.
void giveTangents(Document& document) {
    document.setFloats("TANGENT", "VEC4", {1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1});
}

const MaterialDetail& detailOf(const Scene& scene) {
    return scene.materials.at(scene.instances.material.at(0)).detail;
}

TEST_F(GltfDetail, TexturesAreData) {
    Document document = bumpy();
    giveTangents(document);
    json& material = document.root["materials"][0];
    material["normalTexture"]["scale"] = 0.5;
    material["occlusionTexture"] = {{"index", 0}, {"strength", 0.25}};
    material["emissiveTexture"] = {{"index", 0}};
    material["emissiveFactor"] = {1, 0.5, 2};
    const GltfImport result = load(document);
    const MaterialDetail& detail = detailOf(result.scene);
    EXPECT_EQ(detail.normalScale, 0.5f);
    EXPECT_EQ(detail.occlusionStrength, 0.25f);
    EXPECT_EQ(detail.emission, glm::vec3(1.0f, 0.5f, 1.0f));
    EXPECT_EQ(detail.normal, detail.occlusion); // one picture, read alike
    EXPECT_EQ(result.scene.textures.at(detail.normal.value().texture).content, TextureContent::data);
    EXPECT_EQ(result.scene.textures.at(detail.emissive.value().texture).content, TextureContent::color);
    EXPECT_TRUE(result.ignored.empty());
}

TEST_F(GltfDetail, EmissionMayBeStronger) {
    Document document = bumpy();
    giveTangents(document);
    json& material = document.root["materials"][0];
    material["emissiveFactor"] = {1, 0.5, 0};
    material["extensions"] = {{"KHR_materials_emissive_strength", {{"emissiveStrength", 6}}}};
    document.root["extensionsUsed"] = {"KHR_materials_emissive_strength"};
    const GltfImport result = load(document);
    EXPECT_EQ(detailOf(result.scene).emission, glm::vec3(6.0f, 3.0f, 0.0f));
    EXPECT_TRUE(result.ignored.empty());
    material["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"] = 1e300;
    EXPECT_LE(detailOf(load(document).scene).emission.r, 1e4f);
    material["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"] = "bright";
    expectSays(refusal(document), "'emissiveStrength' is not a number");
}

TEST_F(GltfDetail, UnlitMaterialsHaveNone) {
    Document document = bumpy();
    document.root["materials"][0]["extensions"] = {{"KHR_materials_unlit", json::object()}};
    const Scene scene = load(document).scene;
    EXPECT_EQ(detailOf(scene), MaterialDetail{});
    EXPECT_TRUE(scene.textures.empty());
}

TEST_F(GltfDetail, ASecondPlaceInTextures) {
    Document document = bumpy();
    json& material = document.root["materials"][0];
    material["occlusionTexture"] = {{"index", 0}, {"texCoord", 1}};
    const Scene scene = load(document).scene;
    EXPECT_FALSE(detailOf(scene).normal.value().second);
    EXPECT_TRUE(detailOf(scene).occlusion.value().second);
    ASSERT_EQ(scene.meshes[0].details.size(), scene.meshes[0].vertices.size());
    for (std::size_t i = 0; i < scene.meshes[0].vertices.size(); ++i) {
        const glm::vec2 first = scene.meshes[0].vertices[i].uv;
        EXPECT_EQ(scene.meshes[0].details[i].uv, glm::vec2(2.0f - 2.0f * first.y, 2.0f * first.x));
    }
}

TEST_F(GltfDetail, TransformsMakePlacesToo) {
    Document document = bumpy();
    json& material = document.root["materials"][0];
    const json moved = {{"KHR_texture_transform", {{"offset", {0.25, 0.5}}}}};
    material["occlusionTexture"] = {{"index", 0}, {"extensions", moved}};
    const Scene scene = load(document).scene;
    EXPECT_TRUE(detailOf(scene).occlusion.value().second);
    EXPECT_EQ(scene.meshes[0].details[2].uv, scene.meshes[0].vertices[2].uv + glm::vec2(0.25f, 0.5f));
}

/// A texture whose set of coordinates has a place already is led from there to its own.
TEST_F(GltfDetail, FurtherPlacesAreLedTo) {
    Document document = bumpy();
    giveTangents(document);
    json& material = document.root["materials"][0];
    const auto at = [](double offset, double scale, double rotation) {
        const json transform{{"offset", {offset, 0.5}}, {"scale", {scale, 2.0}}, {"rotation", rotation}};
        return json{{"index", 0}, {"extensions", {{"KHR_texture_transform", transform}}}};
    };
    material["pbrMetallicRoughness"]["baseColorTexture"] = at(0.25, 4.0, 0.3);
    material["pbrMetallicRoughness"]["metallicRoughnessTexture"] = at(0.75, -0.5, 1.1);
    material["normalTexture"] = at(1.25, 3.0, 0.0);
    material["occlusionTexture"] = at(0.5, 1.5, -2.0);
    material["emissiveTexture"] = {{"index", 0}};
    material["emissiveFactor"] = {1, 1, 1};
    const GltfImport result = load(document);
    EXPECT_TRUE(result.ignored.empty());
    const MaterialDetail& detail = detailOf(result.scene);
    EXPECT_TRUE(detail.normal.value().second); // tangents follow it
    EXPECT_EQ(detail.normal.value().transform, glm::mat3x2(1.0f));
    const Mesh& mesh = result.scene.meshes[0];
    const std::vector<glm::vec2> corners{{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    const auto expectAt = [&](const std::optional<TextureUse>& use, const glm::dvec2& offset, double scale,
                              double rotation, double scaleV) {
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const glm::dvec2 scaled(corners[i].x * scale, corners[i].y * scaleV);
            const double c = std::cos(rotation);
            const double s = std::sin(rotation);
            const glm::vec2 wanted(offset +
                                   glm::dvec2(c * scaled.x + s * scaled.y, c * scaled.y - s * scaled.x));
            const glm::vec2 from = use.value().second ? mesh.details[i].uv : mesh.vertices[i].uv;
            EXPECT_NEAR(glm::distance(use->transform * glm::vec3(from, 1.0f), wanted), 0.0f, 1e-5f);
        }
    };
    expectAt(detail.metallicRoughness, {0.75, 0.5}, -0.5, 1.1, 2.0);
    expectAt(detail.normal, {1.25, 0.5}, 3.0, 0.0, 2.0);
    expectAt(detail.occlusion, {0.5, 0.5}, 1.5, -2.0, 2.0);
    expectAt(detail.emissive, {0.0, 0.0}, 1.0, 0.0, 1.0);
}

/// The second set has the second place, so that all are drawn.
TEST_F(GltfDetail, ASecondSetComesBeforeFurtherPlaces) {
    Document document = bumpy();
    giveTangents(document);
    json& material = document.root["materials"][0];
    const json stretched = {{"KHR_texture_transform", {{"scale", {2, 3}}}}};
    material["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
    material["normalTexture"]["extensions"] = stretched; // turns no tangent
    material["occlusionTexture"] = {{"index", 0}, {"texCoord", 1}};
    GltfImport result = load(document);
    EXPECT_TRUE(result.ignored.empty());
    EXPECT_EQ(detailOf(result.scene).normal,
              (TextureUse{.texture = 1, .transform = {2.0f, 0.0f, 0.0f, 3.0f, 0.0f, 0.0f}}));
    EXPECT_EQ(detailOf(result.scene).occlusion, (TextureUse{.texture = 1, .second = true}));
    // Tangents of the first place are of no use to a normal texture that is turned against it.
    material["normalTexture"]["extensions"]["KHR_texture_transform"]["rotation"] = 0.5;
    result = load(document);
    EXPECT_TRUE(anySays(result.ignored, "material 'paint': normalTexture is drawn where another texture is"));
}

TEST_F(GltfDetail, AThirdSetIsSaid) {
    Document document = bumpy();
    json& material = document.root["materials"][0];
    material["occlusionTexture"] = {{"index", 0}, {"texCoord", 1}};
    material["emissiveFactor"] = {1, 1, 1};
    material["emissiveTexture"] = {{"index", 0}, {"texCoord", 2}};
    EXPECT_TRUE(anySays(load(document).ignored,
                        "material 'paint': emissiveTexture is drawn where another texture is"));
    const json flat = {{"KHR_texture_transform", {{"scale", {0, 0}}}}}; // leads nowhere
    material["normalTexture"]["extensions"] = flat;
    material["emissiveTexture"] = {{"index", 0}};
    EXPECT_TRUE(anySays(load(document).ignored,
                        "material 'paint': emissiveTexture is drawn where another texture is"));
}

TEST_F(GltfDetail, TangentsOfTheFileAreKept) {
    Document document = bumpy();
    document.setFloats("TANGENT", "VEC4", {0, 2, 0, -1, 0, 2, 0, -1, 0, 2, 0, -1, 0, 0, 0, 1});
    const GltfImport result = load(document);
    const std::vector<VertexDetail>& details = result.scene.meshes[0].details;
    ASSERT_EQ(details.size(), 4u);
    EXPECT_EQ(details[0].tangent, glm::vec4(0.0f, 1.0f, 0.0f, -1.0f));
    EXPECT_NEAR(glm::length(glm::vec3(details[3].tangent)), 1.0f, 1e-6f);
    EXPECT_TRUE(anySays(result.ignored, "a tangent has no direction"));
}

/// u grows along x and v down: nothing is mirrored.
TEST_F(GltfDetail, TangentsAreDerivedFromTheTexture) {
    const Scene scene = load(bumpy()).scene;
    ASSERT_EQ(scene.meshes[0].details.size(), 4u);
    for (const VertexDetail& detail : scene.meshes[0].details) {
        EXPECT_NEAR(glm::distance(detail.tangent, glm::vec4(1.0f, 0.0f, 0.0f, 1.0f)), 0.0f, 1e-6f);
    }
}

TEST_F(GltfDetail, TangentsFollowTheSecondPlaceWhereTheNormalTextureDoes) {
    Document document = bumpy();
    document.root["materials"][0]["occlusionTexture"] = {{"index", 0}, {"texCoord", 1}};
    document.root["materials"][0]["normalTexture"]["texCoord"] = 1;
    document.root["materials"][0]["pbrMetallicRoughness"] = {{"baseColorTexture", {{"index", 0}}}};
    const Scene scene = load(document).scene;
    ASSERT_TRUE(detailOf(scene).normal.value().second);
    for (const VertexDetail& detail : scene.meshes[0].details) { // u grows along y, v along x
        EXPECT_NEAR(glm::distance(detail.tangent, glm::vec4(0.0f, 1.0f, 0.0f, 1.0f)), 0.0f, 1e-6f);
    }
}

/// Both triangles of the square share two corners; the second triangle is made to run through its texture backwards.
TEST_F(GltfDetail, AVertexBetweenTwoSensesBecomesTwo) {
    Document document = bumpy();
    document.setFloats("TEXCOORD_0", "VEC2", {0, 1, 1, 1, 1, 0, 2, 1});
    const Mesh mesh = load(document).scene.meshes.at(0);
    ASSERT_EQ(mesh.indices.size(), 6u);
    EXPECT_EQ(mesh.vertices.size(), 6u);
    EXPECT_EQ(mesh.details.size(), 6u);
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(mesh.details[mesh.indices[i]].tangent.w, i < 3 ? 1.0f : -1.0f) << i;
    }
}

TEST_F(GltfDetail, MeshesWithoutNeedHaveNoDetails) {
    Document document = bumpy();
    document.root["materials"][0] = {{"name", "plain"}, {"emissiveFactor", {1, 1, 1}}};
    EXPECT_TRUE(load(document).scene.meshes[0].details.empty());
}

TEST_F(GltfDetail, UnsoundReferencesAreRefused) {
    for (const char* key : {"normalTexture", "occlusionTexture", "emissiveTexture"}) {
        Document document = bumpy();
        document.root["materials"][0]["emissiveFactor"] = {1, 1, 1};
        document.root["materials"][0][key] = {{"index", 7}};
        expectSays(refusal(document), "texture 7 does not exist");
        document.root["materials"][0][key] = {{"index", 0}, {"texCoord", "x"}};
        EXPECT_NE(refusal(document), "loaded") << key;
        document.root["materials"][0][key] = 3;
        EXPECT_NE(refusal(document), "loaded") << key;
    }
    Document document = bumpy();
    document.setFloats("TANGENT", "VEC2", {1, 0, 0, 1, 0, 0});
    EXPECT_NE(refusal(document), "loaded");
}

} // namespace
} // namespace cdr::scene::test
