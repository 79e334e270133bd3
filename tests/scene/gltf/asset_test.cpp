#include "fixture.h"

#include <cmath>
#include <set>

namespace cdr::scene::test {
namespace {

namespace fs = std::filesystem;

class RealAsset : public testing::Test {
  protected:
    /// Loads an asset, or skips the test and returns nothing where the shared folder is absent.
    static std::optional<GltfImport> load(const std::string& name) {
        const fs::path path = fs::path(CDR_ASSETS_DIR) / name;
        if (!fs::exists(path)) {
            return {};
        }
        return loadGltf(path);
    }
};

/// What holds for every scene the importer returns.
void expectSound(const Scene& scene) {
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        ASSERT_LT(scene.instances.mesh[i], scene.meshes.size());
        ASSERT_LT(scene.instances.material[i], scene.materials.size());
        ASSERT_LT(scene.instances.object[i], scene.objectNames.size());
    }
    for (const Mesh& mesh : scene.meshes) {
        ASSERT_EQ(mesh.indices.size() % 3, 0u);
        double farthest = 0.0;
        for (const Vertex& vertex : mesh.vertices) {
            farthest = std::max(farthest, glm::length(glm::dvec3(vertex.position)));
            ASSERT_NEAR(glm::length(vertex.normal), 1.0f, 1e-4f);
        }
        ASSERT_GE(static_cast<double>(mesh.boundingRadius), farthest);
        ASSERT_LE(static_cast<double>(mesh.boundingRadius), farthest * 1.000001);
        for (const std::uint32_t index : mesh.indices) {
            ASSERT_LT(index, mesh.vertices.size());
        }
    }
}

std::size_t triangles(const Scene& scene) {
    std::size_t count = 0;
    for (const std::uint32_t mesh : scene.instances.mesh) {
        count += scene.meshes[mesh].indices.size() / 3;
    }
    return count;
}

TEST_F(RealAsset, RetroUfo) {
    const std::optional<GltfImport> asset = load("retro_ufo.glb");
    if (!asset) {
        GTEST_SKIP() << "retro_ufo.glb is absent from " << CDR_ASSETS_DIR;
    }
    expectSound(asset->scene);
    EXPECT_EQ(asset->scene.objectNames.size(), 77u);
    EXPECT_EQ(asset->scene.objectNames[0], "Cylinder02");
    EXPECT_EQ(asset->scene.materials.size(), 7u);
    EXPECT_EQ(asset->scene.instances.size(), 77u);
}

TEST_F(RealAsset, CesiumMan) {
    const std::optional<GltfImport> asset = load("cesium_man.glb");
    if (!asset) {
        GTEST_SKIP() << "cesium_man.glb is absent from " << CDR_ASSETS_DIR;
    }
    expectSound(asset->scene);
    EXPECT_EQ(asset->scene.objectNames, (std::vector<std::string>{"Cesium_Man"}));
    EXPECT_EQ(asset->scene.textures.size(), 1u);
    EXPECT_EQ(triangles(asset->scene), 4672u);
    // He stands about 1.5 m high, y up.
    EXPECT_NEAR(asset->scene.instances.position(0).y, 0.75, 0.15);
    EXPECT_TRUE(anySays(asset->ignored, "skins are not applied, their meshes stand where their nodes do"));
    EXPECT_TRUE(anySays(asset->ignored, "animations are not played"));
}

TEST_F(RealAsset, FlightHelmet) {
    const std::optional<GltfImport> asset = load("flight_helmet/flight_helmet.gltf");
    if (!asset) {
        GTEST_SKIP() << "flight_helmet is absent from " << CDR_ASSETS_DIR;
    }
    expectSound(asset->scene);
    EXPECT_EQ(asset->scene.objectNames.size(), 5u);
    EXPECT_EQ(asset->scene.textures.size(), 5u);
    const std::set<std::uint32_t> textures = [&] {
        std::set<std::uint32_t> used;
        for (const Material& material : asset->scene.materials) {
            used.insert(material.baseColorTexture.value_or(99));
        }
        return used;
    }();
    EXPECT_EQ(textures, (std::set<std::uint32_t>{0, 1, 2, 3, 4}));
}

} // namespace
} // namespace cdr::scene::test
