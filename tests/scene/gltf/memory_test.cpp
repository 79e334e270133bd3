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
