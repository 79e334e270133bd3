#include "fixture.h"

#include <cdr/gpu/pipeline.h>
#include <scenes/cubes.h>

#include <memory>
#include <vector>

namespace cdr::render_test {

namespace {

using SharedPipelinesTest = RenderTest;

/// How many pipelines the device made so far.
std::uint64_t pipelinesMade(const gpu::Device& device) {
    return device.pipelineObjects().graphics.made() + device.pipelineObjects().compute.made();
}

/// Options that have a pipeline of each pass, between them.
std::vector<render::RenderOptions> optionsOfAllPasses() {
    render::RenderOptions plain = smallOptions(depth::parseTechnique("anchored"));
    plain.motion = true;
    render::RenderOptions lit = plain;
    lit.effects = {
        .antialias = render::Antialias::edges, .occlusion = {.radius = 2.0}, .fog = {.visibility = 1e5}};
    lit.translucency.method = render::Translucency::sorted;
    render::RenderOptions culled = plain;
    culled.occlusionCulling = true;
    culled.shadows.method = render::ShadowMethod::anchored;
    render::RenderOptions facets = plain;
    facets.surface = render::SurfacePath::visibility;
    render::RenderOptions focused = smallOptions(depth::parseTechnique("cdr"));
    focused.targets = render::TargetsKind::layers;
    focused.focus = {.distance = 10.0, .aperture = 0.1};
    std::vector<render::RenderOptions> all{plain, lit, culled, facets, focused};
    for (const render::TargetsKind kind : render::kTargetsKinds) {
        all.push_back(plain);
        all.back().targets = kind;
    }
    return all;
}

/// A scene that blends and shines, as far as the surfaces are kept in a G-buffer.
scene::Scene withGlass(scene::Scene scene) {
    scene.materials.push_back({.name = "glass",
                               .baseColorFactor = glm::vec4(0.5f),
                               .shine = scene::Shine{.metallic = 0.5f, .roughness = 0.4f},
                               .alphaMode = scene::AlphaMode::blend});
    scene::addInstance(scene, 0, static_cast<std::uint32_t>(scene.materials.size() - 1), 0,
                       scene.instances.position(0), glm::mat3(1.0f));
    return scene;
}

TEST_F(SharedPipelinesTest, ResizingMakesNoPipelines) {
    const scene::SceneSetup setup = scenes::makeAfc(1);
    const scene::Camera camera = setup.path.at(7);
    for (render::RenderOptions options : optionsOfAllPasses()) {
        const bool hasFacets = options.surface == render::SurfacePath::visibility;
        const scene::Scene scene = hasFacets ? setup.scene : withGlass(setup.scene);
        const render::GpuScene gpuScene(device(), scene);
        for (const render::Submission submission : submissions()) {
            if (submission == render::Submission::gpuDriven && hasFacets) {
                continue;
            }
            options.submission = submission;
            render::Renderer renderer(device(), scene, gpuScene, options);
            renderer.draw(camera);
            const std::uint64_t before = pipelinesMade(device());
            renderer.resize(200, 100);
            renderer.draw(camera);
            EXPECT_EQ(pipelinesMade(device()), before) << render::nameOf(submission);
        }
    }
}

/// They share them, in whatever order they come and go.
TEST_F(SharedPipelinesTest, ASecondRendererOfTheSameOptionsMakesNoPipelines) {
    const scene::SceneSetup setup = scenes::makeAfc(1);
    const render::GpuScene gpuScene(device(), setup.scene);
    const auto options = smallOptions(depth::parseTechnique("anchored"));
    const scene::Camera camera = setup.path.at(7);
    auto first = std::make_unique<render::Renderer>(device(), setup.scene, gpuScene, options);
    const std::string picture = hashOf(first->render(camera));
    const std::uint64_t before = pipelinesMade(device());
    render::Renderer second(device(), setup.scene, gpuScene, options);
    EXPECT_EQ(hashOf(second.render(camera)), picture);
    EXPECT_EQ(pipelinesMade(device()), before);
    first.reset();
    EXPECT_EQ(hashOf(second.render(camera)), picture);
}

} // namespace

} // namespace cdr::render_test
