#include "draco_fixture.h"

#include <initializer_list>
#include <random>

namespace cdr::scene::test {
namespace {

using GltfHostileDraco = GltfFolder;

constexpr std::size_t kVersionAt = 5;
constexpr std::size_t kKindAt = 7;
constexpr std::size_t kMethodAt = 8;
constexpr std::size_t kFlagsAt = 10; // its higher byte
constexpr std::size_t kCountsAt = 11;

/// A triangle as a stream written by hand: sequential, positions of three floats as they are.
Bytes handWritten() {
    Bytes bytes{
        'D', 'R', 'A', 'C', 'O', 2, 2, 1, 0,
        0,   0,   1,   3,   1,   0, 1, 2,  // one triangle of three vertices, plain indices
        1,   1,   0,   9,   3,   0, 7, 0}; // one group of one attribute: floats, with the id 7, as they are
    const std::vector<float> positions = corners(false);
    const auto* values = reinterpret_cast<const std::uint8_t*>(positions.data());
    bytes.insert(bytes.end(), values, values + positions.size() * sizeof(float));
    return bytes;
}
constexpr std::size_t kGroupsAt = kCountsAt + 6;
constexpr std::size_t kValuesAt = kGroupsAt + 8;

/// A document of one triangle that a stream holds.
Document documentOf(const Bytes& stream, std::size_t triangles = 1, std::size_t vertices = 3) {
    Document document = triangle();
    document.root["accessors"] = {{{"componentType", kFloat}, {"count", vertices}, {"type", "VEC3"}},
                                  {{"componentType", kUInt}, {"count", 3 * triangles}, {"type", "SCALAR"}}};
    json& primitive = document.primitive();
    primitive = {{"attributes", {{"POSITION", 0}}}, {"indices", 1}};
    primitive["extensions"][kDraco] = {{"bufferView", document.addView(stream)},
                                       {"attributes", {{"POSITION", 7}}}};
    document.root["extensionsRequired"] = {kDraco};
    return document;
}

Bytes with(Bytes bytes, std::size_t at, std::uint8_t value) {
    bytes.at(at) = value;
    return bytes;
}

/// Numbers in groups of seven bits.
Bytes million() {
    return {0xc0, 0x84, 0x3d};
}
Bytes billion() {
    return {0x80, 0x94, 0xeb, 0xdc, 0x03};
}

/// The first bytes of some, others, a number, and zeros: counts are believed only if there are bytes for them.
Bytes begin(const Bytes& bytes, std::size_t count, std::initializer_list<int> rest,
            const Bytes& number = {}) {
    Bytes result(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(count));
    for (const int byte : rest) {
        result.push_back(static_cast<std::uint8_t>(byte));
    }
    result.insert(result.end(), number.begin(), number.end());
    result.resize(result.size() + 20'000);
    return result;
}

TEST_F(GltfHostileDraco, WhatIsNoMeshOfItsVersionIsRefused) {
    const Bytes sound = handWritten();
    const GltfImport import = load(documentOf(sound));
    ASSERT_EQ(import.scene.meshes.size(), 1u);
    EXPECT_EQ(import.scene.meshes[0].vertices[2].position - import.scene.meshes[0].vertices[0].position,
              glm::vec3(2, 4, 0));
    EXPECT_EQ(
        refusal(documentOf(with(sound, kKindAt, 0))),
        "mesh 0 '' primitive 0: KHR_draco_mesh_compression holds a point cloud, and only triangles are drawn");
    expectSays(refusal(documentOf(with(sound, kKindAt, 9))), "holds what is no mesh");
    expectSays(refusal(documentOf(with(sound, kVersionAt, 1))),
               "holds a stream of version 1.2, and glTF has 2.2");
    expectSays(refusal(documentOf(with(sound, kVersionAt + 1, 3))), "version 2.3");
    expectSays(refusal(documentOf(with(sound, 0, 'd'))), "holds no Draco stream");
    expectSays(refusal(documentOf(with(sound, kMethodAt, 2))), "is damaged");
    expectSays(refusal(documentOf(Bytes(sound.begin(), sound.begin() + 10))), "holds no Draco stream");
    expectSays(refusal(documentOf(with(sound, kMethodAt, 1))), "in a way that is not supported (1)");
}

TEST_F(GltfHostileDraco, AStreamThatEndsEarlyIsRefused) {
    const Bytes sound = handWritten();
    for (std::size_t size = 1; size < sound.size(); ++size) {
        expectSays(
            refusal(documentOf(Bytes(sound.begin(), sound.begin() + static_cast<std::ptrdiff_t>(size)))),
            "KHR_draco_mesh_compression");
    }
    expectSays(refusal(documentOf(Bytes(sound.begin(), sound.end() - 1))),
               "what KHR_draco_mesh_compression holds is damaged: Failed to decode point attributes.");
}

TEST_F(GltfHostileDraco, CountsAreThoseOfTheFile) {
    const Bytes sound = handWritten();
    expectSays(refusal(documentOf(with(sound, kCountsAt, 0))), "holds 0 triangles, and its indices make 1");
    expectSays(refusal(documentOf(with(sound, kCountsAt, 2))), "holds 2 triangles, and its indices make 1");
    expectSays(refusal(documentOf(with(sound, kCountsAt + 1, 2))),
               "holds 2 vertices, and its attributes have 3");
    expectSays(refusal(documentOf(with(sound, kCountsAt + 1, 4))), "is damaged"); // more than corners
    // Draco itself does not look at the indices.
    expectSays(refusal(documentOf(with(sound, kCountsAt + 3, 200))), "holds index 200, over 3 vertices");
}

/// Triangles take memory before there is a byte of them.
TEST_F(GltfHostileDraco, MemoryOfTrianglesIsForetold) {
    constexpr std::size_t kTriangles = 1'000'000;
    Bytes stream = begin(handWritten(), kMethodAt, {1, 0, 0, 0}); // edgebreaker, of the standard kind
    stream.resize(kCountsAt + 1);
    for (const int count : {0, 1, 2, 3, 4}) { // vertices, triangles, tables of attributes, symbols, splits
        if (count == 2) {
            stream.push_back(255);
        } else if (count == 4) {
            stream.push_back(0);
        } else {
            const Bytes number = million();
            stream.insert(stream.end(), number.begin(), number.end());
        }
    }
    stream.resize(stream.size() + 1000);
    expectSays(refusal(documentOf(stream, kTriangles, kTriangles)),
               "decoding KHR_draco_mesh_compression would take 59");
    expectSays(refusal(documentOf(stream, 1000, 1000)), "holds 1000000 triangles, and its indices make 1000");
}

TEST_F(GltfHostileDraco, MemoryOfAttributesIsForetold) {
    // 64 groups with an attribute of 255 doubles each, which no byte follows.
    Bytes stream = begin(handWritten(), kGroupsAt, {64});
    stream.resize(kGroupsAt + 1);
    for (int i = 0; i < 64; ++i) {
        stream.insert(stream.end(), {1, 4, 10, 255, 0, static_cast<std::uint8_t>(i), 0});
    }
    expectSays(refusal(documentOf(stream)), "is damaged");
    GltfLimits limits;
    limits.maxBytes = 8'000'000;
    expectSays(refusal(documentOf(stream), limits), "holds attributes that would take 8");
    stream = begin(handWritten(), kGroupsAt, {1, 65});
    expectSays(refusal(documentOf(stream)), "holds more than 64 attributes");
    stream = begin(handWritten(), kGroupsAt, {1}, billion());
    expectSays(refusal(documentOf(stream)), "holds more than 64 attributes");
}

/// libdraco takes 12 bytes for each symbol that a table says it has, if there is a byte for 64 of them.
TEST_F(GltfHostileDraco, TablesHaveNoMoreSymbolsThanAnEncoderWrites) {
    constexpr const char* kSays = "holds a table of more symbols than an encoder writes";
    const Bytes sound = handWritten();
    // Compressed indices: the method, raw symbols of one bit, their table.
    expectSays(refusal(documentOf(begin(sound, kCountsAt + 2, {0, 1, 1}, million()))), kSays);
    expectSays(refusal(documentOf(begin(sound, kCountsAt + 2, {0, 0}, million()))), kSays);
    // The same of an attribute: quantised (2) or of integers (1), no prediction (-2) or a difference (0), compressed.
    for (const int kind : {1, 2}) {
        Bytes attribute = with(sound, kValuesAt - 1, static_cast<std::uint8_t>(kind));
        attribute = with(attribute, kValuesAt - 5, kind == 1 ? 5 : 9);
        expectSays(refusal(documentOf(begin(attribute, kValuesAt, {0xfe, 1, 1, 1}, million()))), kSays);
        expectSays(refusal(documentOf(begin(attribute, kValuesAt, {0, 1, 1, 1, 1}, million()))), kSays);
        expectSays(refusal(documentOf(begin(attribute, kValuesAt, {0xfe, 1, 1, 1, 2}))), "is damaged");
    }
    // And of normals (3).
    const Bytes normals = with(sound, kValuesAt - 1, 3);
    expectSays(refusal(documentOf(begin(normals, kValuesAt, {0, 3, 1, 1, 1}, million()))), kSays);
    expectSays(refusal(documentOf(begin(normals, kValuesAt, {0xfe, 1, 1, 1}, million()))), kSays);
}

TEST_F(GltfHostileDraco, PredictionsThatDoNotExistAreRefused) {
    const Bytes quantised = with(handWritten(), kValuesAt - 1, 2);
    for (const int method : {-11, -1, 7, 100}) {
        expectSays(refusal(documentOf(begin(quantised, kValuesAt, {method, 1, 0}))),
                   "holds a prediction that does not exist (" + std::to_string(method) + ")");
    }
}

/// Contexts of edgebreaker's symbols have tables too.
TEST_F(GltfHostileDraco, TablesOfConnectivityAreLookedAt) {
    Bytes stream = begin(handWritten(), kMethodAt, {1, 0, 0, 2}); // edgebreaker, of the valence kind
    stream.resize(kCountsAt + 1);
    stream.insert(stream.end(),
                  {3, 1, 0, 1, 0});              // vertices, triangles, tables of attributes, symbols, splits
    stream.insert(stream.end(), {0, 128, 1, 0}); // splits, starts of components
    const std::size_t contexts = stream.size();
    expectSays(refusal(documentOf(begin(stream, contexts, {1, 1, 1}, million()))),
               "holds a table of more symbols");
    expectSays(refusal(documentOf(begin(stream, contexts, {2, 1, 1, 2}))),
               "is damaged"); // two symbols, one triangle
    expectSays(refusal(documentOf(begin(stream, contexts - 4, {2}))), "is damaged"); // two splits of it
}

/// Texture coordinates have flags of which libdraco makes as many as the stream says, to 2^31.
TEST_F(GltfHostileDraco, FlagsAreNoMoreThanCorners) {
    Document document = square();
    document.setFloats("TEXCOORD_0", "VEC2", {0, 0, 1, 0.5f, 0.7f, 1, 0.2f, 0.9f});
    document = compressed(document, {.speed = 0, .bits = 12});
    EXPECT_EQ(refusal(document), "loaded");
    const json& view = document.root["bufferViews"].back();
    const std::size_t from = view["byteOffset"];
    const std::size_t bytes = view["byteLength"];
    int found = 0;
    for (std::size_t at = from + kCountsAt; at + 4 <= from + bytes; ++at) { // one of them is where they are
        Document hostile = document;
        const std::array<std::uint8_t, 4> many{0xff, 0xff, 0xff, 0x7f};
        std::copy(many.begin(), many.end(), hostile.bin.begin() + static_cast<std::ptrdiff_t>(at));
        found += refusal(hostile).find("holds 2147483647 flags of 2 triangles") != std::string::npos ? 1 : 0;
    }
    EXPECT_GE(found, 1);
}

/// libdraco keeps trees of metadata on a stack, as many as each says there are.
TEST_F(GltfHostileDraco, MetadataMakesNoStack) {
    const Bytes sound = with(handWritten(), kFlagsAt, 0x80);
    expectSays(refusal(documentOf(begin(sound, kCountsAt, {0, 0}, billion()))), "is damaged");
    expectSays(refusal(documentOf(begin(sound, kCountsAt, {}, billion()))), "is damaged");
    Bytes stream = begin(sound, kCountsAt, {1, 0, 0, 0, 0, 0}); // an attribute's, and the mesh's
    stream.resize(kCountsAt + 6);
    const Bytes plain = handWritten();
    stream.insert(stream.end(), plain.begin() + kCountsAt, plain.end());
    EXPECT_EQ(refusal(documentOf(stream)), "loaded");
}

TEST_F(GltfHostileDraco, AStreamOfManyPrimitivesTakesItsBytesForEach) {
    Bytes stream = handWritten();
    stream.resize(stream.size() + 500'000); // what is behind it does not matter
    Document document = documentOf(stream);
    GltfLimits limits;
    limits.maxFileBytes = document.glb().size() + 1000;
    EXPECT_EQ(refusal(document, limits), "loaded");
    const json primitive = document.primitive();
    document.root["meshes"][0]["primitives"] = {primitive, primitive};
    expectSays(
        refusal(document, limits),
        "mesh 0 '' primitive 1: with it, meshes of KHR_draco_mesh_compression are over the limit of bytes");
}

/// Counts bound the attributes of a stream, and not the names that a document gives each.
TEST_F(GltfHostileDraco, NamesOfOneAttributeShareItsValues) {
    Document document = documentOf(handWritten());
    GltfLimits limits;
    limits.maxBytes = 7'400'000; // most of it for what libdraco may take
    EXPECT_EQ(refusal(document, limits), "loaded");
    for (int i = 0; i < 250'000; ++i) { // of 36 bytes each
        const std::string name = "_" + std::to_string(i);
        document.primitive()["attributes"][name] = 0;
        document.primitive()["extensions"][kDraco]["attributes"][name] = 7;
    }
    EXPECT_EQ(refusal(document, limits), "loaded");
}

/// Whatever became of a stream, it loads or is refused.
TEST_F(GltfHostileDraco, DamagedBytesAreRefusedOrRead) {
    std::mt19937 random(5);
    GltfLimits limits;
    limits.maxBytes = 256ull << 20;
    for (const DracoOptions& options :
         {DracoOptions{.method = draco::MESH_SEQUENTIAL_ENCODING},
          DracoOptions{.submethod = draco::MESH_EDGEBREAKER_STANDARD_ENCODING, .speed = 0},
          DracoOptions{
              .submethod = draco::MESH_EDGEBREAKER_VALENCE_ENCODING, .speed = 0, .metadata = true}}) {
        const Document sound = compressed(square(), options);
        const json& view = sound.root["bufferViews"].back();
        const std::size_t from = view["byteOffset"];
        const std::size_t bytes = view["byteLength"];
        int loaded = 0;
        for (int i = 0; i < 400; ++i) {
            Document document = sound;
            for (int change = 0; change < 1 + i % 3; ++change) {
                document.bin[from + random() % bytes] = static_cast<std::uint8_t>(random());
            }
            loaded += refusal(document, limits) == "loaded" ? 1 : 0;
        }
        EXPECT_GT(loaded, 0);
        EXPECT_LT(loaded, 400);
    }
}

} // namespace
} // namespace cdr::scene::test
