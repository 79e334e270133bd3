#include "../support/shared_device.h"

#include <cdr/base/error.h>
#include <cdr/render/gpu_scene.h>
#include <cdr/render/renderer.h>
#include <experiments/certified_frame.h>
#include <scenes/boulders.h>
#include <scenes/cubes.h>
#include <scenes/ladder.h>
#include <scenes/mixed.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace {

using namespace cdr;
using namespace cdr::experiments;

render::RenderOptions smallPicture(const char* technique) {
    render::RenderOptions options;
    options.width = 320;
    options.height = 180;
    options.technique = depth::parseTechnique(technique);
    return options;
}

class CertifiedFrameTest : public test::DeviceTest {
  protected:
    render::Frame render(const scene::Scene& scene, const scene::Camera& camera,
                         const render::RenderOptions& options) {
        const render::GpuScene onDevice(device(), scene);
        return render::Renderer(device(), scene, onDevice, options).render(camera);
    }

    measure::Certificate certify(const scene::Scene& scene, const render::Frame& frame,
                                 const render::RenderOptions& options) {
        host::WorkerPool workers(options.threads);
        const measure::DrawnFrame drawn = drawnFrame(frame, options, device().info().subPixelBits);
        return measure::Certifier(scene, workers).certify(drawn, workers);
    }

    /// Pixels, edges included, whose object is not the true one.
    static std::uint64_t wrongIn(const render::Frame& frame, const measure::TruthImage& truth) {
        std::uint64_t wrong = 0;
        for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
            wrong += truth.pixels[i].id != frame.gbuffer.pixels[i].id() ? 1 : 0;
        }
        return wrong;
    }

    /// Certifies, repairs, and expects the truth in every pixel. @return what was wrong before.
    std::uint64_t expectRightOnceRepaired(const scene::SceneSetup& setup, std::uint32_t frameNumber,
                                          const render::RenderOptions& options) {
        render::Frame frame = render(setup.scene, setup.path.at(frameNumber), options);
        const measure::Certificate certificate = certify(setup.scene, frame, options);
        EXPECT_EQ(certificate.refused, 0u);
        host::WorkerPool workers(2);
        const measure::TruthImage truth =
            measure::castTruth(setup.scene, frame.camera, frame.width(), frame.height(), workers);
        EXPECT_EQ(certificate.wrong, wrongIn(frame, truth));
        putRight(frame, certificate);
        EXPECT_EQ(wrongIn(frame, truth), 0u);
        return certificate.wrong;
    }
};

TEST_F(CertifiedFrameTest, IsRightInEveryPixelOfEveryPreset) {
    const std::vector<scene::SceneSetup> setups{scenes::makeAfc(2013), scenes::makeMixed(),
                                                scenes::makeLadder(2013), scenes::makeBoulders(2013)};
    for (const scene::SceneSetup& setup : setups) {
        for (const depth::NamedTechnique& preset : depth::presets()) {
            SCOPED_TRACE(setup.scene.name + " " + preset.name);
            const render::RenderOptions options = smallPicture(preset.name.c_str());
            expectRightOnceRepaired(setup, 0, options);
            expectRightOnceRepaired(setup, setup.path.frames / 3, options);
        }
    }
}

TEST_F(CertifiedFrameTest, IsRightOnBothSurfacePathsAndWithSnappedVertices) {
    const scene::SceneSetup setup = scenes::makeAfc(2013);
    for (const char* technique : {"anchored", "standard"}) {
        render::RenderOptions options = smallPicture(technique);
        for (const render::SurfacePath surface :
             {render::SurfacePath::gbuffer, render::SurfacePath::visibility}) {
            for (const std::uint32_t snapBits : {0u, 3u}) {
                SCOPED_TRACE(std::string(technique) + " " + std::string(nameOf(surface)) + " " +
                             std::to_string(snapBits));
                options.surface = surface;
                options.snapBits = snapBits;
                const std::uint64_t wrong = expectRightOnceRepaired(setup, 90, options);
                EXPECT_GE(wrong, snapBits > 0 ? 20u : 0u);
            }
        }
    }
}

TEST_F(CertifiedFrameTest, HasTheSameBitsForAnyNumberOfThreads) {
    const scene::SceneSetup setup = scenes::makeAfc(2013);
    std::vector<render::Frame> frames;
    for (const std::size_t threads : {1u, 3u}) {
        render::RenderOptions options = smallPicture("reversed");
        options.threads = threads;
        frames.push_back(render(setup.scene, setup.path.at(40), options));
        putRight(frames.back(), certify(setup.scene, frames.back(), options));
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
        return certify(setup.scene, render(drawn, camera, options), options).refused;
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
    const render::Frame frame = render(setup.scene, setup.path.at(90), drawn);
    EXPECT_GT(certify(setup.scene, frame, stated).refused, 0u);
    expectRightOnceRepaired(setup, 90, drawn);
}

TEST_F(CertifiedFrameTest, IsRefusedWhereVerticesAreSnappedMoreThanStated) {
    const scene::SceneSetup setup = scenes::makeAfc(2013);
    render::RenderOptions options = smallPicture("anchored");
    options.snapBits = 1;
    const render::Frame frame = render(setup.scene, setup.path.at(90), options);
    EXPECT_EQ(certify(setup.scene, frame, options).refused, 0u);
    options.snapBits = 0;
    EXPECT_GT(certify(setup.scene, frame, options).refused, 0u);
}

/// A repaired pixel is lit as one that was drawn.
TEST_F(CertifiedFrameTest, RepairsColoursWithinTwoSteps) {
    const scene::SceneSetup setup = scenes::makeAfc(2013);
    const scene::Camera camera = setup.path.at(90);
    const render::Frame right = render(setup.scene, camera, smallPicture("anchored"));
    const render::RenderOptions options = smallPicture("standard");
    const measure::Certificate certificate =
        certify(setup.scene, render(setup.scene, camera, options), options);
    std::uint64_t compared = 0;
    for (const measure::PixelRepair& repair : certificate.repairs) {
        if (right.id(repair.x, repair.y) != repair.id) {
            continue; // an edge, where the other picture is not certified
        }
        ++compared;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            ASSERT_NEAR(repair.color[channel], right.color.at(repair.x, repair.y)[channel], 2)
                << repair.x << ", " << repair.y;
        }
    }
    EXPECT_GT(compared, 1000u);
}

TEST(CertifiedFrame, NamesWhatItCannotFollow) {
    const auto saysOf = [](const render::RenderOptions& options) {
        try {
            requireCertifiable(options);
        } catch (const base::InputError& error) {
            return std::string(error.what());
        }
        return std::string();
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
