#include "certified_test.h"

#include <scenes/coplanar.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

namespace {

using namespace cdr;

constexpr std::uint32_t kViews = 6;

class CertifiedLayerTest : public test::CertifiedTest {
  protected:
    /// Draws one scene, says that it is the scene of layers, and repairs it. Tests that nothing wrong is left.
    measure::Certificate repaired(const scene::Scene& drawn, const render::RenderOptions& options,
                                  const scene::Camera& camera) {
        render::Frame frame = draw(drawn, camera, options);
        const measure::Certificate certificate = certificateOf(frame, options, m_certifier, m_workers);
        if (!certificate.isRefused()) {
            EXPECT_EQ(wrongAfterRepair(frame, certificate, m_setup.scene, camera), 0u);
        }
        return certificate;
    }

    static render::RenderOptions optionsOf(const depth::Technique& technique) {
        return {.width = 240, .height = 135, .technique = technique};
    }

    scene::SceneSetup m_setup = scenes::makeCoplanar();
    measure::Certifier m_certifier{m_setup.scene, m_workers};
};

TEST_F(CertifiedLayerTest, IsRightInEveryPixelOfEveryPreset) {
    for (const depth::NamedTechnique& preset : depth::presets()) {
        SCOPED_TRACE(preset.name);
        measure::Certificate all;
        for (std::uint32_t view = 0; view < kViews; ++view) {
            SCOPED_TRACE(view);
            const measure::Certificate certificate =
                repaired(m_setup.scene, optionsOf(preset.technique), scenes::coplanarView(2013, view));
            EXPECT_EQ(certificate.refused, 0u);
            all.pixels += certificate.pixels;
            all.certified += certificate.certified;
            all.wrong += certificate.wrong;
        }
        EXPECT_GT(all.certifiedFraction(), 0.97);
        RecordProperty(preset.name,
                       std::to_string(all.certified) + " certified, " + std::to_string(all.wrong) + " wrong");
    }
}

/// The device moves all surfaces to the wrong side: no device draws that which keeps to the layers.
TEST_F(CertifiedLayerTest, RefusesWhatIsDrawnInTheOppositeOrder) {
    scene::Scene opposite = m_setup.scene;
    for (scene::Material& material : opposite.materials) {
        material.layer = -material.layer;
    }
    const render::RenderOptions options = optionsOf(depth::parseTechnique("anchored"));
    std::uint64_t refused = 0;
    for (std::uint32_t view = 0; view < kViews; ++view) {
        refused += repaired(opposite, options, scenes::coplanarView(2013, view)).refused;
    }
    EXPECT_GT(refused, 10u);
}

} // namespace
