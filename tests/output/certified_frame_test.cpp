#include "../support/refusal.h"
#include "certified_test.h"

#include <cdr/gpu/vulkan_hpp.h>
#include <scenes/boulders.h>
#include <scenes/cubes.h>
#include <scenes/ladder.h>
#include <scenes/mixed.h>

#include <gtest/gtest.h>
#include <output/certified_frame.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace {

using namespace cdr;
using namespace cdr::output;

render::RenderOptions smallPicture(const char* technique) {
    return {.width = 320, .height = 180, .technique = depth::parseTechnique(technique)};
}

/// A scene that is ready for any number of pictures. The true picture of a frame is cast once.
class ReadyScene {
  public:
    ReadyScene(const gpu::Device& device, const scene::SceneSetup& setup)
        : m_device(&device),
          m_setup(&setup),
          m_onDevice(device, setup.scene),
          m_certifier(setup.scene, m_workers) {}

    render::Frame render(std::uint32_t frame, const render::RenderOptions& options) const {
        return render::Renderer(*m_device, m_setup->scene, m_onDevice, options)
            .render(m_setup->path.at(frame));
    }
    measure::Certificate certify(const render::Frame& frame, const render::RenderOptions& options) {
        const measure::DrawnFrame drawn = drawnFrame(frame, options, m_device->info().subPixelBits);
        return m_certifier.certify(drawn, m_workers);
    }
    const measure::TruthImage& truth(std::uint32_t frame, const render::RenderOptions& size) {
        measure::TruthImage& truth = m_truths[frame];
        if (truth.pixels.empty()) {
            truth = measure::castTruth(m_setup->scene, m_setup->path.at(frame), size.width, size.height,
                                       m_workers);
        }
        return truth;
    }

  private:
    platform::WorkerPool m_workers{2};
    const gpu::Device* m_device;
    const scene::SceneSetup* m_setup;
    render::GpuScene m_onDevice;
    measure::Certifier m_certifier;
    std::map<std::uint32_t, measure::TruthImage> m_truths;
};

class CertifiedFrameTest : public test::CertifiedTest {
  protected:
    measure::Certificate certify(const scene::Scene& scene, const render::Frame& frame,
                                 const render::RenderOptions& options) {
        platform::WorkerPool workers(options.threads);
        return certificateOf(frame, options, measure::Certifier(scene, workers), workers);
    }

    /// Certifies, repairs, and expects the truth in every pixel. @return what was wrong before.
    static std::uint64_t expectRightOnceRepaired(ReadyScene& scene, std::uint32_t frameNumber,
                                                 const render::RenderOptions& options) {
        render::Frame frame = scene.render(frameNumber, options);
        const measure::Certificate certificate = scene.certify(frame, options);
        EXPECT_EQ(certificate.refused, 0u);
        const measure::TruthImage& truth = scene.truth(frameNumber, options);
        EXPECT_EQ(certificate.wrong, test::wrongIn(frame, truth));
        test::repairFrame(frame, certificate);
        EXPECT_EQ(test::wrongIn(frame, truth), 0u);
        return certificate.wrong;
    }
};

TEST_F(CertifiedFrameTest, IsRightInEveryPixelOfEveryPreset) {
    const std::vector<scene::SceneSetup> setups{
        scenes::makeAfc(2013), scenes::makeMixed(), scenes::makeLadder(2013),
        scenes::makeBoulders(2013, {.boulders = 60, .shapes = 3, .subdivisions = 4})};
    for (const scene::SceneSetup& setup : setups) {
        ReadyScene scene(device(), setup);
        for (const depth::NamedTechnique& preset : depth::presets()) {
            SCOPED_TRACE(setup.scene.name + " " + preset.name);
            const render::RenderOptions options = smallPicture(preset.name.c_str());
            expectRightOnceRepaired(scene, 0, options);
            expectRightOnceRepaired(scene, setup.path.frames / 3, options);
        }
    }
}

TEST_F(CertifiedFrameTest, IsRightOnBothSurfacePathsAndWithSnappedVertices) {
    const scene::SceneSetup setup = scenes::makeAfc(2013);
    ReadyScene scene(device(), setup);
    for (const char* technique : {"anchored", "standard"}) {
        render::RenderOptions options = smallPicture(technique);
        for (const render::SurfacePath surface :
             {render::SurfacePath::gbuffer, render::SurfacePath::visibility}) {
            for (const std::uint32_t snapBits : {0u, 3u}) {
                SCOPED_TRACE(std::string(technique) + " " + std::string(nameOf(surface)) + " " +
                             std::to_string(snapBits));
                options.surface = surface;
                options.snapBits = snapBits;
                const std::uint64_t wrong = expectRightOnceRepaired(scene, 90, options);
                EXPECT_GE(wrong, snapBits > 0 ? 20u : 0u);
            }
        }
    }
}

/// A visibility buffer has the distance of a facet's plane, which is far off beyond the edge of a facet that is seen flat.
TEST_F(CertifiedFrameTest, IsRightWhereFacetsAreSeenFlatAndSnapped) {
    constexpr std::uint32_t kTexels = 76'872; // of the facets of these cubes
    if (vk::PhysicalDevice(device().physical()).getProperties().limits.maxTexelBufferElements < kTexels) {
        GTEST_SKIP() << "the device reads too few facets";
    }
    const scene::SceneSetup setup = scenes::makeRotation(2013);
    ReadyScene scene(device(), setup);
    render::RenderOptions options = smallPicture("reversed");
    options.surface = render::SurfacePath::visibility;
    options.snapBits = 3;
    EXPECT_GT(expectRightOnceRepaired(scene, 0, options), 0u);
}

/// What is near has its w as the sum of a far plane and a distance to it, which float32 rounds by more than w.
TEST_F(CertifiedFrameTest, IsRightWhereTheAnchorIsFarBehind) {
    const scene::SceneSetup setup = scenes::makeMixed();
    ReadyScene scene(device(), setup);
    EXPECT_GT(expectRightOnceRepaired(scene, 0, smallPicture("anchored-reversed/none")), 1000u);
}

TEST_F(CertifiedFrameTest, HasTheSameBitsForAnyNumberOfThreads) {
    const scene::SceneSetup setup = scenes::makeAfc(2013);
    std::vector<render::Frame> frames;
    for (const std::size_t threads : {1u, 3u}) {
        render::RenderOptions options = smallPicture("standard");
        options.threads = threads;
        frames.push_back(draw(setup.scene, setup.path.at(40), options));
        const measure::Certificate certificate = certify(setup.scene, frames.back(), options);
        EXPECT_GT(certificate.repairs.size(), 100u);
        test::repairFrame(frames.back(), certificate);
    }
    EXPECT_EQ(frames[0].color, frames[1].color);
    for (std::size_t i = 0; i < frames[0].gbuffer.pixels.size(); ++i) {
        ASSERT_EQ(frames[0].gbuffer.pixels[i].idAndCascade, frames[1].gbuffer.pixels[i].idAndCascade);
        ASSERT_EQ(frames[0].gbuffer.pixels[i].ahead, frames[1].gbuffer.pixels[i].ahead);
        ASSERT_EQ(frames[0].gbuffer.pixels[i].normal, frames[1].gbuffer.pixels[i].normal);
    }
}

/// The device draws a scene that is not the one that it is said to be.
TEST_F(CertifiedFrameTest, IsRefusedWhereTheDeviceDrawsOtherGeometry) {
    const scene::SceneSetup setup = scenes::makeAfc(2013);
    const scene::Camera camera = setup.path.at(90);
    render::RenderOptions options = smallPicture("anchored");
    const auto refusedOf = [&](const scene::Scene& drawn) {
        return certify(setup.scene, draw(drawn, camera, options), options).refused;
    };
    EXPECT_EQ(refusedOf(setup.scene), 0u);
    scene::Scene perturbed = setup.scene;
    for (scene::Vertex& vertex : perturbed.meshes[0].vertices) {
        vertex.position *= 0.9f;
    }
    EXPECT_GT(refusedOf(perturbed), 0u);
    scene::Scene moved = setup.scene;
    for (std::size_t i = 0; i < moved.instances.size(); i += 7) {
        scene::placeInstance(moved, i, moved.instances.position(i) + 0.05 * camera.right,
                             moved.instances.basis[i]);
    }
    EXPECT_GT(refusedOf(moved), 0u);
    scene::Scene renamed = setup.scene;
    std::reverse(renamed.instances.object.begin(), renamed.instances.object.end());
    EXPECT_GT(refusedOf(renamed), 0u);
}

TEST_F(CertifiedFrameTest, IsRefusedWhereTheDepthFormatIsCoarserThanStated) {
    const scene::SceneSetup setup = scenes::makeAfc(2013);
    render::RenderOptions stated = smallPicture("reversed");
    render::RenderOptions drawn = stated;
    drawn.technique.format = depth::DepthFormat::d16;
    ReadyScene scene(device(), setup);
    EXPECT_GT(scene.certify(scene.render(90, drawn), stated).refused, 0u);
    expectRightOnceRepaired(scene, 90, drawn);
}

TEST_F(CertifiedFrameTest, IsRefusedWhereVerticesAreSnappedMoreThanStated) {
    const scene::SceneSetup setup = scenes::makeAfc(2013);
    render::RenderOptions options = smallPicture("anchored");
    options.snapBits = 1;
    ReadyScene scene(device(), setup);
    const render::Frame frame = scene.render(90, options);
    EXPECT_EQ(scene.certify(frame, options).refused, 0u);
    options.snapBits = 0;
    EXPECT_GT(scene.certify(frame, options).refused, 0u);
}

/// A repaired pixel is lit, shadowed and tone-mapped as one that was drawn.
TEST_F(CertifiedFrameTest, RepairsColoursWithinTwoSteps) {
    scene::SceneSetup setup = scenes::makeAfc(2013);
    for (const bool hasSky : {false, true}) {
        if (hasSky) {
            setup.scene.sky = scene::Sky{};
        }
        const scene::Camera camera = setup.path.at(90);
        for (const render::ShadowMethod method :
             {render::ShadowMethod::none, render::ShadowMethod::anchored}) {
            SCOPED_TRACE(std::string(hasSky ? "sky, shadows " : "shadows ") + std::string(nameOf(method)));
            render::RenderOptions options = smallPicture("anchored");
            options.shadows.method = method;
            const render::Frame right = draw(setup.scene, camera, options);
            options.technique = depth::namedTechnique("standard").technique;
            const measure::Certificate certificate =
                certify(setup.scene, draw(setup.scene, camera, options), options);
            std::uint64_t compared = 0;
            std::uint64_t others = 0;
            for (const measure::PixelRepair& repair : certificate.repairs) {
                if (right.id(repair.x, repair.y) != repair.id) {
                    continue; // an edge, where the other picture is not certified
                }
                ++compared;
                const image::Rgba8& drawn = right.color.at(repair.x, repair.y);
                const auto isOff = [&](std::size_t i) { return std::abs(repair.color[i] - drawn[i]) > 2; };
                others += isOff(0) || isOff(1) || isOff(2) ? 1 : 0;
            }
            EXPECT_GT(compared, 1000u);
            // Edges of shadows in a map lie within its texels of the true ones.
            EXPECT_LE(others, method == render::ShadowMethod::none ? 0 : compared / 100) << "of " << compared;
        }
    }
}

TEST(CertifiedFrame, NamesWhatItCannotFollow) {
    const auto saysOf = [](const render::RenderOptions& options) {
        return test::inputErrorOf([&] { requireCertifiable(options); });
    };
    EXPECT_EQ(saysOf(smallPicture("anchored")), "");
    render::RenderOptions levels = smallPicture("anchored");
    levels.detail.mode = visibility::DetailMode::perObject;
    EXPECT_NE(saysOf(levels).find("levels of detail"), std::string::npos);
    render::RenderOptions focus = smallPicture("anchored");
    focus.focus.distance = 10.0;
    EXPECT_NE(saysOf(focus).find("a focus"), std::string::npos);
    render::RenderOptions effects = smallPicture("anchored");
    effects.effects.antialias = render::Antialias::edges;
    EXPECT_NE(saysOf(effects).find("effects"), std::string::npos);
}

} // namespace
