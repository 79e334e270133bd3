#include "../support/picture_comparison.h"
#include "fixture.h"

#include <cdr/base/error.h>
#include <cdr/scene/world/world.h>
#include <scenes/cubes.h>
#include <scenes/open_scene.h>

#include <cstring>
#include <string>
#include <vector>

namespace cdr::render_test {

namespace {

using render::SurfacePath;
using render::TargetsKind;

render::RenderOptions optionsOf(const char* technique, SurfacePath surface) {
    render::RenderOptions options = smallOptions(depth::parseTechnique(technique));
    options.surface = surface;
    return options;
}

/// Roundings aside, as on a visibility buffer; a plane seen edge-on has a few pixels with larger ones.
constexpr test::Tolerance kRoundings{.channel = 3, .pixelShare = 0.0005};

bool hasTheSameSurfaces(const render::Frame& a, const render::Frame& b) {
    const auto& pixels = a.gbuffer.pixels;
    return pixels.size() == b.gbuffer.pixels.size() &&
           std::memcmp(pixels.data(), b.gbuffer.pixels.data(), pixels.size() * sizeof(pixels[0])) == 0;
}

class LitSurfacesTest : public RenderTest {
  protected:
    /// Draws a frame of the technique lit while it is drawn, and another from a visibility buffer, and compares them.
    void expectAlike(const scene::Scene& scene, const scene::Camera& camera, const char* technique,
                     const render::Effects& effects = {}) {
        render::RenderOptions options = optionsOf(technique, SurfacePath::lit);
        options.effects = effects;
        const render::Frame lit = draw(scene, camera, options);
        options.surface = SurfacePath::visibility;
        const render::Frame deferred = draw(scene, camera, options);
        EXPECT_TRUE(hasTheSameSurfaces(lit, deferred)) << technique;
        const test::Comparison difference = test::compare(deferred.color, lit.color, kRoundings);
        EXPECT_TRUE(difference.passes) << technique << ": " << describe(difference);
        EXPECT_EQ(messageCount(), 0u);
    }
};

TEST_F(LitSurfacesTest, LookAsIfTheyWereShadedLater) {
    for (const char* name : {"cubes", "afc", "rotation", "mixed"}) {
        SCOPED_TRACE(name);
        const scene::SceneSetup setup = scenes::openScene(name, 2013).setup;
        if (!readsFacetsOf(setup.scene)) {
            leaveOut("texels for as many facets");
            continue;
        }
        for (const auto& [preset, technique] : depth::presets()) {
            expectAlike(setup.scene, setup.path.at(0), std::string(preset).c_str());
        }
    }
}

TEST_F(LitSurfacesTest, LookAlikeWithEachNumberOfLightsAndEachMaterial) {
    scene::SceneSetup setup = scenes::makeRotation(5, 6'000);
    scene::Scene& scene = setup.scene;
    scene.background = glm::vec3(0.1f, 0.3f, 0.6f);
    scene.materials.push_back(
        {.name = "unlit", .baseColorFactor = glm::vec4(0.2f, 0.5f, 0.9f, 1.0f), .unlit = true});
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        scene.instances.material[i] = i % 4 == 0 ? 1 : 0;
        if (i % 5 == 0) {
            scene.instances.basis[i][0] = -scene.instances.basis[i][0];
        }
    }
    const scene::Camera camera = setup.path.at(90);
    const scene::PointLight first = scene.lights.front();
    scene::PointLight second = first;
    second.position = camera.position + 3.0 * camera.right;
    second.color = glm::vec3(0.9f, 0.2f, 0.1f);
    second.halfDistance = 1e30; // it does not fall off
    for (const std::vector<scene::PointLight>& lights :
         {std::vector<scene::PointLight>{}, {first}, {first, second}}) {
        SCOPED_TRACE(lights.size());
        scene.lights = lights;
        expectAlike(scene, camera, "anchored");
        expectAlike(scene, camera, "log", {.finish = {.toneMap = render::ToneMap::neutral, .exposure = 1.0}});
    }
}

TEST_F(LitSurfacesTest, ShowOnePictureHoweverTheyAreDrawn) {
    const scene::SceneSetup setup = scenes::makeRotation(3, 20'000);
    const render::GpuScene gpuScene(device(), setup.scene);
    for (const char* technique : {"cdr", "anchored", "log"}) {
        std::string first;
        for (const std::size_t threads : {1u, 4u}) {
            for (const render::Submission submission :
                 {render::Submission::secondaries, render::Submission::primaries}) {
                render::RenderOptions options = optionsOf(technique, SurfacePath::lit);
                options.threads = threads;
                options.submission = submission;
                options.framesInFlight = threads;
                render::Renderer renderer(device(), setup.scene, gpuScene, options);
                renderer.submit(setup.path.at(3));
                const render::Frame all = renderer.render(setup.path.at(33));
                const std::string hash = hashOf(all);
                first = first.empty() ? hash : first;
                EXPECT_EQ(hash, first) << technique << " " << threads << " " << nameOf(submission);
                // A frame whose G-buffer nobody reads shows the same.
                const render::Frame colors = renderer.render(setup.path.at(33), render::FrameCopy::color);
                EXPECT_EQ(colors.color.pixels, all.color.pixels);
            }
        }
    }
}

TEST_F(LitSurfacesTest, AreRightInOnePass) {
    scene::SceneSetup setup = scenes::makeAfc(2013);
    setup.scene.background = glm::vec3(0.1f, 0.3f, 0.6f);
    render::RenderOptions options = optionsOf("anchored", SurfacePath::lit);
    options.targets = TargetsKind::onePass;
    const render::Frame frame = draw(setup.scene, setup.path.at(9), options);
    EXPECT_EQ(wrongIn(frame, setup.scene, setup.path.at(9)).wrong, 0u);
    options.surface = SurfacePath::visibility;
    const test::Comparison difference =
        test::compare(draw(setup.scene, setup.path.at(9), options).color, frame.color, kRoundings);
    EXPECT_TRUE(difference.passes) << describe(difference);
}

TEST_F(LitSurfacesTest, SayWhyTheyCannotBe) {
    scene::SceneSetup setup = scenes::makeRotation(3, 100);
    const render::RenderOptions plain = optionsOf("standard", SurfacePath::lit);
    const auto expectRefusal = [&](const render::RenderOptions& options, const char* word) {
        EXPECT_NE(refusalOf(setup.scene, options).find(word), std::string::npos) << word;
    };
    EXPECT_EQ(refusalOf(setup.scene, plain), "none");
    render::RenderOptions options = plain;
    options.targets = TargetsKind::pool;
    expectRefusal(options, "targets");
    options = plain;
    options.submission = render::Submission::gpuDriven;
    expectRefusal(options, "gpu-driven");
    options = plain;
    options.effects.fog.visibility = 100.0;
    expectRefusal(options, "fog");
    options = plain;
    options.effects.antialias = render::Antialias::edges;
    expectRefusal(options, "antialiasing");
    options = plain;
    options.shadows.method = render::ShadowMethod::anchored;
    expectRefusal(options, "shadows");
    options = plain;
    options.prepareFor.lights = 3;
    expectRefusal(options, "two lights");
    setup.scene.lights.resize(3, setup.scene.lights.front());
    expectRefusal(plain, "two lights");
    setup.scene.lights.resize(1);
    setup.scene.lights.front().range = 100.0;
    expectRefusal(plain, "ranges");
    setup.scene.lights.clear();
    setup.scene.sky = scene::Sky{};
    expectRefusal(plain, "sky");
    setup.scene.sky.reset();
    setup.scene.materials[0].metallicRoughness = scene::MetallicRoughness{};
    expectRefusal(plain, "matt");
}

TEST_F(LitSurfacesTest, FollowTheLightsOfAWorld) {
    scene::SceneSetup setup = scenes::makeRotation(3, 2'000);
    const scene::Camera camera = setup.path.at(0);
    const scene::PointLight light = setup.scene.lights.front();
    scene::World world(setup.scene);
    SoleRenderer renderer(device(), world, optionsOf("anchored", SurfacePath::lit));
    const std::string one = hashOf(renderer.render(camera));
    const scene::LightHandle second = world.addLight(light);
    const std::string two = hashOf(renderer.render(camera));
    EXPECT_NE(two, one);
    const scene::LightHandle third = world.addLight(light);
    EXPECT_THROW(renderer.render(camera), base::InputError);
    world.removeLight(third);
    EXPECT_EQ(hashOf(renderer.render(camera)), two);
    world.removeLight(second);
    EXPECT_EQ(hashOf(renderer.render(camera)), one);
}

} // namespace

} // namespace cdr::render_test
