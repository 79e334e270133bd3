#include "rank_test.h"

#include <cdr/image/codec.h>
#include <cdr/platform/file.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

namespace cdr::cli_test {
namespace {

using Json = nlohmann::json;

constexpr int kSquares = 8;

/// Squares of growing size and distance, each with a texture of 36 MiB and alone in its cascade.
void writeTexturedSquares(const std::filesystem::path& folder) {
    const std::filesystem::path picture = folder / "texture.png";
    platform::writeFile(picture,
                        image::encodeImage(picture, image::ImageRgba8(4096, 2304, {90, 160, 40, 255})));
    const std::vector<float> corners{-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0};
    const std::vector<float> uv{0, 1, 1, 1, 1, 0, 0, 0};
    const std::vector<std::uint32_t> indices{0, 1, 2, 0, 2, 3};
    platform::Bytes bytes;
    const auto append = [&](const auto& values) {
        const auto* begin = reinterpret_cast<const std::uint8_t*>(values.data());
        bytes.insert(bytes.end(), begin, begin + values.size() * 4);
    };
    append(corners);
    append(uv);
    append(indices);
    platform::writeFile(folder / "squares.bin", bytes);
    Json gltf{{"asset", {{"version", "2.0"}}},
              {"buffers", {{{"uri", "squares.bin"}, {"byteLength", bytes.size()}}}},
              {"bufferViews",
               {{{"buffer", 0}, {"byteOffset", 0}, {"byteLength", 48}},
                {{"buffer", 0}, {"byteOffset", 48}, {"byteLength", 32}},
                {{"buffer", 0}, {"byteOffset", 80}, {"byteLength", 24}}}},
              {"accessors",
               {{{"bufferView", 0},
                 {"componentType", 5126},
                 {"count", 4},
                 {"type", "VEC3"},
                 {"min", {-1, -1, 0}},
                 {"max", {1, 1, 0}}},
                {{"bufferView", 1}, {"componentType", 5126}, {"count", 4}, {"type", "VEC2"}},
                {{"bufferView", 2}, {"componentType", 5125}, {"count", 6}, {"type", "SCALAR"}}}}};
    for (int i = 0; i < kSquares; ++i) {
        const double size = std::pow(4.0, i);
        gltf["images"].push_back({{"uri", "texture.png"}});
        gltf["textures"].push_back({{"source", i}});
        gltf["materials"].push_back({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", i}}}}}});
        gltf["meshes"].push_back(
            {{"primitives",
              {{{"attributes", {{"POSITION", 0}, {"TEXCOORD_0", 1}}}, {"indices", 2}, {"material", i}}}}});
        gltf["nodes"].push_back({{"mesh", i},
                                 {"translation", {(i - 3.5) * 0.5 * size, 0, -10.0 * size}},
                                 {"scale", {size, size, size}}});
        gltf["scenes"][0]["nodes"].push_back(i);
    }
    platform::writeText(folder / "squares.gltf", gltf.dump());
}

using CascadeMemory = RankTest;

/// Under a limit of the address space that one process exceeds, four ranks draw its picture.
TEST_F(CascadeMemory, ARankHoldsWhatItsCascadesTouch) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "a sanitizer takes terabytes of the address space";
#endif
    if (deviceInfo().kind != gpu::DeviceKind::cpu) {
        GTEST_SKIP() << "textures lie on the device, and its driver reserves more addresses than any limit";
    }
    writeTexturedSquares(folder());
    const std::string render =
        "render squares.gltf --depth anchored --split count:8 --size 320x180 --eye 0,0,0 "
        "--target 0,0,-1 --fov 40 --near 5 --far 327680 --hash --ranks cascades -o ";
    // The launcher's ranks share a machine, so lavapipe draws with one thread in each; here too. For each thread that finds
    // the heap in use, which depends on the load, glibc would reserve 64 MiB of addresses more.
    const auto limited = [](long megabytes) {
        return "LP_NUM_THREADS=1 MALLOC_ARENA_MAX=1 sh -c 'ulimit -v " + std::to_string(megabytes * 1024) +
               "; exec \"$@\"' sh";
    };
    // What a process takes besides textures depends on the machine. So the least limit that suffices is searched for, up or
    // down from what one machine needed.
    constexpr long kStep = 100;
    const std::filesystem::path one = at("one.png");
    std::string picture;
    const auto suffices = [&](long limit) {
        const bool isDrawn = run(render + "one.png", limited(limit)).status == 0;
        picture = isDrawn ? readText(one) : picture;
        EXPECT_EQ(std::filesystem::remove(one), isDrawn) << limit << " MiB";
        return isDrawn;
    };
    long limit = 1100;
    const bool isTooMuch = suffices(limit);
    do {
        limit += isTooMuch ? -kStep : kStep;
        ASSERT_TRUE(limit > 600 && limit < 3000);
    } while (suffices(limit) == isTooMuch);
    const long tooLittle = isTooMuch ? limit : limit - kStep;
    const ProgramResult four =
        succeed(render + "four.png", test::launched(CDR_MPIEXEC, 4) + " " + "env " + limited(tooLittle));
    EXPECT_TRUE(!picture.empty() && textIn("four.png") == picture);
    std::printf("one process needs more than %ld MiB of address space, four ranks do not\n", tooLittle);
}

} // namespace
} // namespace cdr::cli_test
