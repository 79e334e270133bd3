#include "fixture.h"

namespace cdr::scene::test {
namespace {

using GltfMemory = GltfFolder;

/// Positions without bytes, except for one, and no indices.
Document hollow(std::uint32_t count) {
    Document document = triangle();
    json& positions = document.root["accessors"][0];
    positions.erase("bufferView");
    positions["count"] = count;
    positions["sparse"] = {
        {"count", 1},
        {"indices",
         {{"bufferView", document.addView(std::vector<std::uint8_t>{2})}, {"componentType", kUByte}}},
        {"values", {{"bufferView", document.addView(std::vector<float>{8, 4, 2})}}}};
    return document;
}

TEST_F(GltfMemory, CountsWithoutBytesAreRefusedBeforeAllocation) {
    // 632 bytes that once took 52 s and 13 GB.
    EXPECT_EQ(refusal(hollow(149'999'997)), "mesh 0 '' primitive 0: the import would take 16199999676 bytes "
                                            "of memory, over the limit of 4294967296");
    EXPECT_EQ(refusal(hollow(3)), "loaded");
}

TEST_F(GltfMemory, IndicesWithoutBytesAreRefusedBeforeAllocation) {
    Document document = square();
    json& indices = document.root["accessors"][2];
    indices.erase("bufferView");
    indices["count"] = 149'999'997;
    document.primitive()["attributes"].erase("NORMAL");
    expectSays(refusal(document), "mesh 0 '' primitive 0: the import would take ");
}

TEST_F(GltfMemory, TheLimitIsExact) {
    // 4 vertices and 6 indices: 168 bytes that stay and 304 that pass.
    GltfLimits limits;
    limits.maxBytes = 472;
    EXPECT_EQ(refusal(square(), limits), "loaded");
    limits.maxBytes = 471;
    EXPECT_EQ(refusal(square(), limits),
              "mesh 0 '' primitive 0: the import would take 472 bytes of memory, over the limit of 471");
}

TEST_F(GltfMemory, PrimitivesAddUpButNotWhatPasses) {
    Document document = square();
    document.root["meshes"][0]["primitives"].push_back(document.primitive());
    GltfLimits limits;
    limits.maxBytes = 472 + 168 - 1;
    expectSays(refusal(document, limits), "mesh 0 '' primitive 1: the import would take 640 bytes");
    limits.maxBytes =
        2 * (168 + 228 + 332); // with their instances and names, which are more than what passes
    EXPECT_EQ(refusal(document, limits), "loaded");
}

TEST_F(GltfMemory, InstancesAreForetold) {
    Document document = square();
    document.root["scenes"][0]["nodes"].clear();
    for (int i = 0; i < 100; ++i) {
        document.root["nodes"][static_cast<std::size_t>(i)] = {{"mesh", 0}};
        document.root["scenes"][0]["nodes"].push_back(i);
    }
    GltfLimits limits;
    limits.maxBytes = 10'000;
    EXPECT_EQ(refusal(document, limits), "100 instances: the import would take 22968 bytes of memory, over "
                                         "the limit of 10000");
}

TEST_F(GltfMemory, CopiesOfAnExtensionAreForetold) {
    Document document = square();
    document.root["accessors"].push_back(
        {{"componentType", kFloat}, {"count", 2'000'000'000}, {"type", "VEC3"}});
    document.root["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"] = {
        {"attributes", {{"TRANSLATION", document.root["accessors"].size() - 1}}}};
    document.root["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
    expectSays(refusal(document), "copies of a mesh: the import would take");
}

/// A skin of many joints that many nodes share; each has a copy of the joints to pose its mesh by.
TEST_F(GltfMemory, JointsOfPosesAreForetold) {
    constexpr int kNodes = 40;
    Document document = triangle();
    document.primitive()["attributes"]["JOINTS_0"] =
        document.addAccessor(std::vector<std::uint8_t>(12, 0), "VEC4", kUByte);
    document.setFloats("WEIGHTS_0", "VEC4", {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
    document.root["skins"] = {{{"joints", std::vector<int>(1000, kNodes)}}};
    document.root["nodes"] = json::array();
    document.root["scenes"][0]["nodes"] = {kNodes};
    for (int i = 0; i < kNodes; ++i) {
        document.root["nodes"].push_back({{"mesh", 0}, {"skin", 0}});
        document.root["scenes"][0]["nodes"].push_back(i);
    }
    document.root["nodes"].push_back(json::object());
    EXPECT_EQ(refusal(document), "loaded");
    GltfLimits limits;
    limits.maxBytes = 1'000'000;
    expectSays(refusal(document, limits), ": the import would take ");
}

/// A file names a joint in two bytes, of which a skin keeps 136.
TEST_F(GltfMemory, JointsOfSkinsAreForetold) {
    Document document = triangle();
    document.root["skins"] = {{{"joints", std::vector<int>(10'000, 0)}}};
    document.root["nodes"][0]["skin"] = 0;
    EXPECT_EQ(refusal(document), "loaded");
    GltfLimits limits;
    limits.maxBytes = 1'000'000;
    expectSays(refusal(document, limits), "skin 0 '': the import would take ");
}

/// Each primitive of a mesh that deforms is posed by all weights of its node.
TEST_F(GltfMemory, WeightsOfPosesAreForetold) {
    Document document = triangle();
    const json target = {{"POSITION", 0}};
    json& primitives = document.root["meshes"][0]["primitives"];
    for (int i = 0; i < 60; ++i) {
        json primitive = primitives[0];
        primitive["targets"] = json::array({target});
        primitives.push_back(primitive);
    }
    primitives[0]["targets"] = std::vector<json>(1000, target);
    document.root["meshes"][0]["weights"] = std::vector<int>(1000, 0);
    document.root["meshes"][0]["weights"][0] = 1;
    EXPECT_EQ(refusal(document), "loaded");
    GltfLimits limits;
    limits.maxBytes = 500'000; // the weights take 488'000, and all else less
    expectSays(refusal(document, limits), "node 0: the import would take ");
}

/// A square of 8 by 8 cells, drawn 200 times.
Document copiedCells() {
    constexpr std::uint16_t kCells = 8;
    Document document = triangle();
    std::vector<float> positions;
    std::vector<std::uint16_t> indices;
    for (std::uint16_t j = 0; j <= kCells; ++j) {
        for (std::uint16_t i = 0; i <= kCells; ++i) {
            positions.insert(positions.end(), {static_cast<float>(i), static_cast<float>(j), 0.0f});
            if (i < kCells && j < kCells) {
                const int a = j * (kCells + 1) + i;
                for (const int corner : {a, a + 1, a + kCells + 2, a, a + kCells + 2, a + kCells + 1}) {
                    indices.push_back(static_cast<std::uint16_t>(corner));
                }
            }
        }
    }
    document.setFloats("POSITION", "VEC3", positions);
    document.primitive()["indices"] = document.addAccessor(indices, "SCALAR", kUShort);
    document.root["accessors"].push_back({{"componentType", kFloat}, {"count", 200}, {"type", "VEC3"}});
    document.root["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"] = {
        {"attributes", {{"TRANSLATION", document.root["accessors"].size() - 1}}}};
    return document;
}

TEST_F(GltfMemory, PiecesAreForetoldBeforeTheyArePlaced) {
    Document document = copiedCells();
    GltfLimits limits;
    limits.maxBytes = 400'000;
    EXPECT_EQ(refusal(document, limits), "loaded") << "of one piece";
    limits.pieceRadius = 1.5;
    expectSays(refusal(document, limits), "pieces of a mesh: the import would take ");
    limits.maxBytes = GltfLimits().maxBytes;
    const std::size_t instances = load(document, limits).scene.instances.size();
    ASSERT_GE(instances, 200u * 8u);
    limits.maxBytes = 400'000 + 228 * instances;
    EXPECT_EQ(refusal(document, limits), "loaded");
    giveMove(document, 0, {0, 1}, {0, 0, 0, 1, 2, 0});
    expectSays(refusal(document, limits), "pieces of a mesh: the import would take ");
}

TEST_F(GltfMemory, SparseIndicesNeedNoBufferView) {
    Document document = square();
    json& indices = document.root["accessors"][2];
    indices.erase("bufferView");
    // 0 1 2 0 2 3, of which the zeros are not written down.
    indices["sparse"] = {
        {"count", 4},
        {"indices",
         {{"bufferView", document.addView(std::vector<std::uint8_t>{1, 2, 4, 5})},
          {"componentType", kUByte}}},
        {"values", {{"bufferView", document.addView(std::vector<std::uint16_t>{1, 2, 2, 3})}}}};
    EXPECT_EQ(load(document).scene.meshes.at(0).indices, (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}));
    document.root["accessors"][2].erase("sparse");
    EXPECT_TRUE(anySays(load(document).ignored, "a primitive has no extent"));
}

} // namespace
} // namespace cdr::scene::test
