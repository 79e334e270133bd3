#include "../../support/address_limit.h"
#include "../../support/refusal.h"
#include "../test_scenes.h"
#include "drawn_by_rays.h"

#include <cdr/measure/truth/layered_truth.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

namespace cdr::test {
namespace {

/// Takes more memory than the limits below leave, and little enough for a test.
constexpr std::uint32_t kSide = 2048;
constexpr std::uint64_t kLeft = std::uint64_t{64} << 20;

scene::Scene cubeScene() {
    scene::Scene scene = makeEmptyScene();
    addObject(scene, kCube, {0.0, 0.0, -5.0});
    return scene;
}

/// Refused with the bytes that it needs, before memory runs out.
template <typename Work>
void expectRefused(const Work& work, const std::string& what) {
    const AddressLimit limit(kLeft);
    const std::string message = runErrorOf([&] { work(); });
    EXPECT_EQ(message.find(what + " needs "), 0u) << message;
}

TEST(LargePicture, TruthIsRefused) {
    const scene::Scene scene = cubeScene();
    expectRefused([&] { cast(scene, makePlainCamera(), kSide, kSide); }, "the truth of 2048x2048 pixels");
}

TEST(LargePicture, TruthWithLayersIsRefused) {
    const scene::Scene scene = cubeScene();
    platform::WorkerPool workers(1);
    expectRefused([&] { measure::castLayers(scene, makePlainCamera(), kSide, kSide, workers); },
                  "the truth of 2048x2048 pixels with layers");
}

TEST(LargePicture, CertificateIsRefused) {
    const scene::Scene scene = cubeScene();
    measure::DrawnFrame frame = drawnByRays(scene, makePlainCamera(), 0.0);
    frame.ids = image::ImageU32(kSide, kSide);
    frame.distancesView = image::Raster<double>(kSide, kSide);
    expectRefused([&] { certified(scene, frame); }, "the certificate of 2048x2048 pixels");
}

} // namespace
} // namespace cdr::test
