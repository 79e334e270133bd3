#include "../../support/refusal.h"
#include "fixture.h"

#include <cdr/scene/gltf/open_gltf.h>

#include <cmath>
#include <numbers>
#include <utility>

namespace cdr::scene::test {
namespace {

using GltfLights = GltfFolder;

constexpr const char* kLights = "KHR_lights_punctual";

/// The square of radius sqrt(5) about (1, 2, 0), a point light and a directional one that shines down.
Document lit() {
    Document document = square();
    document.root["extensions"][kLights]["lights"] = {
        {{"type", "point"}, {"name", "bulb"}, {"intensity", 40.0}, {"color", {1.0, 0.5, 0.25}}},
        {{"type", "directional"}, {"intensity", 3.0}}};
    document.root["nodes"].push_back(
        {{"translation", {1, 2, 9}}, {"extensions", {{kLights, {{"light", 0}}}}}});
    const double half = std::sqrt(0.5); // -z turned to -y
    document.root["nodes"].push_back(
        {{"rotation", {-half, 0, 0, half}}, {"extensions", {{kLights, {{"light", 1}}}}}});
    document.root["scenes"][0]["nodes"] = {0, 1, 2};
    document.root["extensionsUsed"] = {kLights};
    return document;
}

json& lightOf(Document& document, std::size_t light) {
    return document.root["extensions"][kLights]["lights"][light];
}

GltfChoice byFile() {
    GltfChoice choice;
    choice.light = ModelLight::file;
    return choice;
}

/// What reaches a point, as shading has it.
glm::dvec3 arriving(const PointLight& light, const glm::dvec3& at) {
    const double ratio = glm::distance(light.position, at) / light.halfDistance;
    return glm::dvec3(light.color) / (1.0 + ratio * ratio);
}

TEST_F(GltfLights, AreShownWhenAskedFor) {
    const std::filesystem::path path = write("a.glb", lit().glb());
    const OpenedScene without = openGltf(path);
    EXPECT_TRUE(anySays(without.notes, "its 2 lights, which render --light file shows"));
    const OpenedScene opened = openGltf(path, byFile());
    EXPECT_TRUE(opened.notes.empty());
    const std::vector<PointLight>& lights = opened.setup.scene.lights;
    ASSERT_EQ(lights.size(), 2u);
    for (const double distance : {1.0, 9.0, 500.0}) {
        const glm::dvec3 there = arriving(lights[0], {1.0, 2.0, 9.0 - distance});
        const glm::dvec3 wanted =
            glm::dvec3(1.0, 0.5, 0.25) * 40.0 / std::numbers::pi / (distance * distance);
        EXPECT_NEAR(there.x, wanted.x, 0.01 * wanted.x) << distance;
        EXPECT_NEAR(there.z, wanted.z, 0.01 * wanted.z) << distance;
    }
    for (const glm::dvec3& at : {glm::dvec3(0.0), glm::dvec3(2.0, 4.0, 0.0)}) {
        EXPECT_NEAR(arriving(lights[1], at).y, 3.0 / std::numbers::pi, 1e-3);
        const glm::dvec3 from = glm::normalize(lights[1].position - at);
        EXPECT_NEAR(from.y, 1.0, 1e-5);
    }
}

TEST_F(GltfLights, SpotsHaveAConeAndARange) {
    Document document = lit();
    lightOf(document, 0)["type"] = "spot";
    lightOf(document, 0)["range"] = 12.5;
    lightOf(document, 0)["spot"] = {{"innerConeAngle", 0.25}, {"outerConeAngle", 0.5}};
    document.root["nodes"][1]["rotation"] = {-std::sqrt(0.5), 0, 0, std::sqrt(0.5)};
    document.root["nodes"][1]["scale"] = {3, 3, 3};
    const OpenedScene opened = openGltf(write("a.glb", document.glb()), byFile());
    EXPECT_TRUE(opened.notes.empty());
    const PointLight& spot = opened.setup.scene.lights[0];
    ASSERT_TRUE(spot.cone);
    EXPECT_EQ(spot.cone->inner, 0.25);
    EXPECT_EQ(spot.cone->outer, 0.5);
    EXPECT_NEAR(glm::distance(spot.cone->direction, glm::dvec3(0, -1, 0)), 0.0, 1e-12);
    EXPECT_EQ(spot.range, 12.5);
    EXPECT_EQ(spot.position, glm::dvec3(1, 2, 9));
    EXPECT_FALSE(scene::isShaped(opened.setup.scene.lights[1]));
    ASSERT_EQ(opened.lights.size(), 2u);
    EXPECT_EQ(opened.lights[0].name, "bulb");
    EXPECT_EQ(opened.lights[0].type, LightType::spot);
    EXPECT_EQ(opened.lights[1].type, LightType::directional);
    lightOf(document, 0).erase("spot");
    EXPECT_EQ(load(document).lights[0].cone->inner, 0.0);
    EXPECT_EQ(load(document).lights[0].cone->outer, LightCone{}.outer);
    lightOf(document, 0)["spot"] = {{"innerConeAngle", 1.5708}, {"outerConeAngle", 1.57081}};
    const LightCone widest = *load(document).lights[0].cone; // as few digits have half pi
    EXPECT_LT(widest.inner, widest.outer);
    EXPECT_LE(widest.outer, 0.5 * std::numbers::pi);
}

/// As programs write a spot without a soft edge.
TEST_F(GltfLights, ASpotMayHaveASharpEdge) {
    Document document = lit();
    lightOf(document, 0)["type"] = "spot";
    for (const double angle : {0.5, 1.5708}) {
        lightOf(document, 0)["spot"] = {{"innerConeAngle", angle}, {"outerConeAngle", angle}};
        const LightCone cone = *load(document).lights[0].cone;
        EXPECT_LT(cone.inner, cone.outer);
        EXPECT_NEAR(cone.inner, angle, 1e-5);
        EXPECT_NEAR(cone.outer, angle, 1e-5);
    }
    lightOf(document, 0)["spot"] = {{"innerConeAngle", 0}, {"outerConeAngle", 0}};
    expectSays(refusal(document), "its cone is from 0 to 0");
}

/// Some programs have such lamps, which take light away.
TEST_F(GltfLights, OneOfNegativeIntensityIsNoted) {
    Document document = lit();
    lightOf(document, 0)["intensity"] = -1;
    const GltfImport import = load(document);
    ASSERT_EQ(import.lights.size(), 1u);
    EXPECT_TRUE(import.lights[0].direction);
    EXPECT_EQ(import.ignored,
              (std::vector<std::string>{"light 0: a light of negative intensity is not used"}));
}

TEST_F(GltfLights, WhatIsNotUsedIsNoted) {
    Document document = lit();
    lightOf(document, 1)["range"] = 5.0;
    const GltfImport import = load(document);
    EXPECT_EQ(import.lights.size(), 2u);
    EXPECT_TRUE(anySays(import.ignored, "the range of a directional light means nothing"));
    document = lit();
    document.root["nodes"][2]["scale"] = {1, 1, 0};
    EXPECT_TRUE(
        anySays(load(document).ignored, "a light is not used, because its transform is not invertible"));
}

TEST_F(GltfLights, UnsoundOnesAreRefused) {
    const auto with = [&](const char* key, const json& value) {
        Document document = lit();
        lightOf(document, 0)[key] = value;
        return refusal(document);
    };
    expectSays(with("type", "laser"), "type 'laser' does not exist");
    expectSays(with("intensity", "x"), "'intensity' is not a number");
    expectSays(with("color", {1, -1, 1}), "its colour must be 0 or more");
    EXPECT_NE(with("color", {1, 1}), "loaded");
    expectSays(with("range", 0), "its range is 0");
    expectSays(with("range", "far"), "'range' is not a number");
    const auto withCone = [&](const json& spot) {
        Document document = lit();
        lightOf(document, 0)["type"] = "spot";
        lightOf(document, 0)["spot"] = spot;
        return refusal(document);
    };
    for (const auto& [inner, outer] : {std::pair{-0.1, 0.5}, std::pair{0.6, 0.5}, std::pair{0.0, 1.6}}) {
        expectSays(withCone({{"innerConeAngle", inner}, {"outerConeAngle", outer}}), "its cone is from");
    }
    expectSays(withCone({{"innerConeAngle", "x"}}), "'innerConeAngle' is not a number");
    expectSays(withCone(7), "'spot' is not an object");
    Document document = lit();
    document.root["nodes"][1]["extensions"][kLights]["light"] = 7;
    expectSays(refusal(document), "light 7 does not exist, the file has 2");
    document.root.erase("extensions");
    expectSays(refusal(document), "the file has no KHR_lights_punctual");
}

TEST_F(GltfLights, AFileWithoutIsRefused) {
    const auto refusalOf = [&](const std::string& name, const Document& document) {
        const std::filesystem::path path = write(name, document.glb());
        const std::string refusal = cdr::test::inputErrorOf([&] { openGltf(path, byFile()); });
        EXPECT_TRUE(refusal.starts_with(path.string() + ": ")) << refusal;
        return refusal;
    };
    expectSays(refusalOf("a.glb", square()), "it has no lights of its own");
    Document document = lit();
    lightOf(document, 0)["intensity"] = 1e300;
    expectSays(refusalOf("b.glb", document), "is too strong for a scene of radius");
}

TEST_F(GltfLights, ManyAreBounded) {
    Document document = lit();
    for (int i = 0; i < 300; ++i) {
        document.root["scenes"][0]["nodes"].push_back(document.root["nodes"].size());
        document.root["nodes"].push_back({{"extensions", {{kLights, {{"light", 0}}}}}});
    }
    const GltfImport import = load(document);
    EXPECT_EQ(import.lights.size(), 256u);
    EXPECT_TRUE(anySays(import.ignored, "lights beyond the first 256 are not used"));
}

} // namespace
} // namespace cdr::scene::test
