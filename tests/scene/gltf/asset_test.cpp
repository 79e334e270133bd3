#include "fixture.h"

#include <algorithm>
#include <set>

namespace cdr::scene::test {
namespace {

namespace fs = std::filesystem;

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

const fs::path kOwn = fs::path(CDR_SOURCE_DIR) / "tests" / "assets";
const fs::path kShared = CDR_ASSETS_DIR;

TEST(GltfAsset, TheGardenIsWhatItsScriptMade) {
    const GltfImport garden = loadGltf(kOwn / "garden.glb");
    const Scene& scene = garden.scene;
    expectSound(scene);
    EXPECT_EQ(scene.objectNames.size(), 41u);
    EXPECT_EQ(scene.objectNames[1], "trunk");
    EXPECT_EQ(triangles(scene), 1540u);
    EXPECT_EQ(scene.textures.size(), 2u);
    const auto count = [&scene](AlphaMode mode) {
        return std::count_if(scene.materials.begin(), scene.materials.end(),
                             [mode](const Material& material) { return material.alphaMode == mode; });
    };
    EXPECT_EQ(count(AlphaMode::opaque), 4);
    EXPECT_EQ(count(AlphaMode::mask), 1);
    EXPECT_EQ(count(AlphaMode::blend), 2);
    ASSERT_EQ(garden.cameras.size(), 1u);
    EXPECT_EQ(garden.cameras[0].name, "gate");
    EXPECT_TRUE(garden.ignored.empty());
}

TEST(GltfAsset, TheWellIsReadFromThreeFiles) {
    const GltfImport well = loadGltf(kOwn / "well.gltf");
    expectSound(well.scene);
    EXPECT_EQ(well.scene.objectNames.size(), 8u);
    EXPECT_EQ(triangles(well.scene), 208u);
    ASSERT_EQ(well.scene.textures.size(), 1u);
    EXPECT_EQ(well.scene.textures[0].pixels.width, 128u);
    EXPECT_TRUE(well.ignored.empty());
}

TEST(GltfAsset, TheSurveyIsPointsAndLinesOfEveryMode) {
    const GltfImport survey = loadGltf(kOwn / "survey.glb");
    expectSound(survey.scene);
    EXPECT_EQ(survey.scene.objectNames,
              (std::vector<std::string>{"plate", "hill", "border", "dome", "fence", "flight"}));
    // A box; 900 and 153 points; segments of a loop, a list and a strip.
    EXPECT_EQ(triangles(survey.scene), 12u + 8u * (900 + 153 + 4 + 17 + 96));
    EXPECT_TRUE(survey.ignored.empty());
}

TEST(GltfAsset, TheVeilsAreBlendedAndBend) {
    const GltfImport veils = loadGltf(kOwn / "veils.glb");
    expectSound(veils.scene);
    ASSERT_NE(veils.animation, nullptr);
    EXPECT_EQ(veils.animation->animations.size(), 2u);
    EXPECT_EQ(veils.animation->deformed.size(), 2u); // the curtain and the bubble
    EXPECT_EQ(std::count_if(veils.scene.materials.begin(), veils.scene.materials.end(),
                            [](const Material& material) { return material.alphaMode == AlphaMode::blend; }),
              2);
    EXPECT_TRUE(veils.ignored.empty());
}

TEST(GltfAsset, LargerModelsOfOthersLoad) {
    if (!fs::exists(kShared)) {
        GTEST_SKIP() << "no larger models in " << kShared;
    }
    const GltfImport ufo = loadGltf(kShared / "retro_ufo.glb");
    expectSound(ufo.scene);
    EXPECT_EQ(ufo.scene.objectNames.size(), 77u);
    EXPECT_EQ(ufo.scene.objectNames[0], "Cylinder02");
    EXPECT_EQ(ufo.scene.materials.size(), 7u);
    EXPECT_EQ(ufo.scene.instances.size(), 77u);

    const GltfImport man = loadGltf(kShared / "cesium_man.glb");
    expectSound(man.scene);
    EXPECT_EQ(man.scene.objectNames, (std::vector<std::string>{"Cesium_Man"}));
    EXPECT_EQ(man.scene.textures.size(), 1u);
    EXPECT_EQ(triangles(man.scene), 4672u);
    // He stands about 1.5 m high, y up.
    EXPECT_NEAR(man.scene.instances.position(0).y, 0.75, 0.15);
    ASSERT_NE(man.animation, nullptr);
    EXPECT_EQ(man.animation->animations.size(), 1u);
    EXPECT_EQ(man.animation->deformed.size(), 1u);

    const GltfImport helmet = loadGltf(kShared / "flight_helmet" / "flight_helmet.gltf");
    expectSound(helmet.scene);
    EXPECT_EQ(helmet.scene.objectNames.size(), 5u);
    EXPECT_EQ(helmet.scene.textures.size(), 5u);
    std::set<std::uint32_t> textures;
    for (const Material& material : helmet.scene.materials) {
        textures.insert(material.baseColorTexture.value_or(99));
    }
    EXPECT_EQ(textures, (std::set<std::uint32_t>{0, 1, 2, 3, 4}));
}

} // namespace
} // namespace cdr::scene::test
