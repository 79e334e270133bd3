#include "../../support/all_cases.h"
#include "../fixture.h"
#include "editor.h"

#include <cdr/base/error.h>
#include <cdr/render/uploaded_scene.h>

#include <array>
#include <memory>
#include <numeric>
#include <random>
#include <string>

namespace cdr::render_test {

namespace {

using render::Submission;
using render::TargetsKind;

scene::Camera ahead() {
    scene::Camera camera;
    camera.nearView = 1.0;
    camera.farView = 1000.0;
    return camera;
}

render::RenderOptions optionsFor(const char* technique, Submission submission, TargetsKind targets,
                                 std::size_t threads, std::size_t framesInFlight) {
    return {.width = 128,
            .height = 72,
            .technique = depth::parseTechnique(technique),
            .targets = targets,
            .threads = threads,
            .submission = submission,
            .detail = {.mode = visibility::DetailMode::perObject, .pixels = 2.0},
            .framesInFlight = framesInFlight};
}

using WorldTest = OwnPipelinesTest;

/// The rule of live worlds: after any edits, drawn in any way, the picture is that of a scene that is built from scratch.
/// Blended fragments are counted, so each is drawn once. Groups of renderers take turns and so lag behind by a batch.
TEST_F(WorldTest, AnyEditsGiveThePictureOfASceneBuiltAnew) {
    const int batches = test::takesAllCases() ? 28 : 14; // each kind of tables with each group
    constexpr int kEdits = 500;
    World world;
    Editor editor(2013, world);
    editor.populate(150);
    render::GpuScene onDevice(device(), world);
    using Group = std::vector<std::unique_ptr<render::Renderer>>;
    std::array<Group, 2> groups;
    for (const render::RenderOptions& options :
         {optionsFor("cdr", Submission::secondaries, TargetsKind::single, 1, 1),
          optionsFor("cdr", Submission::primaries, TargetsKind::accumulate, 8, 3),
          optionsFor("cdr", Submission::gpuDriven, TargetsKind::pool, 2, 3)}) {
        if (options.submission == Submission::gpuDriven && !canDrawGpuDriven()) {
            continue;
        }
        groups[0].push_back(std::make_unique<render::Renderer>(device(), onDevice, options));
    }
    for (render::RenderOptions options :
         {optionsFor("anchored", Submission::secondaries, TargetsKind::layers, 16, 2),
          optionsFor("anchored", Submission::gpuDriven, TargetsKind::single, 1, 1)}) {
        if (options.submission == Submission::gpuDriven && !canDrawGpuDriven()) {
            continue;
        }
        options.translucency = {.method = render::Translucency::sorted, .countsFragments = true};
        groups[1].push_back(std::make_unique<render::Renderer>(device(), onDevice, options));
    }
    std::uint64_t blendedFragments = 0;
    const auto expectThePictureOfASceneBuiltAnew = [&](const Group& group) {
        const render::Frame wanted = draw(editor.expected().build(), ahead(), group.front()->options());
        for (std::size_t i = 0; i < group.size(); ++i) {
            group[i]->forgetFrames();
            const render::Frame frame = group[i]->render(ahead());
            ASSERT_EQ(hashOf(frame), hashOf(wanted)) << "renderer " << i;
            blendedFragments += std::accumulate(frame.fragmentCounts.pixels.begin(),
                                                frame.fragmentCounts.pixels.end(), std::uint64_t{0});
            ASSERT_EQ(frame.stats.draws, wanted.stats.draws);
        }
        ASSERT_EQ(messageCount(), 0u);
    };
    for (int batch = 0; batch < batches; ++batch) {
        Group& group = groups[static_cast<std::size_t>(batch % 2)];
        // Half a batch, frames that nobody waits for, and the other half while these are in flight. Moves alone, and what
        // removes nothing from a table, go to the device by other ways than the rest.
        const auto first = batch / 2 % 2 == 0 ? Editor::Scope::all : Editor::Scope::instances;
        const auto second = batch / 2 % 3 == 0 ? Editor::Scope::moves : Editor::Scope::all;
        for (int half = 0; half < 2; ++half) {
            for (int i = 0; i < kEdits / 2; ++i) {
                editor.edit(half == 0 ? first : second);
            }
            for (const auto& renderer : group) {
                renderer->submit(ahead());
            }
        }
        SCOPED_TRACE("batch " + std::to_string(batch));
        ASSERT_NO_FATAL_FAILURE(expectThePictureOfASceneBuiltAnew(group));
        // Tables that change in one way alone: what follows another change would hide that this one is not followed.
        const auto kind = static_cast<std::size_t>(batch) % Editor::kTableKinds;
        SCOPED_TRACE("tables, kind " + std::to_string(kind));
        for (int i = 0; i < (kind < Editor::kFirstRemoval ? 4 : 1); ++i) {
            editor.editTables(kind);
        }
        ASSERT_NO_FATAL_FAILURE(expectThePictureOfASceneBuiltAnew(group));
    }
    EXPECT_GT(blendedFragments, 0u);
}

/// As undo does it: a copy takes the world's place. An edit each, so that as much was edited after as before.
TEST_F(WorldTest, AnAssignedWorldIsDrawnAsItIs) {
    World world;
    Editor editor(11, world, Editor::Palette::facets);
    editor.populate(60);
    editor.editTables(3);
    render::GpuScene onDevice(device(), world);
    std::vector<std::unique_ptr<render::Renderer>> renderers;
    for (const Submission submission : submissions()) {
        render::RenderOptions options = optionsFor("anchored", submission, TargetsKind::single, 2, 1);
        options.motion = true;
        renderers.push_back(std::make_unique<render::Renderer>(device(), onDevice, options));
    }
    render::RenderOptions facets = optionsFor("anchored", Submission::secondaries, TargetsKind::single, 2, 2);
    facets.surface = render::SurfacePath::visibility;
    facets.detail = {};
    renderers.push_back(std::make_unique<render::Renderer>(device(), onDevice, facets));
    const auto expectThePictureOfASceneBuiltAnew = [&] {
        for (const auto& renderer : renderers) {
            const render::Frame wanted = draw(editor.expected().build(), ahead(), renderer->options());
            const render::Frame frame = renderer->render(ahead());
            EXPECT_EQ(hashOf(frame), hashOf(wanted));
            EXPECT_EQ(frame.motion.pixels, wanted.motion.pixels) << "what is new has not moved";
        }
    };
    for (const int edits : {1, 3, 200}) {
        SCOPED_TRACE(std::to_string(edits) + " edits");
        expectThePictureOfASceneBuiltAnew();
        const World saved = world;
        Editor undone = editor;
        for (int i = 0; i < edits; ++i) {
            undone.edit(edits == 1 ? Editor::Scope::moves : Editor::Scope::all);
        }
        if (edits == 3) {
            undone.populate(70); // so that fewer are there afterwards
        }
        for (const auto& renderer : renderers) {
            renderer->render(ahead());
        }
        world = saved;
        for (int i = 0; i < edits; ++i) {
            editor.edit(Editor::Scope::moves);
        }
        expectThePictureOfASceneBuiltAnew();
        ASSERT_EQ(messageCount(), 0u);
    }
}

template <typename Values>
auto oneOf(std::mt19937_64& random, const Values& values) {
    return values[std::uniform_int_distribution<std::size_t>(0, std::size(values) - 1)(random)];
}

/// Shadows, a lens with a focus, motion and effects, as far as these go with the rest.
void addEffects(std::mt19937_64& random, render::RenderOptions& options) {
    const auto isDrawn = [&](int outOf) { return std::uniform_int_distribution<int>(1, outOf)(random) == 1; };
    options.effects.antialias = oneOf(random, render::kAntialiases);
    options.effects.fog.visibility = isDrawn(2) ? 500.0 : 0.0;
    if (isDrawn(4)) {
        options.targets = TargetsKind::layers;
        options.occlusionCulling = false;
        options.focus = {.distance = 20.0, .aperture = 0.2};
        return;
    }
    options.motion = isDrawn(2);
    options.effects.occlusion.radius = isDrawn(2) ? 2.0 : 0.0;
    options.effects.occlusion.perLayer = render::hasLayers(options.targets.kind) && isDrawn(2);
    if (isDrawn(2)) {
        if (!render::castsShadows(options.detail.mode)) {
            options.detail.mode = visibility::DetailMode::perObject;
        }
        options.shadows = {.method = render::ShadowMethod::anchored, .maxTexels = 64};
    }
}

/// Random options, of those that can be combined.
render::RenderOptions randomOptions(std::mt19937_64& random, const std::vector<Submission>& submissions) {
    constexpr std::array kTechniques{"standard", "cdr", "logcdr", "reversed", "anchored"};
    constexpr std::array<std::size_t, 5> kThreads{1, 2, 3, 8, 16};
    constexpr std::array<std::size_t, 3> kInFlight{1, 2, 3};
    constexpr std::array kYesOrNo{false, true};
    render::RenderOptions options =
        optionsFor(oneOf(random, kTechniques), oneOf(random, submissions),
                   oneOf(random, render::kTargetsKinds), oneOf(random, kThreads), oneOf(random, kInFlight));
    options.batching = oneOf(random, render::kBatchings);
    options.translucency = {.method = oneOf(random, render::kTranslucencies), .countsFragments = true};
    options.occlusionCulling = oneOf(random, kYesOrNo);
    if (oneOf(random, kYesOrNo)) {
        options.detail.mode = visibility::DetailMode::perCascade;
    }
    addEffects(random, options);
    options.linear = oneOf(random, kYesOrNo);
    return options;
}

std::string describe(const render::RenderOptions& options) {
    std::string text = depth::nameOf(options.technique);
    for (const std::string_view name :
         {render::nameOf(options.submission), render::nameOf(options.targets.kind),
          render::nameOf(options.batching), render::nameOf(options.translucency.method),
          render::nameOf(options.shadows.method)}) {
        text.append(", ").append(name);
    }
    const auto said = [](bool is, const char* what) { return is ? what : ""; };
    return text + said(options.occlusionCulling, ", occlusion culling") + said(options.motion, ", motion") +
           said(options.linear, ", linear light") + said(options.focus.isOn(), ", focus") +
           said(options.effects.occlusion.radius > 0.0, ", ambient occlusion") +
           said(options.effects.occlusion.perLayer, " per cascade") + ", " + std::to_string(options.threads) +
           " threads, " + std::to_string(options.framesInFlight) + " in flight";
}

/// The same rule for renderers of random options, seen from changing places. CDR_ALL_CASES takes more seeds.
TEST_F(WorldTest, RenderersOfAnyOptionsShowAnyEdits) {
    const std::uint64_t seeds = test::takesAllCases() ? 40 : 1;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        std::mt19937_64 random(seed);
        World world;
        Editor editor(seed, world);
        editor.populate(150);
        render::GpuScene onDevice(device(), world);
        std::vector<std::unique_ptr<render::Renderer>> renderers;
        for (int i = 0; i < 4; ++i) {
            const render::RenderOptions options = randomOptions(random, submissions());
            SCOPED_TRACE("seed " + std::to_string(seed) + ": " + describe(options));
            renderers.push_back(std::make_unique<render::Renderer>(device(), onDevice, options));
        }
        for (int batch = 0; batch < 5; ++batch) {
            scene::Camera camera = ahead();
            camera.position.x = std::uniform_real_distribution<double>(-30.0, 30.0)(random);
            for (int half = 0; half < 2; ++half) {
                // What tables have read again hides instances that were forgotten, so now and then none changes after these.
                const bool sparesTables = half == 0 || batch % 2 == 0;
                for (int i = 0; i < 125; ++i) {
                    editor.edit(sparesTables ? Editor::Scope::instances : Editor::Scope::all);
                }
                for (const auto& renderer : renderers) {
                    renderer->submit(camera);
                }
            }
            const scene::Scene built = editor.expected().build();
            for (const auto& renderer : renderers) {
                renderer->forgetFrames();
                const render::Frame frame = renderer->render(camera);
                const render::Frame wanted = draw(built, camera, renderer->options());
                ASSERT_EQ(hashOf(frame), hashOf(wanted))
                    << "seed " << seed << ", batch " << batch << ": " << describe(renderer->options());
                ASSERT_EQ(frame.motion.pixels, wanted.motion.pixels);
                ASSERT_EQ(frame.litMask.pixels, wanted.litMask.pixels);
            }
            ASSERT_EQ(messageCount(), 0u);
        }
    }
}

/// After every single edit, of which half change meshes, materials, textures or lights.
TEST_F(WorldTest, EachEditIsShownAtOnce) {
    gpu::keepPipelines(device()); // how they come and go is seen where any edits are drawn
    World world;
    Editor editor(77, world);
    editor.populate(40);
    render::GpuScene onDevice(device(), world);
    std::vector<std::unique_ptr<render::Renderer>> renderers;
    for (const Submission submission : submissions()) {
        renderers.push_back(std::make_unique<render::Renderer>(
            device(), onDevice, optionsFor("anchored", submission, TargetsKind::single, 2, 2)));
    }
    const std::size_t edits = test::takesAllCases() ? 150 : 50;
    for (std::size_t edit = 0; edit < edits; ++edit) {
        editor.editEvenly();
        const std::string wanted =
            hashOf(draw(editor.expected().build(), ahead(), renderers.front()->options()));
        for (std::size_t i = 0; i < renderers.size(); ++i) {
            // Each in turn is the first that draws after an edit.
            render::Renderer& renderer = *renderers[(edit + i) % renderers.size()];
            renderer.forgetFrames();
            ASSERT_EQ(hashOf(renderer.render(ahead())), wanted)
                << "edit " << edit << ", " << nameOf(renderer.options().submission);
        }
    }
}

/// A visibility buffer shows worlds of what it can show.
TEST_F(WorldTest, AVisibilityBufferFollowsEdits) {
    World world;
    Editor editor(5, world, Editor::Palette::facets);
    editor.populate(100);
    render::GpuScene onDevice(device(), world);
    std::vector<std::unique_ptr<render::Renderer>> renderers;
    for (render::RenderOptions options :
         {optionsFor("anchored", Submission::secondaries, TargetsKind::single, 1, 1),
          optionsFor("cdr", Submission::primaries, TargetsKind::layers, 4, 3)}) {
        options.surface = render::SurfacePath::visibility;
        options.occlusionCulling = options.threads == 1;
        renderers.push_back(std::make_unique<render::Renderer>(device(), onDevice, options));
    }
    for (int batch = 0; batch < 40; ++batch) {
        for (int half = 0; half < 2; ++half) {
            for (int i = 0; i < batch; ++i) {
                editor.editEvenly();
            }
            for (const auto& renderer : renderers) {
                renderer->submit(ahead());
            }
        }
        const scene::Scene built = editor.expected().build();
        for (const auto& renderer : renderers) {
            renderer->forgetFrames();
            ASSERT_EQ(hashOf(renderer->render(ahead())), hashOf(draw(built, ahead(), renderer->options())))
                << "batch " << batch << ", " << nameOf(renderer->options().submission);
        }
    }
}

/// What it cannot show is refused in each frame until it is gone, and nothing else is lost.
TEST_F(WorldTest, AVisibilityBufferRefusesWhatItCannotShow) {
    scene::Scene scene = boxScene();
    addBox(scene, {0.0, 0.0, -5.0});
    World world(scene);
    render::RenderOptions options =
        optionsFor("anchored", Submission::secondaries, TargetsKind::single, 1, 2);
    options.surface = render::SurfacePath::visibility;
    SoleRenderer renderer(device(), world, options);
    const std::string before = hashOf(renderer.render(ahead()));
    scene::Mesh bent = scene::makeBox(glm::vec3(0.5f));
    for (scene::Vertex& vertex : bent.vertices) {
        vertex.normal = glm::normalize(vertex.position);
    }
    const scene::MeshHandle mesh = world.addMesh(bent);
    for (const scene::Material& material :
         {scene::Material{.name = "plain"}, scene::Material{.alphaMode = scene::AlphaMode::blend},
          scene::Material{.detail = {.emission = glm::vec3(1.0f)}}, scene::Material{.layer = 1.0f}}) {
        const scene::MaterialHandle look = world.addMaterial(material);
        const scene::InstanceHandle instance = world.addInstance(
            {.mesh = mesh, .material = look, .object = 1, .transform = {.position = {1.0, 0.0, -4.0}}});
        EXPECT_THROW(renderer.render(ahead()), base::InputError);
        EXPECT_THROW(renderer.submit(ahead()), base::InputError);
        world.removeInstance(instance);
        world.removeMaterial(look);
        EXPECT_EQ(hashOf(renderer.render(ahead())), before);
    }
}

/// Draws of a larger mesh write more.
TEST_F(WorldTest, AVisibilityBufferMakesRoomForLargerMeshes) {
    scene::Scene scene = boxScene();
    scene.meshes[0].indices.resize(6); // one face
    scene.meshes[0].boxHalfSides.reset();
    constexpr int kBoxes = 600; // far more than there is room for at least
    for (int i = 0; i < kBoxes; ++i) {
        addBox(scene, {0.1 * (i % 30) - 1.5, 0.1 * (i / 30) - 1.0, -3.0});
    }
    World world(scene);
    render::RenderOptions options =
        optionsFor("anchored", Submission::secondaries, TargetsKind::single, 1, 1);
    options.surface = render::SurfacePath::visibility;
    SoleRenderer renderer(device(), world, options);
    renderer.draw(ahead());
    const scene::MeshHandle box = world.addMesh(scene::makeBox(glm::vec3(0.04f)));
    for (std::size_t i = 0; i < kBoxes; ++i) {
        const scene::InstanceHandle there = world.instance(i);
        world.addInstance({.mesh = box,
                           .material = world.material(0),
                           .object = static_cast<std::uint32_t>(i),
                           .transform = {.position = world.scene().instances.position(i)}});
        world.removeInstance(there);
    }
    renderer.forgetFrames();
    EXPECT_EQ(hashOf(renderer.render(ahead())), hashOf(draw(world.scene(), ahead(), options)));
}

/// What its vertices have beside themselves comes along, whether there was room for it or not.
TEST_F(WorldTest, AnAddedMeshHasItsDetails) {
    scene::Scene scene = boxScene();
    image::ImageRgba8 pixels(16, 1, {0, 0, 0, 255});
    for (std::size_t x = 0; x < 16; ++x) {
        pixels.pixels[x][0] = static_cast<std::uint8_t>(16 * x);
    }
    scene.textures.push_back({.name = "ramp", .pixels = pixels});
    scene.materials.push_back({.name = "glows",
                               .detail = {.emissive = scene::TextureUse{.texture = 0, .second = true},
                                          .emission = glm::vec3(1.0f)}});
    scene::addInstance(scene, 0, 1, 0, {0.0, -1.0, -6.0}, glm::mat3(1.0f));
    World world(scene);
    const render::RenderOptions options =
        optionsFor("anchored", Submission::secondaries, TargetsKind::single, 1, 1);
    SoleRenderer renderer(device(), world, options);
    for (std::uint32_t i = 1; i < 8; ++i) {
        scene::Mesh mesh = scene::makeBox(glm::vec3(0.3f));
        mesh.details.assign(mesh.vertices.size(), {.uv = glm::vec2(static_cast<float>(i) / 8.0f, 0.5f)});
        world.addInstance({.mesh = world.addMesh(mesh),
                           .material = world.material(1),
                           .object = i,
                           .transform = {.position = {0.7 * i - 3.0, 0.5, -5.0}}});
        renderer.forgetFrames();
        ASSERT_EQ(hashOf(renderer.render(ahead())), hashOf(draw(world.scene(), ahead(), options))) << i;
    }
}

/// A further mesh goes behind those that are there.
TEST_F(WorldTest, AddingAMeshSeldomUploadsTheOthers) {
    World world(boxScene());
    render::GpuScene onDevice(device(), world);
    int uploads = 0;
    for (int i = 0; i < 200; ++i) {
        const VkBuffer vertices = onDevice.uploaded().vertices();
        const scene::MeshHandle mesh = world.addMesh(scene::makeBox(glm::vec3(1.0f)));
        onDevice.update();
        uploads += onDevice.uploaded().vertices() == vertices ? 0 : 1;
        if (i % 2 == 0) {
            world.removeMesh(mesh);
        }
    }
    EXPECT_GE(uploads, 1);
    EXPECT_LE(uploads, 9); // each makes twice the room that is needed
}

/// The truth reads the world's scene itself: what was removed is not in it, and what is drawn is.
TEST_F(WorldTest, TruthSeesWhatIsDrawn) {
    World world;
    Editor editor(7, world);
    editor.populate(60);
    render::RenderOptions options =
        optionsFor("anchored", Submission::secondaries, TargetsKind::single, 2, 2);
    options.width = 640;
    options.height = 360;
    options.detail = {};
    SoleRenderer renderer(device(), world, options);
    platform::WorkerPool workers(2);
    for (int round = 0; round < 4; ++round) {
        for (int i = 0; i < 50; ++i) {
            editor.edit();
        }
        const measure::TruthImage truth =
            measure::castTruth(world.scene(), ahead(), options.width, options.height, workers);
        EXPECT_EQ(truth.pixels, measure::castTruth(editor.expected().build(), ahead(), options.width,
                                                   options.height, workers)
                                    .pixels);
        const measure::WrongPixels wrong = measure::countWrong(renderer.render(ahead()).ids(), truth);
        EXPECT_EQ(wrong.wrong, 0u) << "round " << round;
        EXPECT_GT(wrong.pixels, 100u);
    }
}

TEST_F(WorldTest, IsNotDrawnAsASceneThatStays) {
    const World world;
    const render::GpuScene onDevice(device(), world);
    EXPECT_THROW(render::Renderer(device(), world.scene(), onDevice,
                                  optionsFor("cdr", Submission::secondaries, TargetsKind::single, 1, 1)),
                 base::InputError);
}

/// Empty to begin with, with nothing but a mesh and a material, filled, and empty again.
TEST_F(WorldTest, MayBeEmpty) {
    for (const Submission submission : submissions()) {
        World world;
        render::GpuScene onDevice(device(), world);
        for (int round = 0; round < 2;
             ++round) { // the second renderer begins with a world that was filled before
            render::Renderer renderer(device(), onDevice,
                                      optionsFor("anchored", submission, TargetsKind::single, 1, 2));
            const render::Frame first = renderer.render(ahead());
            EXPECT_EQ(first.id(64, 36), 0u);
            const std::string empty = hashOf(first);
            const scene::MeshHandle mesh = world.addMesh(scene::makeBox(glm::vec3(1.0f)));
            const scene::MaterialHandle material = world.addMaterial({.unlit = true});
            EXPECT_EQ(hashOf(renderer.render(ahead())), empty);
            const scene::InstanceHandle box =
                world.addInstance({.mesh = mesh,
                                   .material = material,
                                   .object = 4,
                                   .transform = {.position = {0.0, 0.0, -5.0}}});
            EXPECT_EQ(renderer.render(ahead()).id(64, 36), 5u);
            world.removeInstance(box);
            world.removeMaterial(material);
            world.removeMesh(mesh);
            EXPECT_EQ(hashOf(renderer.render(ahead())), empty);
        }
    }
}

} // namespace

} // namespace cdr::render_test
