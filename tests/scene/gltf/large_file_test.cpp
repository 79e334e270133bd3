#include "fixture.h"

#include <cdr/scene/gltf/import_progress.h>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <utility>

namespace cdr::scene::test {
namespace {

class GltfLargeFile : public GltfFolder {
  protected:
    static constexpr double kMiB = 1 << 20;

    /// What opening a file takes, in bytes.
    struct Memory {
        double file = 0.0;
        double peak = 0.0;
        double scene = 0.0; ///< of these, its vertices and indices
    };

    /// A GLB of so many flat meshes with normals, texture coordinates and indices, written piece by piece.
    /// @param side vertices along a side of each
    std::filesystem::path writeMeshes(std::size_t meshes, std::uint32_t side) const {
        std::vector<float> positions;
        std::vector<float> normals;
        std::vector<float> uvs;
        std::vector<std::uint32_t> indices;
        const float step = 1.0f / static_cast<float>(side);
        for (std::uint32_t y = 0; y < side; ++y) {
            for (std::uint32_t x = 0; x < side; ++x) {
                positions.insert(positions.end(),
                                 {static_cast<float>(x) * step, static_cast<float>(y) * step, 0});
                normals.insert(normals.end(), {0, 0, 1});
                uvs.insert(uvs.end(), {0, 0});
                if (x + 1 < side && y + 1 < side) {
                    const std::uint32_t a = y * side + x;
                    indices.insert(indices.end(), {a, a + 1, a + side + 1, a, a + side + 1, a + side});
                }
            }
        }
        const std::size_t vertices = std::size_t{side} * side;
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

    /// Expects beside the scene no more than blocks of the file, and passing tables of the vertices of a mesh.
    Memory memoryOf(const std::filesystem::path& path) const {
        Memory memory{.file = static_cast<double>(std::filesystem::file_size(path))};
        const double before = peakBytes([] {});
        memory.peak = peakBytes([&] { loadGltf(path); }) - before;
        const GltfImport import = loadGltf(path);
        std::size_t mostVertices = 0;
        for (const Mesh& mesh : import.scene.meshes) {
            mostVertices = std::max(mostVertices, mesh.vertices.size());
            memory.scene += static_cast<double>(mesh.vertices.size() * sizeof(Vertex) +
                                                mesh.indices.size() * sizeof(std::uint32_t));
        }
        std::cout << "a file of " << memory.file / kMiB << " MiB takes " << memory.peak / memory.file
                  << " times as much at its peak, the scene alone " << memory.scene / memory.file
                  << ", the rest is " << (memory.peak - memory.scene) / kMiB << " MiB\n";
        constexpr std::size_t kTablesBytes = 5 * sizeof(std::uint32_t); // of a vertex
        EXPECT_LE(memory.peak, memory.scene + 40.0 * kMiB + static_cast<double>(kTablesBytes * mostVertices));
        return memory;
    }
};

/// Nor is its one mesh, which is most of the scene, there twice. CDR_ALL_CASES does it with a mesh of a third of a GiB.
TEST_F(GltfLargeFile, OfOneMeshIsNotInMemoryBesideItsScene) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "a sanitizer keeps what is freed";
#endif
    memoryOf(writeMeshes(1, std::getenv("CDR_ALL_CASES") != nullptr ? 2450 : 1350));
}

/// What is imported takes about as much as the file, of which no more than some blocks are in memory. CDR_ALL_CASES does it
/// with a file of nearly 1 GiB.
TEST_F(GltfLargeFile, IsNotInMemoryBesideItsScene) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "a sanitizer keeps what is freed";
#endif
    const std::filesystem::path path = writeMeshes(std::getenv("CDR_ALL_CASES") != nullptr ? 53 : 5, 600);
    const double peak = memoryOf(path).peak;
    // The prediction is about the peak. It leaves out the blocks.
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
        EXPECT_EQ(told[i].second, told[0].second);
        EXPECT_TRUE(i == 0 ? told[i].first == 0 : told[i].first > told[i - 1].first);
    }
    EXPECT_GT(told[0].second, 250u); // its nodes, and what is read
    EXPECT_EQ(told.back().first, told[0].second);
}

} // namespace
} // namespace cdr::scene::test
