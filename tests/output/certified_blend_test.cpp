#include "certified_test.h"

#include <cdr/scene/gltf/open_gltf.h>
#include <scenes/sheets.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

namespace {

using namespace cdr;

class CertifiedBlendTest : public test::CertifiedTest {
  protected:
    /// What is behind the blended surfaces of a scene is certified, and right in every pixel.
    void expectRight(const scene::SceneSetup& setup, const depth::Technique& technique,
                     std::uint64_t leastBlended) {
        render::RenderOptions options{.width = 320, .height = 180, .technique = technique};
        options.translucency.countsFragments = true;
        const scene::Camera camera = setup.path.at(0);
        render::Frame frame = draw(setup.scene, camera, options);
        const measure::Certificate certificate =
            certificateOf(frame, options, measure::Certifier(setup.scene, m_workers), m_workers);
        ASSERT_EQ(certificate.refused, 0u);
        const auto blended = static_cast<std::uint64_t>(
            std::count_if(frame.fragmentCounts.pixels.begin(), frame.fragmentCounts.pixels.end(),
                          [](std::uint32_t count) { return count > 0; }));
        EXPECT_GT(blended, leastBlended);
        EXPECT_GE(certificate.blended, blended) << "each pixel that the device blends, and some at edges";
        EXPECT_LT(certificate.blended, blended + blended / 4);
        EXPECT_EQ(wrongAfterRepair(frame, certificate, setup.scene, camera), 0u);
    }
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
