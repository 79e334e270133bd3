#include "../support/shared_device.h"
#include "wrong_after_repair.h"

#include <cdr/render/gpu_scene.h>
#include <cdr/render/renderer.h>
#include <scenes/coplanar.h>

#include <gtest/gtest.h>
#include <output/certified_frame.h>

#include <cstdint>
#include <string>

namespace {

using namespace cdr;
using namespace cdr::output;

constexpr std::uint32_t kViews = 6;

class CertifiedLayerTest : public test::DeviceTest {
  protected:
    /// Draws one scene, says that it is the scene of layers, and repairs it. Tests that nothing wrong is left.
    measure::Certificate repaired(const scene::Scene& drawn, const render::RenderOptions& options,
                                  const scene::Camera& camera) {
        const render::GpuScene onDevice(device(), drawn);
        render::Frame frame = render::Renderer(device(), drawn, onDevice, options).render(camera);
        const measure::Certificate certificate =
            m_certifier.certify(drawnFrame(frame, options, device().info().subPixelBits), m_workers);
        if (certificate.isRefused()) {
            return certificate;
        }
        EXPECT_EQ(test::wrongAfterRepair(frame, certificate, m_setup.scene, camera, m_workers), 0u);
        return certificate;
    }

    static render::RenderOptions optionsOf(const depth::Technique& technique) {
        render::RenderOptions options;
        options.width = 240;
        options.height = 135;
        options.technique = technique;
        return options;
    }

    scene::SceneSetup m_setup = scenes::makeCoplanar();
    platform::WorkerPool m_workers{2};
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
