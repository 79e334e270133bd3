#include "../test_scenes.h"
#include "drawn_by_rays.h"

#include <gtest/gtest.h>

#include <cstdint>

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

TEST(MaskedCertifier, CastsWhereAMaskedSurfaceMayBeSeenAndCertifiesTheRest) {
    const scene::Scene scene = fadingCubeBeforeWall();
    const DrawnFrame frame = drawnByRays(scene, makePlainCamera(), kEightBits);
    const Certificate certificate = certified(scene, frame);
    EXPECT_EQ(certificate.refused, 0u);
    EXPECT_EQ(certificate.wrong, 0u);
    EXPECT_GT(shownBy(frame, kFadingId), 100u);
    EXPECT_GT(certificate.castMasked, shownBy(frame, kFadingId) + 100) << "what is cut away is cast too";
    EXPECT_GE(certificate.cast, certificate.castMasked);
    EXPECT_EQ(certificate.certified + certificate.cast, certificate.pixels);
    EXPECT_GT(certificate.certified, certificate.pixels / 4);
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
