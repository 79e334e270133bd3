#include "fixture.h"

#include <cmath>

namespace cdr::scene::test {
namespace {

using Gltf = GltfFolder;

TEST_F(Gltf, ObjectsFollowTheNodeArray) {
    Document document = square();
    document.root["meshes"].push_back(document.root["meshes"][0]);
    document.root["meshes"][1]["name"] = "mesh one";
    document.root["nodes"] = {{{"mesh", 1}},
                              {{"children", {3, 0}}},
                              {{"mesh", 0}, {"name", "outside"}},
                              {{"mesh", 0}, {"name", "three"}}};
    document.root["scenes"] = {{{"nodes", {1}}}};
    const Scene scene = load(document).scene;
    EXPECT_EQ(scene.objectNames, (std::vector<std::string>{"mesh one", "three"}));
    EXPECT_EQ(scene.instances.object, (std::vector<std::uint32_t>{0, 1}));
    // However many nodes take a mesh's name, it takes little memory.
    document.root["meshes"][1]["name"] = std::string(100'000, 'm');
    EXPECT_LT(load(document).scene.objectNames[0].size(), 200u);
    document.root["meshes"][1].erase("name");
    EXPECT_EQ(load(document).scene.objectNames[0], "node 0");
}

TEST_F(Gltf, WhatIsNotVisibleIsNotDrawn) {
    constexpr const char* kVisibility = "KHR_node_visibility";
    constexpr const char* kLights = "KHR_lights_punctual";
    Document document = square();
    document.root["extensions"][kLights]["lights"] = {{{"type", "point"}}};
    document.root["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"znear", 1.0}}}}};
    document.root["nodes"] = {{{"mesh", 0}, {"name", "seen"}},
                              {{"children", {2}}, {"name", "group"}},
                              {{"mesh", 0}, {"name", "hidden"}, {"children", {3}}, {"camera", 0}},
                              {{"extensions", {{kLights, {{"light", 0}}}}}}};
    document.root["scenes"] = {{{"nodes", {0, 1}}}};
    document.root["extensionsUsed"] = {kLights, kVisibility};
    document.root["extensionsRequired"] = {kVisibility};
    giveMove(document, 2, {0, 2}, {0, 0, 0, 10, 0, 0});
    const auto namesWith = [&](const json& group, const json& hidden) {
        document.root["nodes"][1]["extensions"][kVisibility] = group;
        document.root["nodes"][2]["extensions"][kVisibility] = hidden;
        const GltfImport import = load(document);
        EXPECT_TRUE(import.ignored.empty()) << import.ignored.front();
        EXPECT_EQ(import.cameras.size(), 1u);
        EXPECT_EQ(import.lights.size(), import.scene.objectNames.size() - 1);
        EXPECT_EQ(import.animation->carried.size(), import.scene.objectNames.size() - 1);
        return import.scene.objectNames;
    };
    const std::vector<std::string> all{"seen", "hidden"};
    const std::vector<std::string> some{"seen"};
    EXPECT_EQ(namesWith({{"visible", true}}, json::object()), all);
    EXPECT_EQ(namesWith({{"visible", false}}, json::object()), some);
    EXPECT_EQ(namesWith({{"visible", false}}, {{"visible", true}}), some);
    EXPECT_EQ(namesWith(json::object(), {{"visible", false}}), some);
    expectRefused(document, "/nodes/1/extensions/KHR_node_visibility/visible", 0,
                  "node 1: 'visible' is neither true nor false");
}

/// So what is wrong between them can be seen.
TEST_F(Gltf, EachPrimitiveOfANodeIsAnObject) {
    Document document = square();
    json primitive = document.primitive();
    document.root["materials"] = {{{"name", "glass"}}, {{"name", "brick"}}, {{"name", ""}}};
    json& primitives = document.root["meshes"][0]["primitives"];
    primitives.clear();
    for (const int material : {0, 1, 1, 2}) {
        primitive["material"] = material;
        primitives.push_back(primitive);
    }
    document.root["nodes"] = {{{"mesh", 0}, {"name", "house"}}, {{"mesh", 0}, {"name", "barn"}}};
    document.root["scenes"] = {{{"nodes", {0, 1}}}};
    const Scene scene = load(document).scene;
    EXPECT_EQ(scene.objectNames, (std::vector<std::string>{
                                     "house / glass", "house / brick 1", "house / brick 2", "house / part 3",
                                     "barn / glass", "barn / brick 1", "barn / brick 2", "barn / part 3"}));
    EXPECT_EQ(scene.instances.object, (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5, 6, 7}));
    EXPECT_EQ(scene.meshes.size(), 4u);
    // Names of parts take little memory, however long their nodes' are.
    document.root["nodes"][0]["name"] = std::string(100'000, 'n');
    document.root["materials"][0]["name"] = std::string(100'000, 'm');
    EXPECT_LT(load(document).scene.objectNames[0].size(), 300u);
}

TEST_F(Gltf, TheSceneIsTheDefaultElseTheFirstElseEverything) {
    Document document = square();
    document.root["nodes"] = {
        {{"mesh", 0}, {"name", "a"}}, {{"mesh", 0}, {"name", "b"}}, {{"mesh", 0}, {"name", "c"}}};
    document.root["scenes"] = {{{"nodes", {0}}}, {{"nodes", {1, 2}}}};
    document.root["scene"] = 1;
    EXPECT_EQ(load(document).scene.objectNames, (std::vector<std::string>{"b", "c"}));
    document.root.erase("scene");
    EXPECT_EQ(load(document).scene.objectNames, (std::vector<std::string>{"a"}));
    document.root.erase("scenes");
    EXPECT_EQ(load(document).scene.objectNames, (std::vector<std::string>{"a", "b", "c"}));
    document.root["scene"] = 0;
    expectSays(refusal(document), "scene 0 does not exist");
}

TEST_F(Gltf, MeshOfSeveralNodesIsImportedOnce) {
    Document document = square();
    document.root["nodes"] = {{{"mesh", 0}}, {{"mesh", 0}, {"translation", {10, 0, 0}}}};
    document.root["scenes"] = {{{"nodes", {0, 1}}}};
    const Scene scene = load(document).scene;
    EXPECT_EQ(scene.meshes.size(), 1u);
    ASSERT_EQ(scene.instances.size(), 2u);
    EXPECT_EQ(scene.instances.position(1), glm::dvec3(11, 2, 0));
}

TEST_F(Gltf, TransformsComposeInFloat64) {
    Document document = square();
    const double half = std::sqrt(0.5);
    document.root["nodes"] = {
        {{"children", {1}}, {"translation", {1e9, 0.25, 0}}},
        {{"children", {2}}, {"rotation", {0, 0, half, half}}, {"scale", {2, 2, 2}}},
        {{"mesh", 0}, {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.125, 0, 0, 1}}}};
    const Scene scene = load(document).scene;
    // The centre (1, 2, 0) moves by 0.125 along x, doubles, and turns a quarter about z.
    const glm::dvec3 position = scene.instances.position(0);
    EXPECT_NEAR(position.x, 1e9 - 4.0, 1e-6);
    EXPECT_NEAR(position.y, 2.5, 1e-9);
    const glm::mat3 basis = scene.instances.basis[0];
    EXPECT_NEAR(basis[0].y, 2.0f, 1e-6f);
    EXPECT_NEAR(basis[1].x, -2.0f, 1e-6f);
    EXPECT_NEAR(scene.instances.radius[0], 2.0f * std::sqrt(5.0f), 1e-4f);
}

TEST_F(Gltf, RoundingsInTheLastRowOfAMatrixCountForNothing) {
    Document document = square();
    document.root["nodes"][0]["matrix"] = {1, 0, 0, 1e-7, 0, 1, 0, 0, 0, 0, 1, -1e-7, 7, 0, 0, 0.99999994};
    const Scene scene = load(document).scene;
    ASSERT_EQ(scene.instances.size(), 1u);
    EXPECT_EQ(scene.instances.position(0), glm::dvec3(8, 2, 0));
    document.root["nodes"][0]["matrix"][15] = 1.001;
    expectSays(refusal(document), "is not affine");
}

TEST_F(Gltf, RotationsAreMadeUnitLength) {
    Document document = square();
    document.root["nodes"][0]["rotation"] = {0, 0, 3, 3};
    EXPECT_NEAR(load(document).scene.instances.basis[0][0].y, 1.0f, 1e-6f);
}

/// Instances may mirror (mesh.h), so a mirroring node needs no mesh of its own.
TEST_F(Gltf, MirroringNodesShareTheirMesh) {
    Document document = square();
    document.root["nodes"] = {{{"mesh", 0}}, {{"mesh", 0}, {"scale", {-1, 1, 1}}}};
    document.root["scenes"] = {{{"nodes", {0, 1}}}};
    const Scene scene = load(document).scene;
    EXPECT_EQ(scene.meshes.size(), 1u);
    ASSERT_EQ(scene.instances.size(), 2u);
    EXPECT_GT(glm::determinant(scene.instances.basis[0]), 0.0f);
    EXPECT_LT(glm::determinant(scene.instances.basis[1]), 0.0f);
}

TEST_F(Gltf, FlatteningTransformsAreNotDrawnButKeepTheirObject) {
    Document document = square();
    for (const json& scale : {json{0, 1, 1}, json{0, 0, 0}, json{1e-200, 1, 1}, json{1e-60, 1e-60, 1e-60}}) {
        document.root["nodes"] = {{{"mesh", 0}, {"scale", scale}}, {{"mesh", 0}}};
        document.root["scenes"] = {{{"nodes", {0, 1}}}};
        const GltfImport result = load(document);
        EXPECT_EQ(result.scene.instances.object, (std::vector<std::uint32_t>{1})) << scale;
        EXPECT_EQ(result.scene.objectNames.size(), 2u);
        EXPECT_TRUE(anySays(result.ignored, "node 0: not drawn, because its transform is not invertible"));
    }
    // Small and very unequal scales are not flat.
    for (const json& scale : {json{1e-9, 1e-9, 1e-9}, json{1e-6, 1, 1e6}}) {
        document.root["nodes"][0]["scale"] = scale;
        EXPECT_EQ(load(document).scene.instances.size(), 2u) << scale;
    }
    // A shear that leaves a plane.
    document.root["nodes"][0] = {{"mesh", 0}, {"matrix", {1, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}};
    EXPECT_EQ(load(document).scene.instances.size(), 1u);
}

TEST_F(Gltf, UnsoundGraphsAreRefused) {
    const auto withNodes = [&](const json& nodes, const json& roots) {
        Document document = square();
        document.root["nodes"] = nodes;
        document.root["scenes"] = {{{"nodes", roots}}};
        return refusal(document);
    };
    expectSays(withNodes({{{"children", {1}}}, {{"children", {0}}}}, json::array()), "is its own ancestor");
    expectSays(withNodes({{{"children", {0}}}}, json::array()), "is its own ancestor");
    expectSays(withNodes({{{"children", {1}}}, {{"children", {0}}}}, {0}), "a child of another node");
    expectSays(withNodes({{{"children", {2}}}, {{"children", {2}}}, {{"mesh", 0}}}, {0, 1}), "child of both");
    expectSays(withNodes({{{"children", {1, 1}}}, {{"mesh", 0}}}, {0}), "child of both");
    expectSays(withNodes({{{"mesh", 0}}}, {0, 0}), "listed twice");
    expectSays(withNodes({{{"mesh", 0}}}, {1}), "node 1 does not exist");
    expectSays(withNodes({{{"children", {7}}}}, {0}), "node 7 does not exist");
    expectSays(withNodes({{{"mesh", 3}}}, {0}), "mesh 3 does not exist");
    expectSays(withNodes({{{"mesh", 0}, {"children", 1}}}, {0}), "'children' is not an array");
}

TEST_F(Gltf, BothParentsOfANodeAreNamed) {
    Document document = square();
    document.root["nodes"] = {
        {{"children", {2}}, {"name", "left"}}, {{"children", {2}}}, {{"mesh", 0}, {"name", "wheel"}}};
    EXPECT_EQ(refusal(document),
              "node 2 'wheel' is a child of both node 0 'left' and node 1, and a node has one parent");
}

TEST_F(Gltf, EmptyScenesSaySo) {
    const auto saysSo = [](const GltfImport& import) {
        return import.ignored == std::vector<std::string>{"the scene: nothing of it is drawn"};
    };
    Document document = square();
    document.root["scenes"].push_back({{"nodes", json::array()}});
    const std::filesystem::path path = write("a.glb", document.glb());
    EXPECT_TRUE(saysSo(loadGltf(path, {}, 1)));
    EXPECT_FALSE(saysSo(loadGltf(path, {}, 0)));
    EXPECT_TRUE(saysSo(loadGltf(write("a.gltf", std::string(R"({"asset": {"version": "2.0"}})")))));
}

TEST_F(Gltf, UnsoundTransformsAreRefused) {
    const auto withNode = [&](const char* key, const json& value) {
        Document document = square();
        document.root["nodes"][0][key] = value;
        return refusal(document);
    };
    expectSays(withNode("translation", {1e308, 0, 0}), "its size or place is over what can be drawn");
    expectSays(withNode("scale", {1e38, 1e38, 1e38}), "its size or place is over what can be drawn");
    expectSays(withNode("scale", {1e18, 1e18, 1e18}), "its size or place is over what can be drawn");
    EXPECT_EQ(withNode("scale", {5e16, 5e16, 5e16}), "loaded");
    expectSays(withNode("rotation", {0, 0, 0, 0}), "has no direction");
    expectSays(withNode("translation", {1, 2}), "'translation' is not 3 numbers");
    expectSays(withNode("scale", "big"), "'scale' is not 3 numbers");
    expectSays(withNode("matrix", json::array()), "'matrix' is not 16 numbers");
    expectSays(withNode("matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 2}), "is not affine");
    expectSays(withNode("mesh", -2), "'mesh' is -2");
    expectSays(withNode("mesh", 4294967296), "'mesh' is 4294967296");
    expectSays(withNode("mesh", 0.5), "'mesh' is 0.5");

    Document document = square();
    document.root["nodes"] = {{{"children", {1}}, {"scale", {1e200, 1, 1}}},
                              {{"mesh", 0}, {"scale", {1e200, 1, 1}}}};
    expectSays(refusal(document), "its transform is not finite");
}

TEST_F(Gltf, DepthIsLimited) {
    Document document = square();
    GltfLimits limits;
    limits.maxNodeDepth = 20;
    document.root["nodes"] = json::array();
    for (int i = 0; i < 20; ++i) {
        document.root["nodes"].push_back({{"children", {i + 1}}});
    }
    document.root["nodes"].push_back({{"mesh", 0}});
    expectSays(refusal(document, limits), "nested over the limit of 20");
    limits.maxNodeDepth = 21;
    EXPECT_EQ(refusal(document, limits), "loaded");
}

TEST_F(Gltf, CountsAreLimited) {
    Document document = square();
    GltfLimits limits;
    limits.maxNodes = 2;
    document.root["nodes"] = {{{"mesh", 0}}, {{"mesh", 0}}, {{"mesh", 0}}};
    document.root["scenes"] = {{{"nodes", {0, 1, 2}}}};
    expectSays(refusal(document, limits), "3 nodes are over the limit of 2");
    limits.maxNodes = 3;
    limits.maxTriangles = 5;
    expectSays(refusal(document, limits), "over the limit of 5");
    limits.maxTriangles = 6;
    EXPECT_EQ(refusal(document, limits), "loaded");
    limits.maxFileBytes = 100;
    expectSays(refusal(document, limits), "over the limit of 100");
}

TEST_F(Gltf, CountsThatNoBytesBackAreRefusedBeforeAllocation) {
    Document document = triangle();
    document.root["accessors"][0]["count"] = 2147483647;
    expectSays(refusal(document), "do not fit its buffer view");
    document.root["accessors"][0].erase("bufferView");
    expectSays(refusal(document), "over the limit");
    document.root["accessors"][0]["count"] = 999; // all zeros
    EXPECT_TRUE(anySays(load(document).ignored, "a primitive has no extent"));

    document = square();
    document.root["accessors"][0].erase("bufferView");
    document.root["accessors"][0]["count"] = 2147483647;
    document.root["accessors"][0]["sparse"] = {
        {"count", 1},
        {"indices",
         {{"bufferView", document.addView(std::vector<std::uint8_t>{1})}, {"componentType", kUByte}}},
        {"values", {{"bufferView", document.addView(std::vector<float>{8, 0, 0})}}}};
    expectSays(refusal(document), "bytes of memory, over the limit of 4294967296");
}

} // namespace
} // namespace cdr::scene::test
