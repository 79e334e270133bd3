#include "../support/shared_device.h"
#include "wrong_after_repair.h"

#include <cdr/render/gpu_scene.h>
#include <cdr/render/renderer.h>
#include <cdr/scene/gltf/open_gltf.h>
#include <scenes/sheets.h>

#include <gtest/gtest.h>
#include <output/certified_frame.h>

#include <algorithm>
#include <cstdint>

namespace {

using namespace cdr;
using namespace cdr::output;

class CertifiedBlendTest : public test::DeviceTest {
  protected:
    /// What is behind the blended surfaces of a scene is certified, and right in every pixel.
    void expectRight(const scene::SceneSetup& setup, const depth::Technique& technique,
                     std::uint64_t leastBlended) {
        render::RenderOptions options;
        options.width = 320;
        options.height = 180;
        options.technique = technique;
        options.translucency.countsFragments = true;
        const render::GpuScene onDevice(device(), setup.scene);
        const scene::Camera camera = setup.path.at(0);
        render::Frame frame = render::Renderer(device(), setup.scene, onDevice, options).render(camera);
        const measure::Certificate certificate =
            measure::Certifier(setup.scene, m_workers)
                .certify(drawnFrame(frame, options, device().info().subPixelBits), m_workers);
        ASSERT_EQ(certificate.refused, 0u);
        const auto blended = static_cast<std::uint64_t>(
            std::count_if(frame.fragmentCounts.pixels.begin(), frame.fragmentCounts.pixels.end(),
                          [](std::uint32_t count) { return count > 0; }));
        EXPECT_GT(blended, leastBlended);
        EXPECT_GE(certificate.blended, blended) << "each pixel that the device blends, and some at edges";
        EXPECT_LT(certificate.blended, blended + blended / 4);
        EXPECT_EQ(test::wrongAfterRepair(frame, certificate, setup.scene, camera, m_workers), 0u);
    }

    platform::WorkerPool m_workers{2};
};

TEST_F(CertifiedBlendTest, IsRightBehindSheetsOfGlassWithEveryPreset) {
    const scene::SceneSetup sheets = scenes::makeSheets(2013);
    for (const depth::NamedTechnique& preset : depth::presets()) {
        SCOPED_TRACE(preset.name);
        expectRight(sheets, preset.technique, 10'000);
    }
}

/// Leaves are masked there, and windows and water blended.
TEST_F(CertifiedBlendTest, IsRightBehindTheWindowsOfAGarden) {
    expectRight(scene::openGltf(CDR_SOURCE_DIR "/tests/assets/garden.glb").setup,
                depth::parseTechnique("anchored"), 100);
}

} // namespace
