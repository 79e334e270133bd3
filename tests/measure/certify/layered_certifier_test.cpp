#include "../test_scenes.h"
#include "drawn_by_rays.h"

#include <cdr/measure/certify/layer_offset.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace cdr::test {
namespace {

using measure::Certificate;
using measure::DrawnFrame;

constexpr std::uint32_t kBehindId = 1;
constexpr std::uint32_t kPlateId = 2;

/// A wall, and a smaller plate with a layer whose front is at the same place. Both are turned, so depth changes across them.
scene::Scene plateOnWall(float layer) {
    scene::Scene scene = makeEmptyScene();
    scene.materials.push_back({.name = "plate", .layer = layer});
    const auto plateMaterial = static_cast<std::uint32_t>(scene.materials.size() - 1);
    const float angle = 0.5f;
    const glm::mat3 turned(glm::vec3(std::cos(angle), 0.0f, -std::sin(angle)), glm::vec3(0.0f, 1.0f, 0.0f),
                           glm::vec3(std::sin(angle), 0.0f, std::cos(angle)));
    const glm::dvec3 front = glm::dmat3(turned)[2];
    const glm::dvec3 middle(0.0, 0.0, -8.0);
    addObject(scene, kCube, middle - 2.0 * front, 4.0f * turned);
    addObject(scene, kCube, middle - 1.0 * front, 2.0f * turned, plateMaterial);
    return scene;
}

TEST(LayeredCertifier, CertifiesFacesAtOnePlaceInTheOrderOfTheirLayers) {
    for (const float layer : {0.01f, -0.01f}) {
        SCOPED_TRACE(layer);
        const scene::Scene scene = plateOnWall(layer);
        const DrawnFrame frame = drawnByRays(scene, makePlainCamera(), kEightBits);
        EXPECT_GT(shownBy(frame, kBehindId), 800u);
        EXPECT_EQ(shownBy(frame, kPlateId) > 300, layer > 0.0f);
        const Certificate certificate = certified(scene, frame);
        EXPECT_EQ(certificate.refused, 0u);
        EXPECT_EQ(certificate.wrong, 0u);
        EXPECT_EQ(certificate.repairs.size(), 0u);
        EXPECT_GT(certificate.certifiedFraction(), 0.98);
    }
}

/// Nothing but the layer orders the two faces, and it is far larger than what a device may be off.
TEST(LayeredCertifier, RefusesADeviceThatForgetsALayer) {
    const scene::Scene scene = plateOnWall(0.01f);
    const DrawnFrame frame = drawnByRays(plateOnWall(-0.01f), makePlainCamera(), kEightBits);
    EXPECT_GT(certified(scene, frame).refused, 300u);
}

/// A layer below what the device resolves: it may show either face, and rays put it right.
TEST(LayeredCertifier, RepairsWhatALayerIsTooSmallToDecide) {
    const scene::Scene scene = plateOnWall(1e-9f);
    const DrawnFrame frame = drawnByRays(plateOnWall(-1e-9f), makePlainCamera(), kEightBits);
    const Certificate certificate = certified(scene, frame);
    EXPECT_EQ(certificate.refused, 0u);
    EXPECT_GT(certificate.wrong, 300u);
    EXPECT_EQ(wrongAfter(scene, frame, certificate), 0u);
}

/// The plate moved away from the camera.
scene::Scene sunkBy(scene::Scene scene, double distance) {
    const std::uint32_t plate = 1;
    scene::placeInstance(scene, plate, scene.instances.position(plate) - glm::dvec3(0.0, 0.0, distance),
                         scene.instances.basis[plate]);
    return scene;
}

/// What is farther than a layer reaches stays behind, and a pixel that shows it is no device's.
TEST(LayeredCertifier, LetsNothingShineThroughMoreThanALayer) {
    const scene::Scene scene = plateOnWall(0.01f);
    const scene::Scene sunk = sunkBy(scene, 0.1);
    EXPECT_EQ(shownBy(drawnByRays(sunk, makePlainCamera(), kEightBits), kPlateId), 0u);
    EXPECT_EQ(certified(sunk, drawnByRays(sunk, makePlainCamera(), kEightBits)).wrong, 0u);
    EXPECT_GT(certified(sunk, drawnByRays(scene, makePlainCamera(), kEightBits)).refused, 300u);
}

/// So that rounded vertices do not decide, a device moves a slanted surface by a little more than its layer.
TEST(LayeredCertifier, RepairsWhatADeviceMovesBeyondALayer) {
    // The plate is farther than its layer reaches, and is drawn all the same.
    const auto drawnAt = [](double distance) {
        return drawnByRays(sunkBy(plateOnWall(static_cast<float>(distance + 0.0001)), distance),
                           makePlainCamera(), kEightBits);
    };
    const scene::Scene sunk = sunkBy(plateOnWall(0.01f), 0.0103);
    const DrawnFrame frame = drawnAt(0.0103);
    const Certificate certificate = certified(sunk, frame);
    EXPECT_EQ(certificate.refused, 0u);
    EXPECT_GT(certificate.wrong, 50u);
    EXPECT_EQ(wrongAfter(sunk, frame, certificate), 0u);
    EXPECT_GT(certified(sunkBy(plateOnWall(0.01f), 0.012), drawnAt(0.012)).refused, 50u);
}

TEST(LayerOffsets, CountTheOffsetsBetweenNoneAndTheirOwn) {
    const std::vector<scene::Material> materials{
        {}, {.layer = 0.5f}, {.layer = -1.0f}, {.layer = 0.25f}, {.layer = 0.5f}, {.layer = -3.0f}};
    std::vector<double> ranks;
    for (const measure::LayerOffset& layer : measure::layerOffsets(materials)) {
        ranks.push_back(layer.ranks);
    }
    EXPECT_EQ(ranks, (std::vector<double>{0.0, 2.0, 1.0, 1.0, 2.0, 2.0}));
    EXPECT_EQ(measure::layerOffsets(materials)[5].view, -3.0);
    EXPECT_EQ((measure::LayerOffset{4.0, 1.0}).movedView(6.0), 3.0) << "half of the way";
}

} // namespace
} // namespace cdr::test
