#include "../fixture.h"
#include "editor.h"

#include <cdr/base/error.h>

#include <array>
#include <cstdlib>
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

using WorldTest = RenderTest;

/// The rule of live worlds: whatever was done to it, and however it is drawn, the picture is that of a scene built anew.
/// Blended fragments are counted, so each is drawn once. Groups of renderers take turns and so lag behind by a batch.
TEST_F(WorldTest, AnyEditsGiveThePictureOfASceneBuiltAnew) {
    constexpr int kBatches = 20;
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
    for (int batch = 0; batch < kBatches; ++batch) {
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
        const scene::Scene built = editor.expected().build();
        const render::Frame wanted = draw(built, ahead(), group.front()->options());
        for (std::size_t i = 0; i < group.size(); ++i) {
            group[i]->forgetFrames();
            const render::Frame frame = group[i]->render(ahead());
            ASSERT_EQ(hashOf(frame), hashOf(wanted)) << "batch " << batch << ", renderer " << i;
            ASSERT_EQ(frame.fragmentCounts.pixels, wanted.fragmentCounts.pixels);
            blendedFragments += std::accumulate(frame.fragmentCounts.pixels.begin(),
                                                frame.fragmentCounts.pixels.end(), std::uint64_t{0});
            ASSERT_EQ(frame.stats.draws, wanted.stats.draws);
        }
        ASSERT_EQ(messageCount(), 0u);
    }
    EXPECT_GT(blendedFragments, 0u);
}

template <typename Values>
auto oneOf(std::mt19937_64& random, const Values& values) {
    return values[std::uniform_int_distribution<std::size_t>(0, std::size(values) - 1)(random)];
}

/// Options by lot, of those that may go together.
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
        options.detail = {};
        options.shadows = {.method = render::ShadowMethod::anchored, .mostTexels = 64};
    }
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
    return text + (options.occlusionCulling ? ", occlusion culling, " : ", ") +
           std::to_string(options.threads) + " threads, " + std::to_string(options.framesInFlight) +
           " in flight";
}

/// The same rule for renderers of options by lot, seen from changing places. CDR_ALL_CASES takes more seeds.
TEST_F(WorldTest, RenderersOfAnyOptionsShowAnyEdits) {
    const std::uint64_t seeds = std::getenv("CDR_ALL_CASES") != nullptr ? 40 : 3;
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
                // What tables have read anew hides instances that were forgotten, so now and then none changes after these.
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
                ASSERT_EQ(frame.fragmentCounts.pixels, wanted.fragmentCounts.pixels);
            }
            ASSERT_EQ(messageCount(), 0u);
        }
    }
}

/// The truth reads the world's scene itself: what was removed is not in it, and what is drawn is.
TEST_F(WorldTest, TruthSeesWhatIsDrawn) {
    World world;
    Editor editor(7, world);
    editor.populate(60);
    render::GpuScene onDevice(device(), world);
    render::RenderOptions options =
        optionsFor("anchored", Submission::secondaries, TargetsKind::single, 2, 2);
    options.width = 640;
    options.height = 360;
    options.detail = {};
    render::Renderer renderer(device(), onDevice, options);
    host::WorkerPool workers(2);
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

/// Empty to begin with, filled, and empty again.
TEST_F(WorldTest, MayBeEmpty) {
    World world;
    render::GpuScene onDevice(device(), world);
    for (const Submission submission : submissions()) {
        render::Renderer renderer(device(), onDevice,
                                  optionsFor("anchored", submission, TargetsKind::single, 1, 2));
        const std::string empty = hashOf(renderer.render(ahead()));
        const scene::MeshHandle mesh = world.addMesh(scene::makeBox(glm::vec3(1.0f)));
        const scene::MaterialHandle material = world.addMaterial({.unlit = true});
        const scene::InstanceHandle box = world.addInstance(
            {.mesh = mesh, .material = material, .object = 4, .transform = {.position = {0.0, 0.0, -5.0}}});
        EXPECT_EQ(renderer.render(ahead()).id(64, 36), 5u);
        world.removeInstance(box);
        world.removeMaterial(material);
        world.removeMesh(mesh);
        EXPECT_EQ(hashOf(renderer.render(ahead())), empty);
    }
}

} // namespace

} // namespace cdr::render_test
