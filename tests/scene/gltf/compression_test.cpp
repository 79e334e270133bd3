#include "draco_fixture.h"

namespace cdr::scene::test {
namespace {

using GltfCompression = GltfFolder;

constexpr const char* kMeshopt[] = {"EXT_meshopt_compression", "KHR_meshopt_compression"};

/// A square with uvs and colours that Draco holds too, without being required.
Document withDraco() {
    Document document = square();
    document.setFloats("TEXCOORD_0", "VEC2", {0, 0, 1, 0, 1, 1, 0, 1});
    document.setFloats("COLOR_0", "VEC3", {1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1});
    json& primitive = document.primitive();
    const int compressed = document.addView(std::vector<std::uint8_t>{'D', 'R', 'A', 'C', 'O', 2, 2, 1});
    json attributes = primitive["attributes"];
    primitive["extensions"][kDraco] = {{"bufferView", compressed}, {"attributes", std::move(attributes)}};
    document.root["extensionsUsed"] = {kDraco};
    return document;
}

/// The square with all its views compressed into another buffer by an extension that is not required.
Document withMeshopt(const char* extension) {
    Document document = square();
    for (json& view : document.root["bufferViews"]) {
        // The same bytes as the view's, but of another buffer.
        view["extensions"][extension] = {{"buffer", 1},          {"byteOffset", view["byteOffset"]},
                                         {"byteLength", 8},      {"byteStride", 12},
                                         {"mode", "ATTRIBUTES"}, {"count", 4}};
    }
    document.root["buffers"] = {
        {{"byteLength", document.bin.size()}},
        {{"byteLength", 8}, {"uri", "data:application/octet-stream;base64,oAAAAAAAAAA="}}};
    document.root["extensionsUsed"] = {extension};
    return document;
}

void expectIsTheSquare(const GltfImport& import) {
    ASSERT_EQ(import.scene.meshes.size(), 1u);
    const Mesh& mesh = import.scene.meshes.front();
    ASSERT_EQ(mesh.vertices.size(), 4u);
    EXPECT_EQ(mesh.indices, (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}));
    EXPECT_EQ(mesh.vertices[2].position - mesh.vertices[0].position, glm::vec3(2, 4, 0));
    EXPECT_EQ(mesh.vertices[3].normal, glm::vec3(0, 0, 1));
}

TEST_F(GltfCompression, OfDracoTheUncompressedCopyIsDrawn) {
    const GltfImport import = load(withDraco());
    expectIsTheSquare(import);
    EXPECT_EQ(import.scene.meshes.front().vertices[2].uv, glm::vec2(1, 1));
    EXPECT_TRUE(import.ignored.empty());
}

TEST_F(GltfCompression, WhatOnlyDracoHoldsIsDecoded) {
    const Document sound = withDraco();
    const auto without = [&sound](int accessor) {
        Document document = sound;
        document.root["accessors"][static_cast<std::size_t>(accessor)].erase("bufferView");
        return document;
    };
    const json& primitive = sound.root["meshes"][0]["primitives"][0];
    for (const auto& [name, accessor] : primitive["attributes"].items()) {
        expectSays(refusal(without(accessor)),
                   "KHR_draco_mesh_compression holds no Draco stream"); // it is cut off
    }
    Document document = without(primitive["indices"]);
    EXPECT_EQ(refusal(document), "mesh 0 '' primitive 0: KHR_draco_mesh_compression holds no Draco stream");
    document.root.erase("extensionsUsed"); // which says nothing about what there is
    expectSays(refusal(document), "holds no Draco stream");

    // Without the extension they are zeros, as glTF has it.
    document = without(primitive["attributes"]["COLOR_0"]);
    document.primitive().erase("extensions");
    EXPECT_EQ(load(document).scene.meshes.front().vertices[3].color, (glm::u8vec4(0, 0, 0, 255)));
}

TEST_F(GltfCompression, UnsoundPrimitivesOfDracoAreRefusedAsOthersAre) {
    expectRefused(withDraco(), "/meshes/0/primitives/0/indices", json::object(), "'indices' is {}");
    Document document = withDraco();
    document.primitive()["indices"] = 99;
    EXPECT_NE(refusal(document), "loaded");
    document = withDraco();
    for (const json& unsound : {json::array({"x"}), json("x"), json(5), json(nullptr)}) {
        document.primitive()["attributes"] = unsound;
        EXPECT_NE(refusal(document), "loaded") << unsound;
    }
}

TEST_F(GltfCompression, OfMeshoptTheUncompressedCopyIsDrawn) {
    for (const std::string extension : kMeshopt) {
        const GltfImport import = load(withMeshopt(extension.c_str()));
        expectIsTheSquare(import);
        EXPECT_EQ(import.ignored, extension == kMeshopt[0]
                                      ? std::vector<std::string>{}
                                      : std::vector<std::string>{extension + ": extension not used"});
    }
}

TEST_F(GltfCompression, WhatOnlyTheLaterMeshoptHoldsIsRefused) {
    const std::string extension = kMeshopt[1];
    Document document = withMeshopt(extension.c_str());
    // As gltfpack has it: what is compressed in the BIN chunk, a buffer without bytes for what it
    // becomes.
    std::swap(document.root["buffers"][0], document.root["buffers"][1]);
    document.root["buffers"][0].erase("uri");
    document.root["buffers"][1]["extensions"][extension] = {{"fallback", true}};
    for (json& view : document.root["bufferViews"]) {
        view["buffer"] = 1;
        view["extensions"][extension]["buffer"] = 0;
    }
    expectSays(refusal(document), "is there only as " + extension + ", which is not supported");
}

TEST_F(GltfCompression, BytesThatAreMeshoptsAreNotRead) {
    for (const std::string extension : kMeshopt) {
        Document document = withMeshopt(extension.c_str());
        json& view = document.root["bufferViews"][1];
        json& compressed = view["extensions"][extension];
        const int begin = view["byteOffset"];
        const int end = begin + view["byteLength"].get<int>();
        compressed["buffer"] = 0;
        for (const int touching : {begin - 7, begin, end - 1}) {
            compressed["byteOffset"] = touching;
            EXPECT_NE(refusal(document), "loaded") << touching; // they are no sound ones
            compressed["byteOffset"] = static_cast<double>(touching);
            EXPECT_NE(refusal(document), "loaded") << touching;
        }
        for (const int beside : {begin - 8, end}) {
            compressed["byteOffset"] = beside;
            EXPECT_EQ(refusal(document), "loaded") << beside;
        }
        for (const json& unsound : {json("x"), json(-1), json(1.5), json(nullptr), json::object()}) {
            compressed["buffer"] = unsound;
            EXPECT_EQ(refusal(document), "loaded") << unsound; // what we do not read need not be sound
        }
    }
}

TEST_F(GltfCompression, BuffersWithoutBytesAreNoFaultUntilTheyAreUsed) {
    Document document = square();
    document.root["buffers"] = {{{"byteLength", document.bin.size()}}, {{"byteLength", 1000}}};
    expectIsTheSquare(load(document));
    document.root["bufferViews"][1]["buffer"] = 1;
    EXPECT_EQ(refusal(document), "buffer 1 has neither a URI nor a BIN chunk, or is a fallback");
}

} // namespace
} // namespace cdr::scene::test
