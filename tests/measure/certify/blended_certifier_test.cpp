#include "../test_scenes.h"
#include "drawn_by_rays.h"

#include <cdr/measure/truth/layered_truth.h>
#include <cdr/measure/truth/truth_light.h>

#include <gtest/gtest.h>

#include <cstdint>

namespace cdr::test {
namespace {

using measure::Certificate;
using measure::DrawnFrame;

/// A ball, and before its right part a block of blended glass.
scene::Scene ballBehindGlass() {
    scene::Scene scene = makeEmptyScene();
    scene.materials.push_back({.name = "glass", .baseColorFactor = {0.2f, 0.4f, 1.0f, 0.5f}});
    scene.materials.back().alphaMode = scene::AlphaMode::blend;
    const auto glass = static_cast<std::uint32_t>(scene.materials.size() - 1);
    addObject(scene, kIcosphere, {0.0, 0.0, -8.0}, glm::mat3(2.0f));
    addObject(scene, kCube, {1.2, 0.0, -5.0}, glm::mat3(2.0f), glass);
    return scene;
}

measure::LayeredTruth layersOf(const scene::Scene& scene, const DrawnFrame& frame) {
    platform::WorkerPool workers(1);
    return measure::castLayers(scene, frame.camera, frame.ids.width, frame.ids.height, workers);
}

TEST(BlendedCertifier, CertifiesWhatIsBehindGlassAndCountsThePixelsOfGlass) {
    const scene::Scene scene = ballBehindGlass();
    const DrawnFrame frame = drawnByRays(scene, makePlainCamera(), kEightBits);
    const Certificate certificate = certified(scene, frame);
    EXPECT_EQ(certificate.refused, 0u);
    EXPECT_EQ(certificate.wrong, 0u);
    EXPECT_GT(certificate.certifiedFraction(), 0.98);
    EXPECT_EQ(shownBy(frame, 2), 0u);
    std::uint64_t blended = 0;
    for (const measure::LayeredPixel& pixel : layersOf(scene, frame).pixels) {
        blended += pixel.fragments > 0 ? 1 : 0;
    }
    EXPECT_GT(blended, 1000u);
    EXPECT_GE(certificate.blended, blended) << "each pixel of glass, and those that its edges may touch";
    EXPECT_LT(certificate.blended, blended + blended / 10);
}

/// Glass behind a face is nowhere seen, however near.
TEST(BlendedCertifier, DoesNotCountGlassBehindWhatIsSeen) {
    scene::Scene scene = ballBehindGlass();
    addObject(scene, kCube, {0.0, 0.0, -3.0}, glm::mat3(2.0f));
    for (const double behind : {0.001, 1.0}) {
        scene::placeInstance(scene, 1, {0.0, 0.0, -2.5 - behind}, glm::mat3(1.0f));
        EXPECT_EQ(certified(scene, drawnByRays(scene, makePlainCamera(), kEightBits)).blended, 0u) << behind;
    }
}

/// A device that misses pixel centres draws edges wrong, those behind glass too.
TEST(BlendedCertifier, LaysGlassOverWhatItRepairs) {
    const scene::Scene scene = ballBehindGlass();
    const DrawnFrame frame = drawnByRays(scene, makePlainCamera(), kRayOff, {.isOff = true});
    const Certificate certificate = certified(scene, frame);
    EXPECT_EQ(certificate.refused, 0u);
    EXPECT_EQ(wrongAfter(scene, frame, certificate), 0u);
    const measure::LayeredTruth layers = layersOf(scene, frame);
    std::uint64_t behindGlass = 0;
    for (const measure::PixelRepair& repair : certificate.repairs) {
        const measure::LayeredPixel& pixel = layers.at(repair.x, repair.y);
        EXPECT_EQ(repair.color, measure::encode(pixel.color)) << repair.x << ',' << repair.y;
        behindGlass += pixel.fragments > 0 ? 1 : 0;
    }
    EXPECT_GT(behindGlass, 0u);
    EXPECT_GT(certificate.repairs.size(), behindGlass);
}

} // namespace
} // namespace cdr::test
