#include "fixture.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <random>
#include <vector>

namespace cdr::scene::test {
namespace {

using GltfMeshopt = GltfFolder;

constexpr const char* kExtension = "EXT_meshopt_compression";
/// Buffer views of square(); the first one is not used.
constexpr std::size_t kPositions = 1;
constexpr std::size_t kNormals = 2;
constexpr std::size_t kIndices = 3;

/// What the encoder makes of elements.
template <typename Encode>
Bytes encoded(std::size_t room, const Encode& encode) {
    Bytes bytes(room);
    bytes.resize(encode(bytes.data(), bytes.size()));
    return bytes;
}

Bytes encodedVertices(const void* vertices, std::size_t count, std::size_t stride) {
    meshopt_encodeVertexVersion(0);
    return encoded(meshopt_encodeVertexBufferBound(count, stride), [&](auto* into, std::size_t room) {
        return meshopt_encodeVertexBuffer(into, room, vertices, count, stride);
    });
}

/// The bytes of a view, compressed where the document's bytes end; the view then lies in a buffer that has none.
void compress(Document& document, std::size_t view, const Bytes& compressed, std::size_t stride,
              const json& mode, const json& filter = nullptr) {
    json& source = document.root["bufferViews"][view];
    const std::size_t length = source["byteLength"];
    json extension = {
        {"buffer", 0},          {"byteOffset", document.bin.size()}, {"byteLength", compressed.size()},
        {"byteStride", stride}, {"count", length / stride},          {"mode", mode}};
    if (!filter.is_null()) {
        extension["filter"] = filter;
    }
    document.bin.insert(document.bin.end(), compressed.begin(), compressed.end());
    source["buffer"] = 1;
    source["byteOffset"] = 0;
    source["extensions"][kExtension] = extension;
}

/// The square: positions and normals as attributes, indices as triangles or, in order, as indices.
Document packed(bool asTriangles) {
    Document document = square();
    const std::vector<float> positions = corners(true);
    compress(document, kPositions, encodedVertices(positions.data(), 4, 12), 12, "ATTRIBUTES");
    const std::vector<float> normals{0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};
    compress(document, kNormals, encodedVertices(normals.data(), 4, 12), 12, "ATTRIBUTES");
    const std::vector<unsigned> indices{0, 1, 2, 0, 2, 3};
    meshopt_encodeIndexVersion(1);
    const Bytes triangles = encoded(meshopt_encodeIndexBufferBound(6, 4), [&](auto* into, std::size_t room) {
        return meshopt_encodeIndexBuffer(into, room, indices.data(), 6);
    });
    const Bytes sequence = encoded(meshopt_encodeIndexSequenceBound(6, 4), [&](auto* into, std::size_t room) {
        return meshopt_encodeIndexSequence(into, room, indices.data(), 6);
    });
    compress(document, kIndices, asTriangles ? triangles : sequence, 2,
             asTriangles ? "TRIANGLES" : "INDICES");
    document.root["buffers"] = {{{"byteLength", document.bin.size()}}, {{"byteLength", 200}}};
    document.root["extensionsUsed"] = {kExtension};
    document.root["extensionsRequired"] = {kExtension};
    return document;
}

json& extensionOf(Document& document, std::size_t view) {
    return document.root["bufferViews"][view]["extensions"][kExtension];
}

/// Each triangle's corners, from the least one on.
std::vector<std::vector<std::vector<float>>> trianglesOf(const Mesh& mesh) {
    std::vector<std::vector<std::vector<float>>> triangles;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        auto& triangle = triangles.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::vec3& position = mesh.vertices.at(mesh.indices[i + k]).position;
            triangle.push_back({position.x, position.y, position.z});
        }
        std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
    }
    std::sort(triangles.begin(), triangles.end());
    return triangles;
}

TEST_F(GltfMeshopt, GivesTheBytesThatWereCompressed) {
    const Scene wanted = load(square()).scene;
    for (const bool asTriangles : {false, true}) {
        const GltfImport import = load(packed(asTriangles));
        EXPECT_TRUE(import.ignored.empty());
        const Mesh& mesh = import.scene.meshes.at(0);
        // The encoder may turn a triangle so that another corner comes first.
        EXPECT_EQ(trianglesOf(mesh), trianglesOf(wanted.meshes[0]));
        if (!asTriangles) {
            EXPECT_EQ(mesh.indices, wanted.meshes[0].indices);
        }
        ASSERT_EQ(mesh.vertices.size(), 4u);
        EXPECT_EQ(import.scene.instances.position(0), wanted.instances.position(0));
        EXPECT_EQ(import.scene.instances.radius[0], wanted.instances.radius[0]);
        for (const Vertex& vertex : mesh.vertices) {
            EXPECT_EQ(vertex.normal, glm::vec3(0, 0, 1));
        }
    }
}

/// An octahedral normal of 8 bits, and positions with an exponent of their own.
TEST_F(GltfMeshopt, UndoesItsFilters) {
    Document document = packed(true);
    std::vector<std::int8_t> normals(16);
    const std::vector<float> directions{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 1, 0};
    meshopt_encodeFilterOct(normals.data(), 4, 4, 8, directions.data());
    document.root["bufferViews"][kNormals]["byteLength"] = 16;
    compress(document, kNormals, encodedVertices(normals.data(), 4, 4), 4, "ATTRIBUTES", "OCTAHEDRAL");
    document.root["bufferViews"][kNormals]["byteStride"] = 4;
    document.root["accessors"][1]["componentType"] = kByte;
    document.root["accessors"][1]["normalized"] = true;
    std::vector<std::uint32_t> positions(12);
    meshopt_encodeFilterExp(positions.data(), 4, 12, 20, corners(true).data());
    compress(document, kPositions, encodedVertices(positions.data(), 4, 12), 12, "ATTRIBUTES", "EXPONENTIAL");
    document.root["buffers"][0]["byteLength"] = document.bin.size();
    const GltfImport import = load(document);
    EXPECT_EQ(import.scene.instances.position(0), glm::dvec3(1, 2, 0));
    const std::vector<Vertex>& vertices = import.scene.meshes.at(0).vertices;
    for (const Vertex& vertex : vertices) {
        const bool isX = vertex.position == vertices[0].position;
        EXPECT_NEAR(glm::length(vertex.normal), 1.0f, 1e-3f);
        EXPECT_TRUE(isX ? vertex.normal.x > 0.99f : std::abs(vertex.normal.x) < 0.02f);
    }
}

TEST_F(GltfMeshopt, UnsoundOnesAreRefused) {
    const auto with = [&](std::size_t view, const char* key, const json& value) {
        Document document = packed(true);
        extensionOf(document, view)[key] = value;
        return refusal(document);
    };
    expectSays(with(kPositions, "mode", "POINTS"), "has no 'POINTS'");
    expectSays(with(kPositions, "filter", "BLUR"), "has no 'BLUR'");
    expectSays(with(kPositions, "filter", "QUATERNION"), "no elements of 12 bytes in that mode and filter");
    expectSays(with(kIndices, "filter", "EXPONENTIAL"), "no elements of 2 bytes");
    expectSays(with(kIndices, "byteStride", 3), "no elements of 3 bytes");
    expectSays(with(kPositions, "byteStride", 0), "no elements of 0 bytes");
    expectSays(with(kPositions, "byteStride", 260), "no elements of 260 bytes");
    expectSays(with(kPositions, "count", 5), "5 elements of 12 bytes for 48");
    expectSays(with(kPositions, "count", 2'000'000'000), "2000000000 elements");
    expectSays(with(kPositions, "byteLength", 5'000), "covers 5000 bytes");
    expectSays(with(kPositions, "byteLength", 8), "damaged");
    expectSays(with(kPositions, "buffer", 1), "neither a URI nor a BIN chunk");
    expectSays(with(kPositions, "buffer", 9), "buffer 9 does not exist");
    for (const char* key : {"buffer", "byteLength", "byteStride", "count"}) {
        EXPECT_NE(with(kPositions, key, "x"), "loaded") << key;
        EXPECT_NE(with(kPositions, key, nullptr), "loaded") << key;
    }
}

/// Whatever became of the compressed bytes, they load or are refused.
TEST_F(GltfMeshopt, DamagedBytesAreRefusedOrRead) {
    const Document sound = packed(true);
    std::mt19937 random(3);
    int loaded = 0;
    for (int i = 0; i < 300; ++i) {
        Document document = sound;
        for (int change = 0; change < 1 + i % 3; ++change) {
            document.bin[random() % document.bin.size()] = static_cast<std::uint8_t>(random());
        }
        loaded += refusal(document) == "loaded" ? 1 : 0;
    }
    EXPECT_GT(loaded, 0);
    EXPECT_LT(loaded, 300);
}

/// A copy for programs that cannot decode, which may have been left behind.
TEST_F(GltfMeshopt, TheFallbackIsNotOpened) {
    Document document = packed(true);
    json& fallback = document.root["buffers"][1];
    fallback["uri"] = "gone.bin";
    fallback["extensions"][kExtension] = {{"fallback", true}};
    EXPECT_EQ(refusal(document), "loaded");
    document.root["bufferViews"][kPositions].erase("extensions");
    EXPECT_EQ(refusal(document), "buffer 1 has neither a URI nor a BIN chunk, or is a fallback");
    fallback["extensions"][kExtension]["fallback"] = "yes";
    expectSays(refusal(document), "buffer 1: 'fallback' is neither true nor false");
    fallback["extensions"][kExtension]["fallback"] = false;
    expectSays(refusal(document), "gone.bin: no such file");
}

TEST_F(GltfMeshopt, DecodedBytesAreBounded) {
    GltfLimits limits;
    limits.maxFileBytes = packed(true).glb().size();
    EXPECT_EQ(refusal(packed(true), limits), "loaded");
    Document document = packed(true);
    // Thousands of equal vertices take few bytes.
    const std::vector<float> zeros(30'000, 0.0f);
    document.root["bufferViews"][kNormals]["byteLength"] = zeros.size() * sizeof(float);
    compress(document, kNormals, encodedVertices(zeros.data(), 10'000, 12), 12, "ATTRIBUTES");
    document.root["buffers"][0]["byteLength"] = document.bin.size();
    limits.maxFileBytes = document.glb().size();
    expectSays(refusal(document, limits), "over the limit of bytes");
}

} // namespace
} // namespace cdr::scene::test
