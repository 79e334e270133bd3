#include "../support/all_cases.h"
#include "fixture.h"

#include <cdr/gpu/pipeline.h>
#include <cdr/shaders/shared.h>
#include <scenes/cubes.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace cdr::render_test {

namespace {

using SharedPipelinesTest = OwnPipelinesTest;

/// How many pipelines the device made so far.
std::uint64_t pipelinesMade(const gpu::Device& device) {
    const gpu::PipelineObjects& objects = gpu::pipelineObjects(device);
    return objects.graphics.made() + objects.compute.made();
}

/// Options that have a pipeline of each pass, between them.
std::vector<render::RenderOptions> optionsOfAllPasses() {
    render::RenderOptions plain = thumbnailOptions(depth::parseTechnique("anchored"));
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
    render::RenderOptions focused = thumbnailOptions(depth::parseTechnique("cdr"));
    focused.targets = render::TargetsKind::layers;
    focused.focus = {.distance = 10.0, .aperture = 0.1};
    std::vector<render::RenderOptions> all{plain, lit, culled, facets, focused};
    for (const render::TargetsKind kind : render::kTargetsKinds) {
        all.push_back(plain);
        all.back().targets = kind;
    }
    return all;
}

/// A scene that blends, with and without detail, and shines, as far as the surfaces are kept in a G-buffer.
scene::Scene withGlass(scene::Scene scene) {
    const scene::Material glass{.name = "glass",
                                .baseColorFactor = glm::vec4(0.5f),
                                .metallicRoughness =
                                    scene::MetallicRoughness{.metallic = 0.5f, .roughness = 0.4f},
                                .alphaMode = scene::AlphaMode::blend};
    const glm::dvec3 where =
        scene.instances.size() > 0 ? scene.instances.position(0) : glm::dvec3(0.0, 0.0, -5.0);
    for (const float glow : {0.0f, 0.5f}) {
        scene.materials.push_back(glass);
        scene.materials.back().detail.emission = glm::vec3(glow);
        scene::addInstance(scene, 0, static_cast<std::uint32_t>(scene.materials.size() - 1), 0, where,
                           glm::mat3(1.0f));
    }
    return scene;
}

TEST_F(SharedPipelinesTest, ResizingMakesNoPipelines) {
    const scene::SceneSetup setup = scenes::makeAfc(1);
    const scene::Scene withSheets = withGlass(setup.scene);
    const render::GpuScene facets(device(), setup.scene);
    const render::GpuScene sheets(device(), withSheets);
    const scene::Camera camera = setup.path.at(7);
    std::size_t turn = 0;
    for (render::RenderOptions options : optionsOfAllPasses()) {
        const bool hasFacets = options.surface == render::SurfacePath::visibility;
        const scene::Scene& scene = hasFacets ? setup.scene : withSheets;
        const render::GpuScene& gpuScene = hasFacets ? facets : sheets;
        for (const render::Submission submission : test::sampleOf(submissions(), turn++)) {
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

TEST_F(SharedPipelinesTest, AddingToAWorldWhatItHasTheKindOfMakesNone) {
    scene::Scene scene = withGlass(boxScene());
    scene.textures.push_back({.name = "white", .pixels = image::ImageRgba8(1, 1, {255, 255, 255, 255})});
    scene.materials.push_back({.name = "textured", .baseColorTexture = 0});
    for (std::uint32_t material = 0; material < scene.materials.size(); ++material) {
        scene::addInstance(scene, 0, material, material, {material - 1.0, 0.0, -5.0}, glm::mat3(1.0f));
    }
    for (const render::Submission submission : submissions()) {
        scene::World world(scene);
        render::RenderOptions options = thumbnailOptions(depth::parseTechnique("anchored"));
        options.submission = submission;
        SoleRenderer renderer(device(), world, options);
        renderer.draw({});
        const std::uint64_t before = pipelinesMade(device());
        scene::Material textured = scene.materials.back();
        textured.baseColorTexture = world.addTexture(scene.textures[0]).index;
        const scene::MeshHandle mesh = world.addMesh(scene::makeBox(glm::vec3(0.3f)));
        world.addInstance({.mesh = mesh,
                           .material = world.addMaterial(textured),
                           .object = 7,
                           .transform = {.position = {0.0, 1.0, -4.0}}});
        const image::ImageU32 ids = renderer.render({}).ids();
        EXPECT_GT(std::count(ids.pixels.begin(), ids.pixels.end(), 8u), 0);
        EXPECT_EQ(pipelinesMade(device()), before) << render::nameOf(submission);
        // Shading has one for each number of lights up to kFlatLights, and one for more.
        for (std::uint32_t light = 0; light < shaders::kFlatLights + 4; ++light) {
            world.addLight({.position = {0.0, 5.0, 0.0}, .halfDistance = 10.0});
            renderer.draw({});
        }
        EXPECT_LE(pipelinesMade(device()), before + shaders::kFlatLights);
    }
}

/// What a renderer is prepared for comes without passes or pipelines of its own, except for those of its kind of draws. Two
/// materials with each submission are compared with a renderer that has it from the start, or all with CDR_ALL_CASES.
TEST_F(SharedPipelinesTest, APreparedRendererKeepsItsPasses) {
    std::uint32_t compared = 1;
    for (const render::Submission submission : submissions()) {
        scene::World world(boxScene());
        const scene::MeshHandle mesh = world.mesh(0);
        render::RenderOptions options = thumbnailOptions(depth::parseTechnique("anchored"));
        options.submission = submission;
        options.prepareFor = {
            .metallicRoughness = true, .blended = true, .emission = true, .lights = 7, .shapedLights = true};
        SoleRenderer renderer(device(), world, options);
        renderer.draw({});
        const auto color = renderer.surfaces().color.image;
        std::uint32_t object = 0;
        for (const scene::Material& material :
             {scene::Material{.baseColorFactor = glm::vec4(0.5f), .alphaMode = scene::AlphaMode::blend},
              scene::Material{.metallicRoughness =
                                  scene::MetallicRoughness{.metallic = 0.5f, .roughness = 0.4f}},
              scene::Material{.metallicRoughness =
                                  scene::MetallicRoughness{.metallic = 0.9f, .roughness = 0.2f},
              .alphaMode = scene::AlphaMode::blend},
              scene::Material{.detail = {.emission = glm::vec3(0.5f)}}}) {
            const scene::InstanceHandle instance =
                world.addInstance({.mesh = mesh,
                                   .material = world.addMaterial(material),
                                   .object = object++,
                                   .transform = {.position = {object - 2.0, 0.0, -4.0}}});
            renderer.draw({});
            EXPECT_EQ(renderer.surfaces().color.image, color) << nameOf(submission);
            if (test::takesAllCases() || object == compared || object == compared + 2) {
                EXPECT_EQ(hashOf(renderer.render({})), hashOf(draw(world.scene(), {}, options)));
            }
            const std::uint64_t before = pipelinesMade(device());
            world.removeInstance(instance);
            renderer.draw({});
            EXPECT_EQ(pipelinesMade(device()), before);
        }
        const std::uint64_t before = pipelinesMade(device());
        for (int light = 0; light < 6; ++light) {
            world.addLight({.position = {0.0, 5.0, 0.0}, .halfDistance = 10.0});
            renderer.draw({});
        }
        world.addLight({.position = {0.0, 5.0, 0.0}, .halfDistance = 10.0, .range = 20.0});
        renderer.draw({});
        EXPECT_EQ(pipelinesMade(device()), before);
        EXPECT_EQ(renderer.surfaces().color.image, color);
        EXPECT_EQ(hashOf(renderer.render({})), hashOf(draw(world.scene(), {}, options)));
        ++compared;
    }
}

/// The kinds of draws that materials like those lead to have their pipelines from the start, on any mesh.
TEST_F(SharedPipelinesTest, ARendererThatIsPreparedForMaterialsMakesNone) {
    scene::Scene scene = boxScene();
    scene.textures.push_back({.name = "white", .pixels = image::ImageRgba8(2, 2, {255, 255, 255, 255})});
    scene.textures.push_back(scene.textures[0]);
    scene.textures[1].content = scene::TextureContent::data;
    const scene::TextureUse use{.texture = 0, .second = false};
    const scene::TextureUse data{.texture = 1, .second = false};
    const std::vector<scene::Material> materials{
        {.name = "plain"},
        {.name = "both sides", .doubleSided = true},
        {.name = "textured", .baseColorTexture = 0},
        {.name = "cut out", .baseColorTexture = 0, .alphaMode = scene::AlphaMode::mask},
        {.name = "paint", .layer = 0.01f},
        {.name = "glass", .alphaMode = scene::AlphaMode::blend},
        {.name = "lamp", .detail = {.emissive = use, .emission = glm::vec3(0.5f)}},
        {.name = "shining glass",
         .metallicRoughness = scene::MetallicRoughness{.metallic = 0.5f, .roughness = 0.4f},
         .alphaMode = scene::AlphaMode::blend,
         .detail = {.normal = use}},
        {.name = "packed",
         .baseColorTexture = 0,
         .detail = {.metallicRoughness = data, .normal = data, .occlusion = data, .emissive = use}}};
    scene::Mesh round = scene::makeBox(glm::vec3(0.3f));
    for (scene::Vertex& vertex : round.vertices) {
        vertex.normal = glm::normalize(vertex.position);
    }
    const std::vector<render::Translucency> methods(render::kTranslucencies.begin(),
                                                    render::kTranslucencies.end());
    std::size_t turn = 0;
    for (const render::Submission submission : submissions()) {
        for (const render::Translucency method : test::sampleOf(methods, turn++)) {
            scene::World world(scene);
            render::RenderOptions options = thumbnailOptions(depth::parseTechnique("anchored"));
            options.submission = submission;
            options.translucency.method = method;
            options.prepareFor.materials = materials;
            SoleRenderer renderer(device(), world, options);
            renderer.draw({});
            const auto color = renderer.surfaces().color.image;
            const std::uint64_t before = pipelinesMade(device());
            std::uint32_t object = 1;
            for (const scene::MeshHandle mesh : {world.mesh(0), world.addMesh(round)}) {
                for (scene::Material material : materials) {
                    material.baseColorFactor = glm::vec4(0.5f);
                    world.addInstance({.mesh = mesh,
                                       .material = world.addMaterial(material),
                                       .object = object,
                                       .transform = {.position = {0.4 * object - 3.0, 0.0, -6.0}}});
                    ++object;
                    renderer.draw({});
                    EXPECT_EQ(pipelinesMade(device()), before)
                        << material.name << ", " << nameOf(submission) << ", " << nameOf(method);
                }
            }
            EXPECT_EQ(renderer.surfaces().color.image, color);
            EXPECT_EQ(hashOf(renderer.render({})), hashOf(draw(world.scene(), {}, options)));
        }
    }
}

TEST_F(SharedPipelinesTest, PreparingForTooManyLightsIsRefused) {
    render::RenderOptions options = thumbnailOptions(depth::parseTechnique("anchored"));
    options.prepareFor.lights = render::kMaxPreparedLights + 1;
    EXPECT_THROW(draw(boxScene(), {}, options), base::InputError);
}

/// They share them, in whatever order they come and go.
TEST_F(SharedPipelinesTest, ASecondRendererOfTheSameOptionsMakesNoPipelines) {
    const scene::SceneSetup setup = scenes::makeAfc(1);
    const render::GpuScene gpuScene(device(), setup.scene);
    const auto options = thumbnailOptions(depth::parseTechnique("anchored"));
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
