#include "fixture.h"

#include <cdr/image/codec.h>
#include <cdr/scene/gltf/import.h>

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <random>
#include <utility>

namespace cdr::scene::test {
namespace {

namespace fs = std::filesystem;

/// Bytes of a file are read when they are needed. Each test that compares does so with the same bytes in memory.
class GltfStreaming : public GltfFolder {
  protected:
    static void expectSameMeshes(const Scene& a, const Scene& b) {
        ASSERT_EQ(a.meshes.size(), b.meshes.size());
        ASSERT_FALSE(a.meshes.empty());
        for (std::size_t i = 0; i < a.meshes.size(); ++i) {
            EXPECT_EQ(a.meshes[i].indices, b.meshes[i].indices) << i;
            ASSERT_EQ(a.meshes[i].vertices.size(), b.meshes[i].vertices.size()) << i;
            EXPECT_EQ(std::memcmp(a.meshes[i].vertices.data(), b.meshes[i].vertices.data(),
                                  a.meshes[i].vertices.size() * sizeof(Vertex)),
                      0)
                << i;
        }
    }

    /// Imports a document from a file and from memory.
    void expectSameFromFile(const Document& document) const {
        const Bytes bytes = document.glb();
        const fs::path path = write("a.glb", bytes);
        const GltfImport inMemory = gltf::importGltf(gltf::ByteSource(bytes), path, GltfLimits{});
        expectSameMeshes(loadGltf(path).scene, inMemory.scene);
    }

    /// What loading says when the file changes as soon as the counts of its meshes are known, and nothing else is read.
    template <typename Change>
    static std::string refusalAfter(const fs::path& path, const Change& change) {
        GltfLimits limits;
        limits.progress = [&, isDone = false](std::size_t, std::size_t) mutable {
            if (!std::exchange(isDone, true)) {
                change();
            }
        };
        return refusal(path, limits);
    }
};

enum class Order { asTheyAre, shuffled };

/// Vertices with normals, `stride` bytes apart, each used by several triangles.
Document interleaved(std::size_t vertices, std::size_t stride, Order order) {
    std::mt19937 random(2013);
    Document document = square();
    document.root["accessors"].clear();
    document.root["bufferViews"].clear();
    document.bin.clear();
    Bytes bytes(vertices * stride);
    for (std::size_t i = 0; i < vertices; ++i) {
        const std::vector<float> values{static_cast<float>(i % 251), static_cast<float>(i), 1, 0, 0, 1};
        std::memcpy(bytes.data() + i * stride, values.data(), values.size() * sizeof(float));
    }
    const int view = document.addView(bytes);
    document.root["bufferViews"].back()["byteStride"] = stride;
    for (const std::size_t offset : {std::size_t{0}, 3 * sizeof(float)}) {
        document.root["accessors"].push_back({{"bufferView", view},
                                              {"byteOffset", offset},
                                              {"componentType", kFloat},
                                              {"count", vertices},
                                              {"type", "VEC3"}});
    }
    std::vector<std::uint32_t> corners(vertices);
    std::iota(corners.begin(), corners.end(), 0u);
    if (order == Order::shuffled) {
        std::shuffle(corners.begin(), corners.end(), random);
    }
    std::vector<std::uint32_t> indices;
    for (std::size_t i = 0; i + 2 < vertices; ++i) {
        indices.insert(indices.end(), {corners[i], corners[i + 1], corners[i + 2]});
    }
    document.primitive()["attributes"] = {{"POSITION", 0}, {"NORMAL", 1}};
    document.primitive()["indices"] = document.addAccessor(indices, "SCALAR", kUInt);
    return document;
}

TEST_F(GltfStreaming, ElementsMayLieAcrossBlocks) {
    for (const std::size_t stride :
         {24u, 28u, 252u}) { // all but the first lie across ends of blocks of 16 KiB
        expectSameFromFile(interleaved(3000, stride, Order::asTheyAre));
        expectSameFromFile(interleaved(3000, stride, Order::shuffled));
    }
}

/// More than is kept of a file.
TEST_F(GltfStreaming, VerticesInAnyOrderAreTheSame) {
    Document document = interleaved(180'000, 252, Order::shuffled);
    expectSameFromFile(document);
    document.primitive()["attributes"].erase("NORMAL"); // each corner is a vertex of its own
    document.root["accessors"][2]["count"] = 99'999;
    expectSameFromFile(document);
}

/// The same of what deforms them.
TEST_F(GltfStreaming, InfluencesAndTargetsInAnyOrderAreTheSame) {
    constexpr std::size_t kVertices = 90'000;
    Document document = interleaved(kVertices, 252, Order::shuffled);
    const auto addRows = [&](const char* type, int componentType, std::size_t offset) {
        json accessor = document.root["accessors"][0];
        accessor["byteOffset"] = offset;
        accessor["type"] = type;
        accessor["componentType"] = componentType;
        document.root["accessors"].push_back(accessor);
        return document.root["accessors"].size() - 1;
    };
    for (std::size_t i = 0; i < kVertices; ++i) { // beside the positions and normals
        Bytes::value_type* row = document.bin.data() + i * 252;
        const std::vector<std::uint8_t> joints{static_cast<std::uint8_t>(i % 3), 1, 0, 0};
        const std::vector<float> weights{1, static_cast<float>(i % 5), 0, 0};
        const std::vector<float> delta{0, static_cast<float>(i % 4), 0};
        std::memcpy(row + 24, joints.data(), 4);
        std::memcpy(row + 28, weights.data(), 16);
        std::memcpy(row + 44, delta.data(), 12);
    }
    json& primitive = document.primitive();
    primitive["attributes"]["JOINTS_0"] = addRows("VEC4", kUByte, 24);
    primitive["attributes"]["WEIGHTS_0"] = addRows("VEC4", kFloat, 28);
    primitive["targets"] = {{{"POSITION", addRows("VEC3", kFloat, 44)}}};
    document.root["meshes"][0]["weights"] = {0.5};
    document.root["nodes"] = {{{"mesh", 0}, {"skin", 0}}, json::object(), json::object(), json::object()};
    document.root["scenes"] = {{{"nodes", {0, 1, 2, 3}}}};
    document.root["skins"] = {{{"joints", {1, 2, 3}}}};
    const Bytes bytes = document.glb();
    const fs::path path = write("a.glb", bytes);
    const GltfImport fromFile = loadGltf(path);
    const GltfImport inMemory = gltf::importGltf(gltf::ByteSource(bytes), path, GltfLimits{});
    expectSameMeshes(fromFile.scene, inMemory.scene);
    ASSERT_EQ(fromFile.animation->deformed.size(), 1u);
    const Deformer& a = fromFile.animation->deformed[0].deformer;
    const Deformer& b = inMemory.animation->deformed[0].deformer;
    EXPECT_EQ(a.firstInfluence, b.firstInfluence);
    ASSERT_EQ(a.influences.size(), b.influences.size());
    EXPECT_GT(a.influences.size(), kVertices);
    EXPECT_EQ(std::memcmp(a.influences.data(), b.influences.data(), a.influences.size() * sizeof(Influence)),
              0);
    ASSERT_EQ(a.targets.at(0).size(), b.targets.at(0).size());
    EXPECT_GT(a.targets[0].size(), kVertices / 2);
    EXPECT_EQ(std::memcmp(a.targets[0].data(), b.targets[0].data(), a.targets[0].size() * sizeof(MorphDelta)),
              0);
}

/// Few vertices, far from each other.
TEST_F(GltfStreaming, AFewOfManyVerticesAreTheSame) {
    Document document = interleaved(180'000, 252, Order::asTheyAre);
    document.primitive()["indices"] = document.addAccessor(
        std::vector<std::uint32_t>{179'999, 0, 90'000, 90'000, 7, 179'999}, "SCALAR", kUInt);
    expectSameFromFile(document);
}

TEST_F(GltfStreaming, SparseElementsAreTheSame) {
    Document document = interleaved(9000, 24, Order::asTheyAre);
    std::vector<std::uint32_t> places(4500);
    std::vector<float> values;
    for (std::uint32_t i = 0; i < places.size(); ++i) {
        places[i] = 2 * i + i % 2;
        values.insert(values.end(), {static_cast<float>(i), 5, static_cast<float>(i % 7)});
    }
    document.root["accessors"][0]["sparse"] = {
        {"count", places.size()},
        {"indices", {{"bufferView", document.addView(places)}, {"componentType", kUInt}}},
        {"values", {{"bufferView", document.addView(values)}}}};
    expectSameFromFile(document);
}

/// A process may have some files open, and a file may refer to thousands.
TEST_F(GltfStreaming, ReadsMoreFilesThanMayBeOpen) {
    constexpr std::size_t kFiles = 150;
    Document document = interleaved(2000, 36, Order::asTheyAre);
    for (std::size_t i = 0; i < kFiles; ++i) {
        Bytes bytes = document.bin;
        const float x = -static_cast<float>(i); // of the first vertex
        std::memcpy(bytes.data(), &x, sizeof(x));
        const std::string name = std::to_string(i) + ".bin";
        write(name, bytes);
        document.root["buffers"].push_back({{"byteLength", bytes.size()}, {"uri", name}});
        if (i == 0) {
            continue;
        }
        const int first = 3 * static_cast<int>(i);
        for (std::size_t k = 0; k < 3; ++k) {
            json accessor = document.root["accessors"][k];
            json view = document.root["bufferViews"][accessor["bufferView"].get<std::size_t>()];
            view["buffer"] = i;
            document.root["bufferViews"].push_back(view);
            accessor["bufferView"] = document.root["bufferViews"].size() - 1;
            document.root["accessors"].push_back(accessor);
        }
        document.root["meshes"][0]["primitives"].push_back(
            {{"attributes", {{"POSITION", first}, {"NORMAL", first + 1}}}, {"indices", first + 2}});
    }
    const fs::path path = write("a.gltf", document.root.dump());
    rlimit before{};
    ASSERT_EQ(getrlimit(RLIMIT_NOFILE, &before), 0);
    const rlimit few{.rlim_cur = 128, .rlim_max = before.rlim_max};
    ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &few), 0);
    const std::string message = refusal(path);
    std::vector<float> widths;
    if (message == "loaded") {
        GltfLimits limits;
        limits.pieceRadius = INFINITY;
        for (const Mesh& mesh : loadGltf(path, limits).scene.meshes) {
            const auto byX = [](const Vertex& a, const Vertex& b) { return a.position.x < b.position.x; };
            const auto [low, high] = std::minmax_element(mesh.vertices.begin(), mesh.vertices.end(), byX);
            widths.push_back(high->position.x - low->position.x);
        }
    }
    ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &before), 0);
    ASSERT_EQ(message, "loaded");
    ASSERT_EQ(widths.size(), kFiles);
    for (std::size_t i = 0; i < kFiles; ++i) {
        EXPECT_EQ(widths[i], 250.0f + static_cast<float>(i)) << i;
    }
}

TEST_F(GltfStreaming, AFileThatBecomesShorterIsRefused) {
    const Document document = interleaved(3000, 24, Order::asTheyAre);
    const fs::path glb = write("a.glb", document.glb());
    expectSays(refusalAfter(glb, [&] { fs::resize_file(glb, fs::file_size(glb) - 1); }),
               " bytes from byte 98304 on can no longer be read");
    write("a.glb", document.glb());
    EXPECT_EQ(refusalAfter(glb, [&] { fs::resize_file(glb, 0); }),
              "16384 bytes from byte 65536 on can no longer be read");

    Document beside = document;
    const fs::path bin = write("data.bin", document.bin);
    beside.root["buffers"] = {{{"byteLength", document.bin.size()}, {"uri", "data.bin"}}};
    EXPECT_EQ(refusalAfter(write("a.gltf", beside.root.dump()), [&] { fs::resize_file(bin, 70'000); }),
              "'data.bin': 16384 bytes from byte 65536 on can no longer be read");
}

/// A file that is removed, or has another one put in its place, is read as it was opened.
TEST_F(GltfStreaming, AFileThatIsReplacedIsReadAsItWas) {
    const fs::path path = write("a.glb", interleaved(3000, 24, Order::asTheyAre).glb());
    EXPECT_EQ(refusalAfter(path,
                           [&] {
                               fs::remove(path);
                               write("a.glb", Bytes(10));
                           }),
              "loaded");
    EXPECT_EQ(fs::file_size(path), 10u) << "it was replaced";
}

/// The size of a picture is known before the picture is decoded, and bounds what it takes.
TEST_F(GltfStreaming, APictureThatBecomesAnotherOneIsRefused) {
    const auto png = [](std::uint32_t side) { return image::encodePng(image::ImageRgba8(side, side)); };
    Document document = square();
    document.root["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
    document.root["textures"] = {{{"source", 0}}};
    document.root["images"] = {{{"uri", "a.png"}}};
    document.primitive()["material"] = 0;
    const fs::path path = write("a.glb", document.glb());
    write("a.png", png(2));
    EXPECT_EQ(refusal(path), "loaded");
    const auto refusalWith = [&](const auto& change) {
        GltfLimits limits;
        limits.progress = [&](std::size_t done, std::size_t all) {
            if (done > 0 && done < all) { // its meshes and materials are there
                change();
            }
        };
        std::string message = refusal(path, limits);
        write("a.png", png(2));
        return message;
    };
    EXPECT_EQ(refusalWith([&] { write("a.png", png(3)); }), "image 0 changed while the file was imported");
    expectSays(refusalWith([&] { fs::resize_file(folder() / "a.png", 40); }), "image 0: damaged PNG");
    expectSays(refusalWith([&] { fs::remove(folder() / "a.png"); }), "a.png: no such file");
}

/// A file of one mesh has one node, and is read by and by.
TEST_F(GltfStreaming, ProgressFollowsTheBytesOfOneMeshAndPictures) {
    Document document = interleaved(60'000, 24, Order::asTheyAre);
    const fs::path path = write("a.glb", document.glb());
    std::vector<double> shares;
    GltfLimits limits;
    limits.threads = 1;
    limits.progress = [&](std::size_t done, std::size_t all) {
        shares.push_back(static_cast<double>(done) / static_cast<double>(all));
    };
    EXPECT_EQ(refusal(path, limits), "loaded");
    EXPECT_GT(shares.size(), 20u);
    EXPECT_LT(shares.size(), 150u);
    EXPECT_EQ(shares.front(), 0.0);
    EXPECT_EQ(shares.back(), 1.0);
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
    const auto half = std::lower_bound(shares.begin(), shares.end(), 0.4);
    ASSERT_NE(half, shares.end());
    EXPECT_LT(*half, 0.7);
}

/// Chunks that say nothing, of which a file may hold a hundred million.
TEST_F(GltfStreaming, ManyChunksAreSkipped) {
    Bytes bytes = square().glb();
    for (int i = 0; i < 2000; ++i) {
        bytes.insert(bytes.end(), {0, 0, 0, 0, 'A', 'B', 'C', 'D'});
    }
    const auto setSize = [&] {
        const auto size = static_cast<std::uint32_t>(bytes.size());
        std::memcpy(bytes.data() + 8, &size, sizeof(size));
    };
    setSize();
    EXPECT_EQ(refusal(write("a.glb", bytes)), "loaded");
    bytes.resize(bytes.size() - 1);
    setSize();
    EXPECT_EQ(refusal(write("a.glb", bytes)), "GLB chunk 2001 is cut off");
}

} // namespace
} // namespace cdr::scene::test
