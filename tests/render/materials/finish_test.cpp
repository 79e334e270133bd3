#include "../fixture.h"
#include "../steps.h"

#include <cdr/base/error.h>
#include <cdr/measure/truth/layered_truth.h>

namespace cdr::render_test {

namespace {

class FinishTest : public RenderTest {};

scene::Scene brightScene() {
    scene::Scene scene = boxScene();
    scene.background = glm::vec3(0.9f, 0.5f, 2.0f);
    scene.materials[0].baseColorFactor = glm::vec4(0.9f, 0.5f, 0.2f, 1.0f);
    scene.lights[0].color = glm::vec3(4.0f);
    addBox(scene, {0.0, 0.0, 0.0}, glm::mat3(2.0f));
    addBox(scene, {2.0, 0.5, 0.0});
    return scene;
}

const scene::Camera kCamera = scene::lookAt({.fovY = 0.9}, {1.0, 2.0, 5.0}, glm::dvec3(0.0));

/// Shading finishes the picture itself; the pass that smooths edges does so in its place. A visibility buffer's background
/// is cleared, and comes from the CPU.
TEST_F(FinishTest, PicturesAreFinishedAsInFloat64) {
    const scene::Scene scene = brightScene();
    render::RenderOptions options = smallOptions(depth::parseTechnique("reversed"));
    const measure::LayeredTruth truth = layersOf(scene, kCamera, options.width, options.height);
    for (const double exposure : {-1.0, 0.0, 1.5}) {
        for (const render::ToneMap toneMap : {render::ToneMap::none, render::ToneMap::neutral}) {
            const measure::TruthFinish finish{.exposure = exposure,
                                              .neutral = toneMap == render::ToneMap::neutral};
            options.effects = {.finish = {.toneMap = toneMap, .exposure = exposure}};
            EXPECT_LE(largestStepTo(truth, finish, draw(scene, kCamera, options).color), 2);
            options.effects.antialias = render::Antialias::edges;
            EXPECT_LE(largestStepTo(truth, finish, draw(scene, kCamera, options).color), 3);
            options.effects.antialias = render::Antialias::none;
            options.surface = render::SurfacePath::visibility;
            EXPECT_LE(largestStepTo(truth, finish, draw(scene, kCamera, options).color), 3);
            options.surface = render::SurfacePath::gbuffer;
        }
    }
}

/// A sky is no lamp: its scene shows highlights whole, whether shading finishes or the pass that smooths edges.
TEST_F(FinishTest, TheSceneChoosesUnlessTold) {
    scene::Scene scene = brightScene();
    render::RenderOptions options = smallOptions(depth::parseTechnique("reversed"));
    const auto hashWith = [&](render::ToneMap toneMap) {
        options.effects.finish.toneMap = toneMap;
        return hashOf(draw(scene, kCamera, options));
    };
    for (const render::Antialias antialias : {render::Antialias::none, render::Antialias::edges}) {
        options.effects.antialias = antialias;
        scene.sky.reset();
        EXPECT_EQ(hashWith(render::ToneMap::scene), hashWith(render::ToneMap::none));
        scene.sky = scene::Sky{};
        EXPECT_EQ(hashWith(render::ToneMap::scene), hashWith(render::ToneMap::neutral));
        EXPECT_NE(hashWith(render::ToneMap::scene), hashWith(render::ToneMap::none));
    }
}

/// Light that is no float any more, or no half float, is white; not a number would be black.
TEST_F(FinishTest, LightBeyondAllRangesIsWhite) {
    scene::Scene scene = boxScene();
    scene.lights.assign(2, {.position = {0.0, 0.0, 0.0}, .color = glm::vec3(3e38f), .halfDistance = 20.0});
    scene.materials[0].baseColorFactor = glm::vec4(1.0f, 0.5f, 0.0f, 1.0f);
    addBox(scene, {0.0, 0.0, -3.0});
    scene.materials.push_back({.name = "glass",
                               .baseColorFactor = glm::vec4(0.0f, 0.0f, 0.0f, 1.0f),
                               .unlit = true,
                               .alphaMode = scene::AlphaMode::blend});
    scene::addInstance(scene, 0, 1, 1, {0.3, 0.0, -2.0}, glm::mat3(0.2f));
    const render::RenderOptions small = smallOptions(depth::parseTechnique("reversed"));
    for (const render::Antialias antialias : {render::Antialias::none, render::Antialias::edges}) {
        for (render::RenderOptions options : {small, withSorting(small)}) {
            options.effects = {.antialias = antialias, .finish = {.toneMap = render::ToneMap::neutral}};
            const render::Frame frame = draw(scene, scene::Camera{}, options);
            EXPECT_EQ(frame.color.at(options.width / 2, options.height / 2),
                      (image::Rgba8{255, 255, 255, 255}));
            EXPECT_EQ(frame.color.at(options.width * 9 / 16, options.height / 2),
                      (image::Rgba8{0, 0, 0, 255}));
        }
    }
}

TEST_F(FinishTest, ExposureOutOfRangeIsRefused) {
    render::RenderOptions options = smallOptions(depth::parseTechnique("reversed"));
    for (const double stops : {17.0, -17.0, static_cast<double>(NAN)}) {
        options.effects.finish.exposure = stops;
        EXPECT_THROW(draw(brightScene(), kCamera, options), base::InputError) << stops;
    }
}

/// Matt and shiny, in the G-buffer and in a visibility buffer. The truth sums over directions of the sky.
TEST_F(FinishTest, SkiesLightAsInFloat64) {
    scene::Scene scene = brightScene();
    scene.lights.clear();
    scene.sky = scene::Sky{.up = glm::normalize(glm::dvec3(0.2, 1.0, 0.3))};
    render::RenderOptions options = quarterOf(smallOptions(depth::parseTechnique("reversed")));
    options.effects.finish.toneMap = render::ToneMap::none;
    const auto expectAlike = [&](int most) {
        const auto truth = layersOf(scene, kCamera, options.width, options.height);
        options.surface = render::SurfacePath::gbuffer;
        EXPECT_LE(largestStepTo(truth, {}, draw(scene, kCamera, options).color), most);
        options.surface = render::SurfacePath::visibility;
        EXPECT_LE(largestStepTo(truth, {}, draw(scene, kCamera, options).color), most);
    };
    expectAlike(2);
    scene.materials[0].metallicRoughness = scene::MetallicRoughness{.metallic = 0.0f, .roughness = 0.5f};
    expectAlike(12);
    scene.materials[0].metallicRoughness = scene::MetallicRoughness{.metallic = 1.0f, .roughness = 0.3f};
    expectAlike(25);
}

/// The tone mapper bleaches emission by how bright it is, so one that is not cut off at 16 is another colour.
TEST_F(FinishTest, StrongEmissionIsCutOffAsInFloat64) {
    scene::Scene scene = brightScene();
    scene.lights.clear();
    scene.sky = scene::Sky{};
    scene.materials[0].detail.emission = glm::vec3(100.0f, 0.0f, 0.0f);
    const render::RenderOptions options =
        withSorting(quarterOf(smallOptions(depth::parseTechnique("reversed"))));
    for (const bool unlit : {false, true}) {
        for (const scene::AlphaMode alphaMode : {scene::AlphaMode::opaque, scene::AlphaMode::blend}) {
            scene.materials[0].unlit = unlit;
            scene.materials[0].alphaMode = alphaMode;
            scene.materials[0].baseColorFactor.a = 0.75f;
            const auto truth = layersOf(scene, kCamera, options.width, options.height);
            EXPECT_LE(largestStepTo(truth, {.neutral = true}, draw(scene, kCamera, options).color), 3)
                << "unlit: " << unlit << ", alpha mode: " << static_cast<int>(alphaMode);
        }
    }
}

/// Surfaces that do not emit keep their light above 16, which the tone mapper shows, where others may emit.
TEST_F(FinishTest, WhatDoesNotEmitLooksTheSameWhereOthersMay) {
    scene::Scene scene = brightScene();
    scene.lights[0].color = glm::vec3(400.0f, 100.0f, 50.0f);
    render::RenderOptions options = smallOptions(depth::parseTechnique("reversed"));
    options.effects.finish.toneMap = render::ToneMap::neutral;
    const std::string alone = hashOf(draw(scene, kCamera, options));
    options.prepareFor.emission = true;
    EXPECT_EQ(hashOf(draw(scene, kCamera, options)), alone);
}

} // namespace

} // namespace cdr::render_test
