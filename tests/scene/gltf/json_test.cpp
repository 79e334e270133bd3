#include "fixture.h"

#include <cdr/scene/gltf/checks.h>

namespace cdr::scene::test {
namespace {

using GltfJson = GltfFolder;

/// A triangle whose buffer of 36 bytes is this URI.
std::string withDataUri(const std::string& uri) {
    Document document = triangle();
    document.root["buffers"] = {{{"byteLength", 36}, {"uri", uri}}};
    return document.root.dump();
}

TEST_F(GltfJson, Base64IsReadToItsLastCharacter) {
    const std::string header = "data:application/octet-stream;base64,";
    const std::string zeros(44, 'A'); // 33 bytes
    const auto tryUri = [&](const std::string& uri) { return refusal(write("a.gltf", withDataUri(uri))); };
    EXPECT_EQ(tryUri(header + zeros + "AAAA"), "loaded");
    EXPECT_EQ(tryUri("data:application/gltf-buffer;base64," + zeros + "AAAA"), "loaded");
    expectSays(tryUri(header + zeros + "AAA="), "its data has 35");
    expectSays(tryUri(header + zeros + "AAA"), "its data has 35");
    expectSays(tryUri(header + zeros + "AA=="), "its data has 34");
    for (const std::string end : {"A", "AAA!", "A===", "AA\nA", "-_AA", "AA=A"}) {
        expectSays(tryUri(header + zeros + end), "cannot be decoded: what follows the comma is not base64");
    }
    expectSays(tryUri(header), "nothing follows the comma");
}

/// Schemes, media types and `base64` have letters of either case (RFC 3986, 2045 and 2397).
TEST_F(GltfJson, DataUrisHaveLettersOfEitherCase) {
    const auto tryUri = [&](const std::string& uri) { return refusal(write("a.gltf", withDataUri(uri))); };
    const std::string zeros(48, 'A');
    EXPECT_EQ(tryUri("DATA:application/octet-stream;base64," + zeros), "loaded");
    EXPECT_EQ(tryUri("Data:Application/Octet-Stream;BASE64," + zeros), "loaded");
    EXPECT_TRUE(gltfReferences(write("a.gltf", withDataUri("DATA:text/plain;base64," + zeros))).empty());
}

TEST_F(GltfJson, DataUrisThatAreRefusedSayWhy) {
    const auto tryUri = [&](const std::string& uri) { return refusal(write("a.gltf", withDataUri(uri))); };
    for (const char* uri : {"data:", "data:,", "data:application/octet-stream,AAAA", "data:base64,AAAA",
                            "data:text/plain,a;base64,AAAA"}) {
        expectSays(tryUri(uri), "cannot be decoded: it is not base64");
    }
    expectSays(tryUri("data:;base64,AAAA"), "'' is no media type of a buffer or a picture");
    expectSays(tryUri("DATA:audio/wav;base64,AAAA"),
               "'audio/wav' is no media type of a buffer or a picture; those are application/octet-stream, "
               "application/gltf-buffer, image/png, image/jpeg, image/bmp, image/gif, text/plain");
    expectSays(tryUri("data:text/plain;charset=utf-8;base64,AAAA"), "'text/plain;charset=utf-8' is no media");
}

TEST_F(GltfJson, Base64KeepsEveryBit) {
    Document document = triangle();
    // The floats 0 0 0, 0x1.7ddff6p+0 0 0, 0 0x1.fffffep+0 0: digits of every kind.
    document.root["buffers"] = {{{"byteLength", 36},
                                 {"uri", "data:application/octet-stream;base64,"
                                         "AAAAAAAAAAAAAAAA++++PwAAAAAAAAAAAAAAAP///z8AAAAA"}}};
    const Scene scene = loadGltf(write("a.gltf", document.root.dump())).scene;
    const Mesh& mesh = scene.meshes.at(0);
    EXPECT_EQ(mesh.vertices[1].position.x - mesh.vertices[0].position.x, 0x1.7ddff6p+0f);
    EXPECT_EQ(mesh.vertices[2].position.y - mesh.vertices[0].position.y, 0x1.fffffep+0f);
}

/// Defaults in their place would show another scene than the file's.
TEST_F(GltfJson, ValuesOfAnotherTypeAreRefused) {
    const auto withMaterial = [&](const json& material) {
        Document document = square();
        document.root["materials"] = {material};
        document.primitive()["material"] = 0;
        return refusal(document);
    };
    expectSays(withMaterial({{"name", "m"}, {"doubleSided", 1}}),
               "material 'm': 'doubleSided' is neither true nor false");
    expectSays(withMaterial({{"alphaMode", 5}}), "'alphaMode' is not a string");
    expectSays(withMaterial({{"emissiveFactor", {1, 2}}}), "'emissiveFactor' is not 3 numbers");
    expectSays(withMaterial({{"pbrMetallicRoughness", json::array()}}),
               "'pbrMetallicRoughness' is not an object");
    expectSays(withMaterial({{"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1}}}}}),
               "'baseColorFactor' is not 4 numbers");
    expectSays(withMaterial({{"pbrMetallicRoughness", {{"baseColorTexture", {{"texCoord", 0}}}}}}),
               "has no 'index'");
    expectRefused(square(), "/accessors/0/normalized", "yes",
                  "accessor 0: 'normalized' is neither true nor false");
    expectRefused(square(), "/accessors/0/type", "VEC5", "accessor 0: its type 'VEC5' does not exist");
    expectRefused(square(), "/bufferViews/1/byteStride", 13, "buffer view 1: its byteStride is 13");
}

/// As glTF says of integers, and as some exporters write them.
TEST_F(GltfJson, IntegersMayBeWrittenAsDecimals) {
    const auto with = [&](const char* key, const char* number) {
        Document document = square();
        document.root["accessors"][0][key] = json::parse(number);
        return refusal(document);
    };
    EXPECT_EQ(with("count", "4.0"), "loaded");
    EXPECT_EQ(with("componentType", "5126.0"), "loaded");
    EXPECT_EQ(with("byteOffset", "0e0"), "loaded");
    EXPECT_EQ(with("byteOffset", "-0"), "loaded");
    EXPECT_EQ(with("byteOffset", "-0.0"), "loaded");
    EXPECT_EQ(with("count", "40e-1"), "loaded");
    expectSays(with("count", "1.5"), "'count' is 1.5, not an integer from 0 to 2147483647");
    for (const char* number : {"-1.0", "-1", "2147483648", "2147483648.0", "1e300", "-1e300", "\"4\""}) {
        expectSays(with("count", number), "not an integer from 0 to 2147483647");
    }
}

TEST_F(GltfJson, WhatIsLeftOutIsNamed) {
    const auto without = [&](const char* array, const char* key) {
        Document document = square();
        document.root[array].back().erase(key);
        return refusal(document);
    };
    EXPECT_EQ(without("accessors", "componentType"), "accessor 2: has no 'componentType'");
    EXPECT_EQ(without("accessors", "count"), "accessor 2: has no 'count'");
    EXPECT_EQ(without("accessors", "type"), "accessor 2: its type '' does not exist");
    EXPECT_EQ(without("bufferViews", "buffer"), "buffer view 3: has no 'buffer'");
    EXPECT_EQ(without("bufferViews", "byteLength"), "buffer view 3: has no 'byteLength'");
    Document document = square();
    document.primitive().erase("attributes");
    EXPECT_EQ(refusal(document), "mesh 0 '' primitive 0: has no 'attributes'");
}

TEST_F(GltfJson, WhatTheSceneDoesNotUseNeedNotBeSound) {
    Document document = square();
    document.root["accessors"].push_back({{"componentType", "x"}});
    document.root["meshes"].push_back({{"primitives", 5}});
    document.root["materials"] = {5};
    document.root["textures"] = {"x"};
    document.root["images"] = {json::object()};
    EXPECT_EQ(refusal(document), "loaded");
}

TEST_F(GltfJson, NamesAreKeptWhole) {
    Document document = square();
    const std::string name = std::string(1000, 'x') + "\n";
    document.root["nodes"][0]["name"] = name;
    document.root["materials"] = {{{"name", name}}};
    document.primitive()["material"] = 0;
    const Scene scene = load(document).scene;
    EXPECT_EQ(scene.objectNames[0], name);
    EXPECT_EQ(scene.materials[0].name, name);
}

TEST_F(GltfJson, LongNamesDoNotPushOutWhatIsSaid) {
    Document document = square();
    const std::string name(1000, 'x');
    document.root["meshes"][0]["name"] = name;
    document.root["materials"] = {{{"name", name}, {"extras", {{"cdr_layer", "x"}}}}};
    document.primitive()["material"] = 0;
    EXPECT_TRUE(anySays(load(document).ignored, "x...': a layer that is no finite number is not used"));
    document.root["nodes"] = {{{"children", {2}}, {"name", name}},
                              {{"children", {2}}, {"name", name}},
                              {{"mesh", 0}, {"name", name}}};
    expectSays(refusal(document), "x...', and a node has one parent");
    document = square();
    document.root["meshes"][0]["name"] = name;
    document.primitive().erase("attributes");
    expectSays(refusal(document), "x...' primitive 0: has no 'attributes'");
}

TEST_F(GltfJson, NamesHoldNoControlCharacters) {
    EXPECT_EQ(gltf::oneLine("a\x1b[31mb\nc\x7f"), "a [31mb c ");
    EXPECT_EQ(gltf::oneLine("a\u009b31mb\u0085"), "a  31mb  ");
    EXPECT_EQ(gltf::oneLine("\u00a0\u00c2\u00e9\u0100"), "\u00a0\u00c2\u00e9\u0100");
}

TEST_F(GltfJson, LongNamesEndWithAWholeCharacter) {
    EXPECT_EQ(gltf::oneLine("abc", 2), "ab...");
    EXPECT_EQ(gltf::oneLine("a\u00e4", 2), "a...");
    EXPECT_EQ(gltf::oneLine("a\u00e4", 3), "a\u00e4");
    EXPECT_EQ(gltf::oneLine("a\U0001f600b", 4), "a...");
    EXPECT_EQ(gltf::oneLine("a\U0001f600b", 5), "a\U0001f600...");
}

TEST_F(GltfJson, LineBreaksAtTheEndOfANameAreNotShown) {
    EXPECT_EQ(gltf::oneLine("ab\n\n"), "ab");
    EXPECT_EQ(gltf::oneLine("ab\n", 2), "ab");
    EXPECT_EQ(gltf::oneLine("\n"), "");
}

/// Bytes of a name that is too long to be looked at once for each use: a test would take minutes.
constexpr std::size_t kLongName = 16u << 20u;
constexpr int kManyUses = 20'000;

TEST_F(GltfJson, ALongNameOfAMaterialIsNotCopiedForEachPart) {
    Document document = square();
    document.root["meshes"][0]["primitives"].push_back(document.primitive());
    document.root["materials"] = {{{"name", std::string(kLongName, 'm')}}};
    document.primitive()["material"] = 0;
    document.root["nodes"][0]["name"] = "n" + std::string(kLongName, '\n');
    const int places = document.addAccessor(std::vector<float>(3), "VEC3", kFloat);
    document.root["accessors"].back().erase("bufferView"); // which makes them zeros
    document.root["accessors"].back()["count"] = kManyUses;
    document.root["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
        {"TRANSLATION", places}};
    const std::vector<std::string> names = load(document).scene.objectNames;
    ASSERT_EQ(names.size(), 2u * kManyUses);
    EXPECT_TRUE(names[0].ends_with(" 0 / " + std::string(100, 'm') + "...")) << names[0];
    EXPECT_TRUE(names.back().ends_with(" 19999 / part 1")) << names.back();
}

TEST_F(GltfJson, ALongNameOfAMaterialIsNotCopiedForEachLayer) {
    Document document = square();
    document.root["materials"] = {{{"name", std::string(kLongName, 'm')}}};
    document.primitive()["material"] = 0;
    document.root["nodes"].clear();
    document.root["scenes"][0]["nodes"].clear();
    for (int i = 0; i < kManyUses; ++i) {
        document.root["nodes"].push_back({{"mesh", 0}, {"extras", {{"cdr_layer", i}}}});
        document.root["scenes"][0]["nodes"].push_back(i);
    }
    const std::vector<Material> materials = load(document).scene.materials;
    ASSERT_EQ(materials.size(), static_cast<std::size_t>(kManyUses));
    EXPECT_EQ(materials.front().name.size(), kLongName);
    EXPECT_EQ(materials.back().name, std::string(100, 'm') + "...");
}

TEST_F(GltfJson, ALongNameOfACameraIsNotCopiedForEachNode) {
    Document document = square();
    document.root["cameras"] = {{{"type", "perspective"},
                                 {"name", std::string(kLongName, 'c')},
                                 {"perspective", {{"yfov", 4.0}, {"znear", 1.0}}}}};
    for (int i = 1; i <= kManyUses; ++i) {
        document.root["nodes"].push_back({{"camera", 0}});
        document.root["scenes"][0]["nodes"].push_back(i);
    }
    const GltfImport import = load(document);
    EXPECT_TRUE(import.cameras.empty());
    EXPECT_TRUE(anySays(import.ignored, "c...' and 19999 more: not used, because pictures have no such"));
}

} // namespace
} // namespace cdr::scene::test
