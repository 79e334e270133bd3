#include "../fixture.h"
#include "../steps.h"

#include <cdr/measure/compare/flip_difference.h>
#include <cdr/measure/truth/layered_truth.h>
#include <cdr/scene/gltf/open_gltf.h>

#include <array>
#include <cstdlib>
#include <functional>

namespace cdr::render_test {

namespace {

class ModelTest : public RenderTest {
  protected:
    /// The model with every texture of a material, lit as chosen.
    static scene::SceneSetup model(scene::ModelLight light) {
        return scene::openGltf(CDR_SOURCE_DIR "/tests/assets/materials.glb",
                               {.scene = {}, .camera = 0, .light = light})
            .setup;
    }

    static render::RenderOptions options() {
        return withSorting(smallOptions(depth::parseTechnique("anchored"), 320, 180));
    }

    static double difference(const image::ImageRgba8& a, const image::ImageRgba8& b) {
        platform::WorkerPool workers(2);
        return measure::FlipDifference().mean(a, b, workers);
    }

    /// The largest channel's difference, averaged over the pixels inside of surfaces.
    static double meanSteps(const image::ImageRgba8& a, const image::ImageRgba8& b,
                            const measure::LayeredTruth& truth) {
        double sum = 0.0;
        std::size_t count = 0;
        for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
            if (truth.pixels[i].isInner) {
                sum += largestStep(a.pixels[i], b.pixels[i]);
                ++count;
            }
        }
        return sum / static_cast<double>(count);
    }
};

/// FLIP is of the whole picture, most of which is background: so steps of 255 inside of surfaces are bounded too.
TEST_F(ModelTest, LooksAsFloat64TruthUnderLamps) {
    const scene::SceneSetup setup = model(scene::ModelLight::lamps);
    const render::Frame frame = draw(setup.scene, setup.path.at(0), options());
    const measure::LayeredTruth truth =
        layersOf(setup.scene, setup.path.at(0), frame.width(), frame.height());
    const image::ImageRgba8 wanted = pictureOf(truth);
    EXPECT_LE(difference(wanted, frame.color), 0.03);
    EXPECT_LE(meanSteps(wanted, frame.color, truth), 1.0);
}

TEST_F(ModelTest, LooksAsFloat64TruthUnderASky) {
    const scene::SceneSetup setup = model(scene::ModelLight::sky);
    const render::Frame frame = draw(setup.scene, setup.path.at(0), options());
    const measure::LayeredTruth truth =
        layersOf(setup.scene, setup.path.at(0), frame.width(), frame.height());
    const image::ImageRgba8 wanted = pictureOf(truth, {.exposure = 0.0, .neutral = true});
    EXPECT_LE(difference(wanted, frame.color), 0.029); // 0.0314 where rough lobes do not lean to the normal
    EXPECT_LE(meanSteps(wanted, frame.color, truth), 3.0);
}

/// Without any one part of the materials the picture is another: each is drawn.
TEST_F(ModelTest, EachPartOfMaterialsShows) {
    const scene::SceneSetup setup = model(scene::ModelLight::sky);
    const render::Frame whole = draw(setup.scene, setup.path.at(0), options());
    const auto without = [&](const std::function<void(scene::MaterialDetail&)>& remove) {
        scene::Scene scene = setup.scene;
        for (scene::Material& material : scene.materials) {
            remove(material.detail);
        }
        return difference(whole.color, draw(scene, setup.path.at(0), options()).color);
    };
    EXPECT_GT(without([](auto& detail) { detail.metallicRoughness.reset(); }), 0.005);
    EXPECT_GT(without([](auto& detail) { detail.normal.reset(); }), 0.005);
    EXPECT_GT(without([](auto& detail) { detail.normalScale = 0.1f; }), 0.005);
    EXPECT_GT(without([](auto& detail) { detail.occlusion.reset(); }), 0.005);
    EXPECT_GT(without([](auto& detail) { detail.occlusionStrength = 0.1f; }), 0.005);
    EXPECT_GT(without([](auto& detail) { detail.emissive.reset(); }), 0.005);
    EXPECT_GT(without([](auto& detail) { detail.emission = glm::vec3(0.0f); }), 0.005);
}

TEST_F(ModelTest, ThePictureIsTheSameForAllTargetsThreadsAndSubmissions) {
    const scene::SceneSetup setup = model(scene::ModelLight::sky);
    render::RenderOptions chosen = quarterOf(options());
    chosen.technique = depth::parseTechnique("cdr");
    expectOnePicture(setup.scene, setup.path.at(0), chosen);
}

TEST_F(ModelTest, MaterialsThatDifferInDetailAloneAreToldApart) {
    scene::Scene scene = boxScene();
    scene.materials[0].detail.emission = glm::vec3(0.8f, 0.0f, 0.0f);
    scene.materials.push_back(scene.materials[0]);
    scene.materials[1].detail.emission = glm::vec3(0.0f, 0.8f, 0.0f);
    addBox(scene, {-1.0, 0.0, 0.0});
    addBox(scene, {1.0, 0.0, 0.0});
    scene.instances.material[1] = 1;
    const scene::Camera camera = scene::lookAt({.fovY = 0.9}, {0.0, 0.5, 5.0}, glm::dvec3(0.0));
    render::RenderOptions options = smallOptions(depth::parseTechnique("reversed"));
    for (const render::Submission submission : submissions()) {
        options.submission = submission;
        const render::Frame frame = draw(scene, camera, options);
        std::array<std::size_t, 2> glows{};
        for (const image::Rgba8& pixel : frame.color.pixels) {
            glows[0] += pixel[0] > 200 && pixel[1] < 200 ? 1 : 0;
            glows[1] += pixel[1] > 200 && pixel[0] < 200 ? 1 : 0;
        }
        EXPECT_GT(glows[0], 200u) << nameOf(submission);
        EXPECT_GT(glows[1], 200u) << nameOf(submission);
    }
}

/// Slices of one depth range round otherwise, so edges may differ.
TEST_F(ModelTest, OnePassAndWideDrawsShowTheSameMaterials) {
    const scene::SceneSetup setup = model(scene::ModelLight::sky);
    const render::Frame whole = draw(setup.scene, setup.path.at(0), options());
    render::RenderOptions onePass = options();
    onePass.targets = render::TargetsKind::onePass;
    EXPECT_LE(difference(whole.color, draw(setup.scene, setup.path.at(0), onePass).color), 0.002);
    render::RenderOptions logarithm = options();
    logarithm.technique = depth::parseTechnique("log"); // draws all of the model wide
    EXPECT_LE(difference(whole.color, draw(setup.scene, setup.path.at(0), logarithm).color), 0.002);
    logarithm.technique.mapping = depth::Mapping::logFragment;
    EXPECT_LE(difference(whole.color, draw(setup.scene, setup.path.at(0), logarithm).color), 0.002);
}

TEST_F(ModelTest, LayersKeepTheirMaterials) {
    scene::SceneSetup setup = model(scene::ModelLight::sky);
    const render::Frame whole = draw(setup.scene, setup.path.at(0), options());
    for (scene::Material& material : setup.scene.materials) {
        material.layer = 1e-4f;
    }
    EXPECT_LE(difference(whole.color, draw(setup.scene, setup.path.at(0), options()).color), 0.002);
}

TEST_F(ModelTest, WhatCannotKeepEmissionSaysSo) {
    const scene::SceneSetup setup = model(scene::ModelLight::sky);
    render::RenderOptions layered = quarterOf(options());
    layered.targets = render::TargetsKind::layers;
    EXPECT_FALSE(draw(setup.scene, setup.path.at(0), layered).stats.lostEmission);
    layered.effects.occlusion = {.radius = 0.2, .perLayer = true};
    EXPECT_TRUE(draw(setup.scene, setup.path.at(0), layered).stats.lostEmission);
    layered.effects.occlusion = {};
    layered.focus = {.distance = 5.0, .aperture = 0.01};
    EXPECT_TRUE(draw(setup.scene, setup.path.at(0), layered).stats.lostEmission);
    render::RenderOptions occluded = options();
    occluded.effects.occlusion.radius = 0.2;
    const render::Frame frame = draw(setup.scene, setup.path.at(0), occluded);
    EXPECT_FALSE(frame.stats.lostEmission);
    EXPECT_LE(difference(draw(setup.scene, setup.path.at(0), options()).color, frame.color), 0.05);
}

/// A material that gets detail while the world is drawn makes passes and vertices again.
TEST_F(ModelTest, AWorldMayGetDetailLater) {
    const scene::SceneSetup setup = model(scene::ModelLight::sky);
    const std::string wanted = hashOf(draw(setup.scene, setup.path.at(0), options()));
    scene::Scene plain = setup.scene;
    for (scene::Material& material : plain.materials) {
        material.detail = {};
    }
    scene::World world(plain);
    SoleRenderer renderer(device(), world, options());
    EXPECT_NE(hashOf(renderer.render(setup.path.at(0))), wanted);
    for (std::size_t i = 0; i < setup.scene.materials.size(); ++i) {
        world.setMaterial(world.material(i), setup.scene.materials[i]);
    }
    EXPECT_EQ(hashOf(renderer.render(setup.path.at(0))), wanted);
    for (std::size_t i = 0; i < plain.materials.size(); ++i) {
        world.setMaterial(world.material(i), plain.materials[i]);
    }
    EXPECT_NE(hashOf(renderer.render(setup.path.at(0))), wanted);
}

} // namespace

} // namespace cdr::render_test
