#include "../test_scenes.h"

#include <cdr/measure/compare/wrong_pixels.h>
#include <cdr/measure/truth/mask_cut.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace cdr::test {

namespace {

constexpr std::uint32_t kMasked = 2;
constexpr std::uint32_t kSize = 65;
constexpr std::uint32_t kWall = 1; // ids
constexpr std::uint32_t kDecal = 2;

/// A cube as wall behind another one, which is masked. The sides of both are 1 wide.
scene::Scene sceneBehindMask(std::uint32_t mesh, const scene::Material& masked) {
    scene::Scene scene = makeEmptyScene();
    scene.materials.push_back(masked);
    scene.materials[kMasked].alphaMode = scene::AlphaMode::mask;
    addObject(scene, kCube, {0.0, 0.0, -20.0}, glm::mat3(20.0f));
    addObject(scene, mesh, {0.0, 0.0, -3.0}, glm::mat3(1.0f), kMasked);
    return scene;
}

/// The left half of the side that faces the camera is clear.
void cutLeftHalf(scene::Scene& scene) {
    scene::Texture texture{.name = "halves", .pixels = image::ImageRgba8(2, 1, {255, 255, 255, 255})};
    texture.pixels.at(0, 0)[3] = 0;
    texture.magFilter = scene::Filter::nearest;
    scene.textures.push_back(texture);
    scene.materials[kMasked].baseColorTexture = 0;
    for (scene::Mesh& mesh : scene.meshes) {
        for (scene::Vertex& vertex : mesh.vertices) {
            vertex.uv = glm::vec2(vertex.position) + 0.5f;
        }
    }
}

std::size_t shown(const measure::TruthImage& truth, std::uint32_t id) {
    return static_cast<std::size_t>(std::ranges::count_if(
        truth.pixels, [&](const measure::TruthPixel& pixel) { return pixel.id == id; }));
}

/// False where nothing in view is masked.
bool isDoubtful(const measure::TruthImage& truth, std::uint32_t x, std::uint32_t y) {
    return !truth.doubtful.pixels.empty() && truth.doubtful.at(x, y) != 0;
}

} // namespace

TEST(MaskedTruth, WhatIsCutAwayIsNotSeen) {
    // The box without a tree of triangles, and the same with one.
    for (const std::uint32_t mesh : {kCube, kTriangleCube}) {
        scene::Scene scene = sceneBehindMask(mesh, {});
        cutLeftHalf(scene);
        const measure::TruthImage truth = cast(scene, makePlainCamera(), kSize, kSize);
        const std::uint32_t middle = kSize / 2;
        EXPECT_EQ(truth.at(middle - 4, middle).id, kWall) << mesh;
        EXPECT_EQ(truth.at(middle - 4, middle).secondId, 0u) << "nothing lies in one plane with the wall";
        EXPECT_EQ(truth.at(middle + 4, middle).id, kDecal) << mesh;
        EXPECT_EQ(truth.at(middle + 4, middle).secondId, kWall) << mesh;
        EXPECT_FALSE(isDoubtful(truth, middle - 4, middle)) << mesh;
        EXPECT_FALSE(isDoubtful(truth, middle + 4, middle)) << mesh;
    }
}

/// Other sides of the box and other triangles of the tree are behind what is cut away.
TEST(MaskedTruth, WhatLiesBehindACutIsSeen) {
    scene::Scene scene = sceneBehindMask(kTriangleCube, {.doubleSided = true});
    cutLeftHalf(scene);
    const measure::TruthImage whole =
        cast(sceneBehindMask(kTriangleCube, {}), makePlainCamera(), kSize, kSize);
    const measure::TruthImage truth = cast(scene, makePlainCamera(), kSize, kSize);
    const std::size_t all = shown(whole, kDecal);
    EXPECT_GT(all, 200u);
    EXPECT_GT(shown(truth, kDecal), all * 4 / 10);
    EXPECT_LT(shown(truth, kDecal), all * 6 / 10);
}

/// There the filter decides: such pixels are neither right nor wrong.
TEST(MaskedTruth, AlphaNearTheCutoffIsDoubtful) {
    struct Case {
        float alpha;
        bool isSeen;
        bool isDoubtful;
    };
    for (const Case& each : {Case{0.2f, false, false}, Case{0.495f, false, true}, Case{0.5f, true, true},
                             Case{0.8f, true, false}}) {
        const scene::Scene scene =
            sceneBehindMask(kCube, {.baseColorFactor = glm::vec4(1.0f, 1.0f, 1.0f, each.alpha)});
        const measure::TruthImage truth = cast(scene, makePlainCamera(), kSize, kSize);
        const std::uint32_t middle = kSize / 2;
        EXPECT_EQ(truth.at(middle, middle).id, each.isSeen ? kDecal : kWall) << each.alpha;
        EXPECT_EQ(isDoubtful(truth, middle, middle), each.isDoubtful) << each.alpha;
        EXPECT_EQ(measure::innerMask(truth).at(middle, middle) != 0, !each.isDoubtful) << each.alpha;
    }
}

/// Rays along a triangle have such weights.
TEST(MaskedTruth, AnAlphaThatIsNotFiniteIsDoubtful) {
    const scene::Scene scene = sceneBehindMask(kTriangleCube, {});
    const measure::TruthTextures textures(scene);
    const glm::dvec3 middle(1.0 / 3.0);
    const auto cutOf = [&](const measure::CornerWeights& weights) {
        return measure::maskCutAt(
            {scene, textures, scene.materials[kMasked], scene.meshes[kTriangleCube], 0, weights});
    };
    EXPECT_FALSE(cutOf({middle, middle, middle, middle, middle}).isDoubtful);
    for (const double endless :
         {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
        const glm::dvec3 beyond(endless);
        EXPECT_TRUE(cutOf({beyond, middle, middle, middle, middle}).isDoubtful);
        EXPECT_TRUE(cutOf({middle, beyond, middle, middle, middle}).isDoubtful);
        EXPECT_TRUE(cutOf({middle, middle, middle, middle, beyond}).isDoubtful);
    }
}

TEST(MaskedTruth, ACutoffOfZeroCutsNothing) {
    const scene::Scene scene =
        sceneBehindMask(kCube, {.baseColorFactor = glm::vec4(0.0f), .alphaCutoff = 0.0f});
    const measure::TruthImage truth = cast(scene, makePlainCamera(), kSize, kSize);
    EXPECT_EQ(truth.at(kSize / 2, kSize / 2).id, kDecal);
    EXPECT_FALSE(isDoubtful(truth, kSize / 2, kSize / 2));
}

/// Behind what is surely seen a doubtful surface changes nothing.
TEST(MaskedTruth, DoubtBehindTheNearestDoesNotCount) {
    scene::Scene scene = sceneBehindMask(kCube, {.baseColorFactor = glm::vec4(0.5f)});
    addObject(scene, kCube, {0.0, 0.0, -2.0}, glm::mat3(0.25f));
    const measure::TruthImage truth = cast(scene, makePlainCamera(), kSize, kSize);
    EXPECT_EQ(truth.at(kSize / 2, kSize / 2).id, 3u);
    EXPECT_FALSE(isDoubtful(truth, kSize / 2, kSize / 2));
    EXPECT_EQ(cast(makeEmptyScene(), makePlainCamera(), 3, 3).doubtful.pixels.size(), 0u)
        << "nothing is masked";
}

} // namespace cdr::test
