#include "../../support/all_cases.h"
#include "../test_scenes.h"
#include "drawn_by_rays.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <vector>

namespace cdr::test {
namespace {

using measure::Certificate;
using measure::DrawnFrame;

constexpr std::uint32_t kFadingMaterial = 2;
constexpr std::uint32_t kWallId = 1;
constexpr std::uint32_t kFadingId = 2;

/// A wall behind a smaller cube, whose alpha grows from left to right and is cut at a half.
scene::Scene fadingCubeBeforeWall() {
    scene::Scene scene = makeEmptyScene();
    scene::Texture texture{.name = "ramp", .pixels = image::ImageRgba8(2, 1, {255, 255, 255, 255})};
    texture.pixels.at(0, 0)[3] = 0;
    scene.textures.push_back(texture);
    scene.materials.push_back({.name = "fading", .baseColorTexture = 0});
    scene.materials[kFadingMaterial].alphaMode = scene::AlphaMode::mask;
    for (scene::Mesh& mesh : scene.meshes) {
        for (scene::Vertex& vertex : mesh.vertices) {
            vertex.uv = 0.5f * glm::vec2(vertex.position) + 0.5f;
        }
    }
    addObject(scene, kCube, {0.0, 0.0, -40.0}, glm::mat3(40.0f));
    addObject(scene, kTriangleCube, {0.0, 0.0, -4.0}, glm::mat3(1.0f), kFadingMaterial);
    return scene;
}

TEST(MaskedCertifier, ProvesWhatAMaskKeepsAndWhatItCuts) {
    const scene::Scene scene = fadingCubeBeforeWall();
    const DrawnFrame frame = drawnByRays(scene, makePlainCamera(), kEightBits);
    const Certificate certificate = certified(scene, frame);
    EXPECT_EQ(certificate.refused, 0u);
    EXPECT_EQ(certificate.wrong, 0u);
    EXPECT_GT(shownBy(frame, kFadingId), 100u);
    EXPECT_GT(certificate.proven, shownBy(frame, kFadingId) + 100)
        << "what is seen through holes is proven too";
    EXPECT_LT(certificate.castMasked, shownBy(frame, kFadingId) / 100);
    EXPECT_EQ(certificate.certified + certificate.cast, certificate.pixels);
}

/// A square, of which one half is kept and the other cut away. The line between them passes so near to centres of pixels that
/// roundings decide which half their rays meet.
TEST(MaskedCertifier, ProvesNothingWhereAnEdgeDecidesWhichHalfIsMet) {
    scene::Scene scene = fadingCubeBeforeWall();
    scene::Mesh& square = scene.meshes[kTriangleCube];
    const auto corner = [](float x, float y, float u) {
        return scene::Vertex{.position = {x, y, 0.0f}, .normal = {0.0f, 0.0f, 1.0f}, .uv = {u, 0.5f}};
    };
    constexpr float kKept = 0.75f;
    constexpr float kCut = 0.25f;
    square.vertices = {corner(-1, -1, kKept), corner(1, -1, kKept), corner(1, 1, kKept),
                       corner(-1, -1, kCut),  corner(1, 1, kCut),   corner(-1, 1, kCut)};
    square.indices = {0, 1, 2, 3, 4, 5};
    std::vector<std::uint64_t> shown;
    for (const double aside : {-5e-13, 1e-16, 5e-16, 1e-15, 5e-13}) {
        scene::placeInstance(scene, 1, {aside, 0.0, -4.0}, glm::mat3(1.0f));
        const DrawnFrame right = drawnByRays(scene, makePlainCamera(), kEightBits);
        shown.push_back(shownBy(right, kFadingId));
        for (const std::uint32_t id : {kWallId, kFadingId}) {
            DrawnFrame frame = right;
            for (std::uint32_t row = 30; row < 60; ++row) {
                frame.ids.at(124 - row, row) = id;
                frame.distancesView.at(124 - row, row) = id == kWallId ? 20.0 : 4.0;
            }
            const Certificate certificate = certified(scene, frame);
            EXPECT_EQ(certificate.refused, 0u);
            EXPECT_EQ(wrongAfter(scene, frame, certificate), 0u) << aside << ", object " << id;
        }
    }
    EXPECT_GE(std::max(shown.front(), shown.back()), std::min(shown.front(), shown.back()) + 30)
        << "the line misses centres";
}

/// Objects of all kinds, whose masks keep spots of all sizes.
scene::Scene spottedScene(std::uint64_t seed) {
    scene::Scene scene = makeRandomScene(seed, 120, 12.0, {1e5, -2e5, 3e4});
    std::mt19937 random(static_cast<unsigned>(seed));
    constexpr std::array kWraps{scene::WrapMode::repeat, scene::WrapMode::mirroredRepeat,
                                scene::WrapMode::clampToEdge};
    for (std::uint32_t i = 0; i < 2; ++i) {
        scene::Texture texture{.name = "spots",
                               .pixels = image::ImageRgba8(32, 16),
                               .wrapU = kWraps[random() % 3],
                               .wrapV = kWraps[random() % 3],
                               .alphaWeighs = true,
                               .cutoff = 0.5f};
        for (image::Rgba8& texel : texture.pixels.pixels) {
            texel = {255, 255, 255, static_cast<std::uint8_t>(random())};
        }
        scene.textures.push_back(texture);
        scene.materials[i].baseColorTexture = i;
        scene.materials[i].alphaMode = scene::AlphaMode::mask;
    }
    for (scene::Mesh& mesh : scene.meshes) {
        for (scene::Vertex& vertex : mesh.vertices) {
            vertex.uv = 0.7f * glm::vec2(vertex.position) + 0.3f * vertex.position.z;
        }
    }
    return scene;
}

/// What a device does to textures, within what Vulkan allows it and beyond.
struct OtherFilter {
    const char* name;
    void (*apply)(scene::Texture& texture);
};
constexpr std::array kOtherFilters{
    OtherFilter{"the same", [](scene::Texture&) {}},
    OtherFilter{"no levels", [](scene::Texture& texture) { texture.levels = scene::TextureLevels::none; }},
    OtherFilter{"nearest levels",
                [](scene::Texture& texture) { texture.levels = scene::TextureLevels::nearest; }},
    OtherFilter{
        "nearest texels",
        [](scene::Texture& texture) { texture.minFilter = texture.magFilter = scene::Filter::nearest; }},
    OtherFilter{"other levels", [](scene::Texture& texture) { texture.cutoff.reset(); }},
    OtherFilter{"rounded alphas", [](scene::Texture& texture) {
                    for (image::Rgba8& texel : texture.pixels.pixels) {
                        texel[3] &= 0xf0;
                    }
                }}};

TEST(MaskedCertifier, IsRightInEveryPixelHoweverTexturesAreFiltered) {
    const std::uint64_t seeds = takesAllCases() ? 12 : 3;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        const scene::Scene scene = spottedScene(seed);
        std::mt19937_64 random(seed);
        const scene::Camera camera =
            makeCameraAround(random, {1e5, -2e5, 3e4}, seed % 2 == 0 ? 400.0 : 20.0, 14.0);
        for (const OtherFilter& filter : kOtherFilters) {
            SCOPED_TRACE(testing::Message() << filter.name << ", seed " << seed);
            scene::Scene drawn = scene;
            std::ranges::for_each(drawn.textures, filter.apply);
            const DrawnFrame frame = drawnByRays(drawn, camera, kEightBits);
            const Certificate certificate = certified(scene, frame, 1 + seed % 2);
            EXPECT_EQ(certificate.refused, 0u);
            EXPECT_EQ(wrongAfter(scene, frame, certificate), 0u);
            if (&filter == &kOtherFilters[0]) {
                EXPECT_EQ(certificate.wrong, 0u);
                EXPECT_GT(certificate.certifiedFraction(), 0.999);
            } else {
                EXPECT_GT(certificate.wrong, 0u);
            }
        }
    }
}

/// A device that cuts at another alpha, and one that reads other alphas.
TEST(MaskedCertifier, RepairsAllThatIsCutInAnotherWay) {
    const scene::Scene scene = fadingCubeBeforeWall();
    for (const float cutoff : {0.25f, 0.45f, 0.55f, 0.75f}) {
        scene::Scene drawn = scene;
        drawn.materials[kFadingMaterial].alphaCutoff = cutoff;
        const DrawnFrame frame = drawnByRays(drawn, makePlainCamera(), kEightBits);
        const Certificate certificate = certified(scene, frame);
        EXPECT_EQ(certificate.refused, 0u) << cutoff;
        EXPECT_GT(certificate.wrong, 10u) << cutoff;
        EXPECT_GE(certificate.castMasked, certificate.wrong) << cutoff;
        EXPECT_EQ(wrongAfter(scene, frame, certificate), 0u) << cutoff;
    }
    scene::Scene perturbed = scene;
    perturbed.materials[kFadingMaterial].baseColorFactor.a = 0.8f;
    const DrawnFrame frame = drawnByRays(perturbed, makePlainCamera(), kEightBits);
    const Certificate certificate = certified(scene, frame);
    EXPECT_GT(certificate.wrong, 10u);
    EXPECT_EQ(wrongAfter(scene, frame, certificate), 0u);
}

/// Opaque parts are judged as ever, before, behind and beside a mask.
TEST(MaskedCertifier, StillRefusesWhatNoMaskExplains) {
    const scene::Scene scene = fadingCubeBeforeWall();
    const DrawnFrame frame = drawnByRays(scene, makePlainCamera(), kEightBits);
    for (const glm::uvec2 at : {glm::uvec2(30, 30), glm::uvec2(74, 41)}) { // beside the mask, and in its hole
        DrawnFrame changed = frame;
        ASSERT_EQ(changed.ids.at(at.x, at.y), kWallId);
        changed.ids.at(at.x, at.y) = 0;
        const Certificate certificate = certified(scene, changed);
        EXPECT_EQ(certificate.refused, 1u);
        EXPECT_EQ(certificate.firstRefused, at);
    }
}

TEST(MaskedCertifier, CastsNothingForMaskedSurfacesBehindOpaqueOnes) {
    scene::Scene scene = fadingCubeBeforeWall();
    scene::placeInstance(scene, 0, {0.0, 0.0, -25.0}, glm::mat3(40.0f));
    scene::placeInstance(scene, 1, {0.0, 0.0, -60.0}, glm::mat3(1.0f));
    const Certificate certificate = certified(scene, drawnByRays(scene, makePlainCamera(), kEightBits));
    EXPECT_EQ(certificate.refused, 0u);
    EXPECT_EQ(certificate.castMasked, 0u);
    EXPECT_GT(certificate.certified, certificate.pixels / 2);
}

} // namespace
} // namespace cdr::test
