#include "fixture.h"

#include <cdr/scene/gltf/import_progress.h>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <utility>

namespace cdr::scene::test {
namespace {

class GltfLargeFile : public GltfFolder {
  protected:
    static constexpr std::uint32_t kSide = 600; ///< vertices along a side of a mesh

    /// A GLB of so many flat meshes with normals, texture coordinates and indices, written piece by piece.
    std::filesystem::path writeMeshes(std::size_t meshes) const {
        std::vector<float> positions;
        std::vector<float> normals;
        std::vector<float> uvs;
        std::vector<std::uint32_t> indices;
        for (std::uint32_t y = 0; y < kSide; ++y) {
            for (std::uint32_t x = 0; x < kSide; ++x) {
                positions.insert(positions.end(),
                                 {static_cast<float>(x) / kSide, static_cast<float>(y) / kSide, 0});
                normals.insert(normals.end(), {0, 0, 1});
                uvs.insert(uvs.end(), {0, 0});
                if (x + 1 < kSide && y + 1 < kSide) {
                    const std::uint32_t a = y * kSide + x;
                    indices.insert(indices.end(), {a, a + 1, a + kSide + 1, a, a + kSide + 1, a + kSide});
                }
            }
        }
        const std::size_t vertices = std::size_t{kSide} * kSide;
        json root = {{"asset", {{"version", "2.0"}}}, {"scenes", {{{"nodes", json::array()}}}}, {"scene", 0}};
        std::size_t offset = 0;
        const auto accessor = [&](std::size_t bytes, std::size_t count, const char* type, int component) {
            root["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", offset}, {"byteLength", bytes}});
            offset += bytes;
            root["accessors"].push_back({{"bufferView", root["bufferViews"].size() - 1},
                                         {"componentType", component},
                                         {"count", count},
                                         {"type", type}});
            return root["accessors"].size() - 1;
        };
        for (std::size_t i = 0; i < meshes; ++i) {
            json attributes;
            attributes["POSITION"] = accessor(12 * vertices, vertices, "VEC3", kFloat);
            attributes["NORMAL"] = accessor(12 * vertices, vertices, "VEC3", kFloat);
            attributes["TEXCOORD_0"] = accessor(8 * vertices, vertices, "VEC2", kFloat);
            const std::size_t index = accessor(4 * indices.size(), indices.size(), "SCALAR", kUInt);
            root["meshes"].push_back({{"primitives", {{{"attributes", attributes}, {"indices", index}}}}});
            root["nodes"].push_back({{"mesh", i}});
            root["scenes"][0]["nodes"].push_back(i);
        }
        root["buffers"] = {{{"byteLength", offset}}};
        std::string text = root.dump();
        text.resize((text.size() + 3) / 4 * 4, ' ');
        const std::filesystem::path path = folder() / "large.glb";
        std::ofstream file(path, std::ios::binary);
        const auto put = [&](const auto& values) {
            file.write(reinterpret_cast<const char*>(values.data()),
                       static_cast<std::streamsize>(values.size() * sizeof(values[0])));
        };
        const auto size = [](std::size_t bytes) { return static_cast<std::uint32_t>(bytes); };
        put(std::vector<std::uint32_t>{0x46546c67, 2, size(12 + 8 + text.size() + 8 + offset),
                                       size(text.size()), 0x4e4f534a});
        put(text);
        put(std::vector<std::uint32_t>{size(offset), 0x004e4942});
        for (std::size_t i = 0; i < meshes; ++i) {
            put(positions);
            put(normals);
            put(uvs);
            put(indices);
        }
        return path;
    }

    /// Bytes that a process has in memory at most, that does this and no more.
    template <typename Work>
    static double peakBytes(const Work& work) {
        const pid_t child = fork();
        if (child == 0) {
            work();
            _exit(0);
        }
        int status = 0;
        rusage usage{};
        EXPECT_EQ(wait4(child, &status, 0, &usage), child);
        EXPECT_EQ(status, 0);
        return 1024.0 * static_cast<double>(usage.ru_maxrss);
    }
};

/// What is imported takes about as much as the file, of which no more than some blocks are in memory. CDR_ALL_CASES does it
/// with a file of nearly 1 GiB.
TEST_F(GltfLargeFile, IsNotInMemoryBesideItsScene) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "a sanitizer keeps what is freed";
#endif
    const std::filesystem::path path = writeMeshes(std::getenv("CDR_ALL_CASES") != nullptr ? 53 : 5);
    const auto bytes = static_cast<double>(std::filesystem::file_size(path));
    const double before = peakBytes([] {});
    const double peak = peakBytes([&] { loadGltf(path); }) - before;
    std::size_t sceneBytes = 0;
    {
        const GltfImport import = loadGltf(path);
        for (const Mesh& mesh : import.scene.meshes) {
            sceneBytes += mesh.vertices.size() * sizeof(Vertex) + mesh.indices.size() * sizeof(std::uint32_t);
        }
    }
    constexpr double kMiB = 1 << 20;
    std::cout << "a file of " << bytes / kMiB << " MiB takes " << peak / bytes
              << " times as much at its peak, the scene alone " << static_cast<double>(sceneBytes) / bytes
              << ", the rest is " << (peak - static_cast<double>(sceneBytes)) / kMiB << " MiB\n";
    // Passing tables of one mesh, and blocks of the file.
    EXPECT_LE(peak, static_cast<double>(sceneBytes) + 64.0 * kMiB);
    // What is foretold is about the peak. It leaves out the blocks.
    constexpr double kBlocks = 40.0 * kMiB;
    GltfLimits limits;
    limits.maxBytes = static_cast<std::uint64_t>(peak - kBlocks);
    expectSays(refusal(path, limits), "the import would take ");
    limits.maxBytes = static_cast<std::uint64_t>(peak + kBlocks);
    EXPECT_EQ(refusal(path, limits), "loaded");
}

TEST_F(GltfLargeFile, TellsHowFarItIs) {
    Document document = square();
    for (int i = 1; i < 250; ++i) {
        document.root["nodes"].push_back({{"mesh", 0}});
        document.root["scenes"][0]["nodes"].push_back(i);
    }
    std::vector<std::pair<std::size_t, std::size_t>> told;
    const OpenedScene opened =
        openGltf(write("a.glb", document.glb()), {},
                 [&](std::size_t done, std::size_t all) { told.emplace_back(done, all); });
    EXPECT_EQ(opened.setup.scene.instances.size(), 250u);
    ASSERT_GT(told.size(), 50u);
    EXPECT_LT(told.size(), 150u);
    for (std::size_t i = 0; i < told.size(); ++i) {
        EXPECT_EQ(told[i].second, 251u);
        EXPECT_TRUE(i == 0 ? told[i].first == 0 : told[i].first > told[i - 1].first);
    }
    EXPECT_EQ(told.back().first, 250u);
}

} // namespace
} // namespace cdr::scene::test
