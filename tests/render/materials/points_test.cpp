#include "../fixture.h"
#include "../snapping.h"
#include "../steps.h"

#include <cdr/measure/compare/flip_difference.h>
#include <cdr/scene/gltf/open_gltf.h>

#include <optional>
#include <vector>

namespace cdr::render_test {

namespace {

class PointsTest : public RenderTest {
  protected:
    /// A file with points and lines of every mode, through its own camera.
    static scene::SceneSetup survey(std::optional<double> radius) {
        return scene::openGltf(CDR_SOURCE_DIR "/tests/assets/survey.glb",
                               {.scene = {}, .camera = 0, .pointRadius = radius})
            .setup;
    }
};

TEST_F(PointsTest, EachModeIsSeenWhereTheTruthSeesIt) {
    for (const std::optional<double> radius : {std::optional<double>{}, std::optional(0.04)}) {
        const scene::SceneSetup setup = survey(radius);
        const scene::Camera camera = setup.path.at(0);
        const render::Frame frame =
            draw(setup.scene, camera, smallOptions(depth::parseTechnique("anchored")));
        std::vector<std::size_t> seen(setup.scene.objectNames.size() + 1);
        for (const std::uint32_t id : frame.ids().pixels) {
            ++seen.at(id);
        }
        for (std::size_t object = 0; object < setup.scene.objectNames.size(); ++object) {
            EXPECT_GT(seen[object + 1], 100u) << setup.scene.objectNames[object];
        }
        const measure::WrongPixels wrong = wrongIn(frame, setup.scene, camera);
        EXPECT_GT(wrong.pixels, 15'000u);
        EXPECT_EQ(wrong.wrong, 0u);
    }
}

TEST_F(PointsTest, LooksAsFloat64Truth) {
    const scene::SceneSetup setup = survey(0.06);
    const scene::Camera camera = setup.path.at(0);
    const render::Frame frame =
        draw(setup.scene, camera, quarterOf(smallOptions(depth::parseTechnique("anchored"))));
    platform::WorkerPool workers(2);
    const image::ImageRgba8 wanted = pictureOf(layersOf(setup.scene, camera, frame.width(), frame.height()));
    EXPECT_LE(measure::FlipDifference().mean(wanted, frame.color, workers), 0.02);
}

/// A second scan of the hill, nearer to the camera by half a millionth of the distance.
TEST_F(PointsTest, CloudsAlmostAtOnePlaceAreToldApart) {
    constexpr std::uint32_t kHill = 1;
    scene::SceneSetup setup = survey(0.06);
    const scene::Camera camera = setup.path.at(0);
    const auto second = static_cast<std::uint32_t>(setup.scene.objectNames.size());
    const scene::Instances& instances = setup.scene.instances;
    for (std::size_t i = 0, count = instances.size(); i < count; ++i) {
        if (instances.object[i] == kHill) {
            const glm::dvec3 towards = camera.position - instances.position(i);
            scene::addInstance(setup.scene, instances.mesh[i], instances.material[i], second,
                               instances.position(i) + 5e-7 * towards, instances.basis[i]);
        }
    }
    setup.scene.objectNames.emplace_back("second hill");
    const auto idsOf = [&](const char* technique) {
        return draw(setup.scene, camera, smallOptions(depth::parseTechnique(technique))).ids();
    };
    const image::ImageU32 standard = idsOf("standard");
    const auto truth = truthOf(setup.scene, camera);
    EXPECT_GT(measure::countWrong(standard, truth).wrong, 100u);
    EXPECT_EQ(wrongBeyond(idsOf("anchored"), truth, snapReach(device())), 0u);
}

/// The survey, whose unlit points and lines glow.
scene::SceneSetup glowing(scene::SceneSetup setup) {
    setup.scene.background = glm::vec3(0.0f);
    for (scene::Material& material : setup.scene.materials) {
        if (material.unlit) {
            material.detail.emission = glm::vec3(0.02f, 0.05f, 0.4f);
        }
    }
    return setup;
}

TEST_F(PointsTest, UnlitOnesShowWhatTheyEmit) {
    scene::SceneSetup setup = glowing(survey(0.06));
    const scene::Camera camera = setup.path.at(0);
    const scene::SceneSetup dark = survey(0.06);
    platform::WorkerPool workers(2);
    render::RenderOptions options = withSorting(quarterOf(smallOptions(depth::parseTechnique("anchored"))));
    for (const scene::AlphaMode alpha : {scene::AlphaMode::opaque, scene::AlphaMode::blend}) {
        for (scene::Material& material : setup.scene.materials) {
            material.alphaMode = material.unlit ? alpha : material.alphaMode;
            material.baseColorFactor.a = material.unlit ? 0.7f : 1.0f;
        }
        const image::ImageRgba8 drawn = draw(setup.scene, camera, options).color;
        const image::ImageRgba8 wanted = pictureOf(layersOf(setup.scene, camera, drawn.width, drawn.height));
        EXPECT_LE(measure::FlipDifference().mean(wanted, drawn, workers), 0.02);
        const image::ImageRgba8 without = draw(dark.scene, camera, options).color;
        EXPECT_GT(measure::FlipDifference().mean(without, drawn, workers), 0.05);
    }
}

/// What shows in each path shows in all: see ModelTest for surfaces that are lit.
TEST_F(PointsTest, AreTheSameInEveryPathWhetherTheyGlowOrNot) {
    const scene::SceneSetup setup = glowing(survey({}));
    render::RenderOptions options = thumbnailOptions(depth::parseTechnique("cdr"));
    expectOnePicture(survey({}).scene, setup.path.at(0), options);
    expectOnePicture(setup.scene, setup.path.at(0), options);
    options.surface = render::SurfacePath::visibility;
    options.submission = render::Submission::secondaries;
    EXPECT_NE(refusalOf(setup.scene, options).find("emit light"), std::string::npos);
}

TEST_F(PointsTest, UnlitOnesMayGlowLater) {
    const scene::SceneSetup setup = glowing(survey({}));
    const render::RenderOptions options = thumbnailOptions(depth::parseTechnique("anchored"));
    scene::Scene dark = setup.scene;
    for (scene::Material& material : dark.materials) {
        material.detail = {};
    }
    scene::World world(dark);
    SoleRenderer renderer(device(), world, options);
    const std::string before = hashOf(renderer.render(setup.path.at(0)));
    for (std::size_t i = 0; i < setup.scene.materials.size(); ++i) {
        world.setMaterial(world.material(i), setup.scene.materials[i]);
    }
    EXPECT_EQ(hashOf(renderer.render(setup.path.at(0))),
              hashOf(draw(setup.scene, setup.path.at(0), options)));
    for (std::size_t i = 0; i < setup.scene.materials.size(); ++i) {
        world.setMaterial(world.material(i), dark.materials[i]);
    }
    EXPECT_EQ(hashOf(renderer.render(setup.path.at(0))), before);
}

} // namespace

} // namespace cdr::render_test
