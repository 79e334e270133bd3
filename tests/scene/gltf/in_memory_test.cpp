#include "../../support/refusal.h"
#include "fixture.h"

#include <cdr/platform/worker_pool.h>
#include <cdr/scene/animation/scene_animation.h>
#include <cdr/scene/gltf/open_gltf.h>

#include <filesystem>
#include <iterator>
#include <span>

namespace cdr::scene::test {
namespace {

std::vector<char> contentOf(const std::string& asset) {
    std::ifstream file(CDR_SOURCE_DIR "/tests/assets/" + asset, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::string refusalOf(const std::vector<char>& content, const std::string& name) {
    return cdr::test::inputErrorOf([&] { openGltf(std::as_bytes(std::span(content)), name); }, "none");
}

/// With textures, with lines, and with what moves: the latter must not refer to the bytes once they are imported.
TEST(GltfInMemory, IsTheSceneOfItsFile) {
    for (const std::string asset : {"materials.glb", "survey.glb", "machine.glb"}) {
        GltfChoice choice;
        if (asset == "machine.glb") {
            choice.animation = "work";
            choice.framesPerSecond = 10.0;
        }
        OpenedScene wanted = openGltf(CDR_SOURCE_DIR "/tests/assets/" + asset, choice);
        std::vector<char> content = contentOf(asset);
        OpenedScene opened = openGltf(std::as_bytes(std::span(content)), asset, choice);
        std::fill(content.begin(), content.end(), 'x');
        const Scene& scene = opened.setup.scene;
        EXPECT_EQ(scene.name, std::filesystem::path(asset).stem().string());
        EXPECT_EQ(scene.objectNames, wanted.setup.scene.objectNames);
        EXPECT_EQ(opened.notes, wanted.notes);
        ASSERT_EQ(scene.textures.size(), wanted.setup.scene.textures.size());
        for (std::size_t i = 0; i < scene.textures.size(); ++i) {
            EXPECT_EQ(scene.textures[i].pixels, wanted.setup.scene.textures[i].pixels) << asset << " " << i;
        }
        platform::WorkerPool workers(1);
        show(opened.setup.scene, opened.setup.motion, 7, workers);
        show(wanted.setup.scene, wanted.setup.motion, 7, workers);
        ASSERT_EQ(scene.meshes.size(), wanted.setup.scene.meshes.size());
        for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
            EXPECT_EQ(scene.meshes[i].indices, wanted.setup.scene.meshes[i].indices) << asset << " " << i;
            EXPECT_TRUE(std::equal(
                scene.meshes[i].vertices.begin(), scene.meshes[i].vertices.end(),
                wanted.setup.scene.meshes[i].vertices.begin(), wanted.setup.scene.meshes[i].vertices.end(),
                [](const Vertex& a, const Vertex& b) { return a.position == b.position; }));
        }
    }
}

/// Not even a file that lies where the program runs.
TEST(GltfInMemory, MayReferToNoFile) {
    const std::filesystem::path before = std::filesystem::current_path();
    std::filesystem::current_path(CDR_SOURCE_DIR "/tests/assets");
    const std::string refusal = refusalOf(contentOf("well.gltf"), "part of an archive.gltf");
    std::filesystem::current_path(before);
    EXPECT_EQ(
        refusal,
        "part of an archive.gltf: URI 'well.bin' names a file, and beside bytes in memory there is none");
}

TEST(GltfInMemory, IsRefusedByItsName) {
    EXPECT_EQ(refusalOf({}, "empty").rfind("empty: ", 0), 0u) << refusalOf({}, "empty");
    EXPECT_EQ(refusalOf({'g', 'l', 'T', 'F'}, "a\nb").rfind("a b: ", 0), 0u)
        << refusalOf({'g', 'l', 'T', 'F'}, "a\nb");
    const Bytes bytes = square().glb();
    GltfLimits limits;
    limits.maxFileBytes = bytes.size() - 1;
    EXPECT_THROW(loadGltf(std::as_bytes(std::span(bytes)), "large", limits), base::InputError);
    limits.maxFileBytes = bytes.size();
    EXPECT_EQ(loadGltf(std::as_bytes(std::span(bytes)), "large", limits).scene.instances.size(), 1u);
}

} // namespace
} // namespace cdr::scene::test
