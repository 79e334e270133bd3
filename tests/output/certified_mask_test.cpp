#include "certified_test.h"

#include <cdr/scene/gltf/open_gltf.h>

#include <gtest/gtest.h>

#include <string>

namespace {

using namespace cdr;

/// The garden, whose leaves are masked. What it blends is opaque here.
scene::SceneSetup gardenOfMasks() {
    scene::SceneSetup setup = scene::openGltf(CDR_SOURCE_DIR "/tests/assets/garden.glb").setup;
    for (scene::Material& material : setup.scene.materials) {
        if (material.alphaMode == scene::AlphaMode::blend) {
            material.alphaMode = scene::AlphaMode::opaque;
        }
    }
    return setup;
}

class CertifiedMaskTest : public test::CertifiedTest {
  protected:
    /// Draws one scene, says that it is the garden, and repairs it. Tests that nothing wrong is left.
    measure::Certificate repaired(const scene::Scene& drawn, const depth::Technique& technique) {
        const render::RenderOptions options{.width = 320, .height = 180, .technique = technique};
        const scene::Camera camera = m_garden.path.at(0);
        render::Frame frame = draw(drawn, camera, options);
        const measure::Certificate certificate = certificateOf(frame, options, m_certifier, m_workers);
        EXPECT_EQ(certificate.refused, 0u);
        EXPECT_EQ(wrongAfterRepair(frame, certificate, m_garden.scene, camera), 0u);
        return certificate;
    }

    scene::SceneSetup m_garden = gardenOfMasks();
    measure::Certifier m_certifier{m_garden.scene, m_workers};
};

TEST_F(CertifiedMaskTest, IsRightInEveryPixelOfEveryPreset) {
    for (const depth::NamedTechnique& preset : depth::presets()) {
        SCOPED_TRACE(preset.name);
        const measure::Certificate certificate = repaired(m_garden.scene, preset.technique);
        EXPECT_GT(certificate.proven, 500u);
        EXPECT_GT(certificate.certifiedFraction(), 0.99);
        RecordProperty(preset.name, std::to_string(certificate.certified) + " certified, " +
                                        std::to_string(certificate.proven) + " of them proven, " +
                                        std::to_string(certificate.castMasked) + " of " +
                                        std::to_string(certificate.cast) + " cast for masks, " +
                                        std::to_string(certificate.wrong) + " wrong");
    }
}

/// The device cuts at another alpha, or has other alphas.
TEST_F(CertifiedMaskTest, IsRepairedWhereTheDeviceCutsInAnotherWay) {
    const depth::Technique technique = depth::parseTechnique("anchored");
    const std::uint64_t before = repaired(m_garden.scene, technique).wrong;
    scene::Scene cut = m_garden.scene;
    scene::Scene faded = m_garden.scene;
    for (std::size_t i = 0; i < cut.materials.size(); ++i) {
        if (cut.materials[i].alphaMode == scene::AlphaMode::mask) {
            cut.materials[i].alphaCutoff = 0.9f;
            faded.materials[i].baseColorFactor.a = 0.3f;
        }
    }
    EXPECT_GT(repaired(cut, technique).wrong, before + 10);
    EXPECT_GT(repaired(faded, technique).wrong, before + 10);
}

} // namespace
