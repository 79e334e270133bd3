#include "../fixture.h"
#include "../steps.h"

#include <cdr/measure/truth/layered_truth.h>
#include <scenes/sheets.h>

#include <random>

namespace cdr::render_test {

namespace {

using render::Translucency;

constexpr std::uint32_t kWidth = 192;
constexpr std::uint32_t kHeight = 108;

depth::Technique countOf(depth::Mapping mapping, unsigned cascades) {
    return depth::Technique{mapping, depth::SplitCount{cascades}, depth::DepthFormat::d32f};
}

/// Every preset, and both anchored mappings over four even cascades.
std::vector<depth::Technique> techniquesToBlend() {
    std::vector<depth::Technique> all = presetTechniques();
    all.push_back(countOf(depth::Mapping::anchored, 4));
    all.push_back(countOf(depth::Mapping::anchoredReversed, 4));
    return all;
}

render::RenderOptions optionsFor(const depth::Technique& technique, Translucency method) {
    return {.width = kWidth,
            .height = kHeight,
            .technique = technique,
            .translucency = {.method = method, .countsFragments = true}};
}

void shuffle(scene::Scene& scene, std::uint32_t seed) {
    std::mt19937 random(seed);
    for (std::size_t i = scene.instances.size(); i > 1; --i) {
        scene::swapInstances(scene.instances, i - 1, random() % i);
    }
}

class TranslucencyTest : public RenderTest {
  protected:
    measure::LayeredTruth truthOf(const scene::Scene& scene, const scene::Camera& camera,
                                  std::uint32_t width = kWidth, std::uint32_t height = kHeight) {
        return layersOf(scene, camera, width, height);
    }

    /// The sheets' is cast once.
    const measure::LayeredTruth& truthOfSheets() {
        static const measure::LayeredTruth truth = truthOf(m_sheets.scene, m_camera);
        return truth;
    }

    /// How a sheets frame compares with the truth, once it has covered enough to mean anything.
    void expectCounted(const render::RenderOptions& options) {
        const render::Frame frame = draw(m_sheets.scene, m_camera, options);
        const measure::LayerDifference difference =
            measure::compareLayers(frame.color, frame.fragmentCounts, truthOfSheets());
        EXPECT_GT(difference.translucent, kWidth * kHeight / 5);
        EXPECT_EQ(difference.miscounted, 0u)
            << nameOf(options.technique) << " " << nameOf(options.targets) << " "
            << nameOf(options.translucency.method) << " " << frame.cascades.size();
    }

    scene::SceneSetup m_sheets = scenes::makeSheets(2013);
    scene::Camera m_camera = m_sheets.path.at(0);
};

/// The fragment count is exact where no sheet is lost at a boundary and none is drawn twice.
TEST_F(TranslucencyTest, EveryFragmentIsInExactlyOneOf1To8Cascades) {
    for (unsigned cascades = 1; cascades <= 8; ++cascades) {
        for (const Translucency method : render::kTranslucencies) {
            const bool even = cascades % 2 == (method == Translucency::sorted ? 1 : 0);
            const depth::Mapping mapping = even ? depth::Mapping::reversed : depth::Mapping::anchored;
            render::RenderOptions options = optionsFor(countOf(mapping, cascades), method);
            options.targets = render::kTargetsKinds[cascades % render::kTargetsKinds.size()];
            expectCounted(options);
        }
    }
}

/// With d32f each technique resolves the cubes, so what occludes is right, and so must the counts be.
TEST_F(TranslucencyTest, FragmentCountIsTheSameForAllTargetsAndTechniques) {
    std::size_t turn = 0;
    for (const depth::Technique& technique : techniquesToBlend()) {
        render::RenderOptions options = optionsFor(technique, Translucency::weighted);
        for (int i = 0; i < 2; ++i) {
            options.targets = render::kTargetsKinds[turn++ % render::kTargetsKinds.size()];
            expectCounted(options);
        }
    }
}

TEST_F(TranslucencyTest, SortedIsTheTruthToOneStep) {
    constexpr std::uint32_t kLarge = 2;
    const measure::LayeredTruth truth = truthOf(m_sheets.scene, m_camera, kLarge * kWidth, kLarge * kHeight);
    for (const depth::Technique& technique :
         {countOf(depth::Mapping::anchored, 5), countOf(depth::Mapping::reversed, 1)}) {
        render::RenderOptions options = optionsFor(technique, Translucency::sorted);
        options.width *= kLarge;
        options.height *= kLarge;
        const render::Frame frame = draw(m_sheets.scene, m_camera, options);
        EXPECT_EQ(frame.stats.translucency.method, Translucency::sorted);
        const measure::LayerDifference difference =
            measure::compareLayers(frame.color, frame.fragmentCounts, truth);
        EXPECT_GT(difference.translucent, 20'000u);
        EXPECT_GE(difference.withinFraction(), 0.9999) << nameOf(technique);
    }
}

/// Some sheets must lie in several cascades, else the tests above would pass without a boundary.
TEST_F(TranslucencyTest, SheetsLieInSeveralCascades) {
    const render::Frame one =
        draw(m_sheets.scene, m_camera, optionsFor(countOf(depth::Mapping::anchored, 1), {}));
    const render::Frame eight =
        draw(m_sheets.scene, m_camera, optionsFor(countOf(depth::Mapping::anchored, 8), {}));
    EXPECT_GT(eight.stats.translucency.draws, one.stats.translucency.draws * 3 / 2);
}

/// Where no instance is drawn twice, nothing depends on two draws that interpolate alike.
TEST_F(TranslucencyTest, SortedDrawsEachInstanceOnce) {
    const std::size_t visible =
        draw(m_sheets.scene, m_camera, optionsFor(countOf(depth::Mapping::anchored, 1), {}))
            .stats.translucency.draws;
    ASSERT_EQ(visible, 64u);
    for (const depth::Technique& technique : techniquesToBlend()) {
        render::RenderOptions options = optionsFor(technique, Translucency::sorted);
        options.width = 32;
        options.height = 18;
        const render::TranslucencyStats stats = draw(m_sheets.scene, m_camera, options).stats.translucency;
        EXPECT_EQ(stats.method, Translucency::sorted);
        EXPECT_EQ(stats.draws, visible) << nameOf(technique);
    }
}

TEST_F(TranslucencyTest, OrderOfInstancesChangesNoBitWhenSorted) {
    const render::RenderOptions options =
        quarterOf(optionsFor(countOf(depth::Mapping::anchored, 4), Translucency::sorted));
    const std::string wanted = hashOf(draw(m_sheets.scene, m_camera, options));
    for (const std::uint32_t seed : {1u, 2u, 3u}) {
        scene::Scene shuffled = m_sheets.scene;
        shuffle(shuffled, seed);
        ASSERT_NE(shuffled.instances.object, m_sheets.scene.instances.object);
        EXPECT_EQ(hashOf(draw(shuffled, m_camera, options)), wanted);
    }
}

/// Sheets at the same distance to the last bit: nothing but their ids can order them.
TEST_F(TranslucencyTest, CoincidentSheetsAreOrderedBySortedHoweverDrawn) {
    scene::Scene scene = m_sheets.scene;
    const std::size_t sheets = scene.instances.size();
    for (std::size_t i = 0; i < sheets; ++i) {
        scene::addInstance(scene, scene.instances.mesh[i], (scene.instances.material[i] + 5) % 12,
                           static_cast<std::uint32_t>(1000 + i), scene.instances.position(i),
                           scene.instances.basis[i]);
    }
    const render::RenderOptions options =
        quarterOf(optionsFor(countOf(depth::Mapping::reversed, 4), Translucency::sorted));
    const std::string wanted = program::sha256Of(draw(scene, m_camera, options).color.pixels);
    for (const std::uint32_t seed : {1u, 2u}) {
        shuffle(scene, seed);
        EXPECT_EQ(program::sha256Of(draw(scene, m_camera, options).color.pixels), wanted);
    }
}

TEST_F(TranslucencyTest, ThreadsTargetsAndSubmissionsChangeNoBit) {
    const render::GpuScene gpuScene(device(), m_sheets.scene);
    for (const Translucency method : render::kTranslucencies) {
        std::string wanted;
        for (const render::Submission submission : submissions()) {
            for (const render::TargetsKind targets :
                 {render::TargetsKind::single, render::TargetsKind::accumulate, render::TargetsKind::pool,
                  render::TargetsKind::layers}) {
                render::RenderOptions options =
                    quarterOf(optionsFor(countOf(depth::Mapping::anchored, 4), method));
                options.submission = submission;
                options.targets = targets;
                options.threads = targets == render::TargetsKind::single ? 1 : 3;
                const render::Frame frame = draw(m_sheets.scene, gpuScene, m_camera, options);
                const std::string hash = hashOf(frame) + program::sha256Of(frame.fragmentCounts.pixels);
                wanted = wanted.empty() ? hash : wanted;
                EXPECT_EQ(hash, wanted)
                    << nameOf(method) << " " << nameOf(submission) << " " << nameOf(targets);
            }
        }
    }
}

/// reversed holds the same opaque distances however it is split, so all of the picture must stay.
TEST_F(TranslucencyTest, TheNumberOfCascadesChangesNoBitWhenSorted) {
    std::string wanted;
    for (unsigned cascades = 1; cascades <= 8; ++cascades) {
        render::RenderOptions options =
            quarterOf(optionsFor(countOf(depth::Mapping::reversed, cascades), Translucency::sorted));
        options.targets = cascades % 2 == 1 ? render::TargetsKind::single : render::TargetsKind::onePass;
        const std::string hash = program::sha256Of(draw(m_sheets.scene, m_camera, options).color.pixels);
        wanted = wanted.empty() ? hash : wanted;
        EXPECT_EQ(hash, wanted) << cascades << " " << nameOf(options.targets);
    }
}

/// No array of a fixed size holds this list.
TEST_F(TranslucencyTest, SortedHoldsAnyNumberOfLayers) {
    constexpr std::uint32_t kLayers = 700;
    scene::Scene scene = boxScene();
    scene.meshes.push_back(scenes::makeSquare(1.0f));
    for (const float hue : {0.0f, 0.1f, 0.2f, 0.4f, 0.6f, 0.8f, 1.0f}) {
        scene.materials.push_back({.name = "layer",
                                   .baseColorFactor = glm::vec4(hue, 1.0f - hue, 0.5f, 0.02f),
                                   .doubleSided = true,
                                   .unlit = true,
                                   .alphaMode = scene::AlphaMode::blend});
    }
    for (std::uint32_t i = 0; i < kLayers; ++i) {
        const std::uint32_t layer = (i * 311) % kLayers;
        const double w = 2.0 + 0.01 * layer;
        scene::addInstance(scene, 1, 1 + layer % 7, layer, glm::dvec3(0.0, 0.0, -w),
                           glm::mat3(static_cast<float>(w)));
    }
    scene::Camera camera = m_camera;
    camera.farView = 100.0;
    render::RenderOptions options = optionsFor(countOf(depth::Mapping::anchored, 3), Translucency::sorted);
    options.width = 48;
    options.height = 36;
    const render::Frame frame = draw(scene, camera, options);
    const measure::LayerDifference difference =
        measure::compareLayers(frame.color, frame.fragmentCounts, truthOf(scene, camera, 48, 36));
    EXPECT_GT(difference.translucent, 500u);
    EXPECT_EQ(difference.miscounted, 0u);
    EXPECT_LE(difference.largestError, 1u);
    EXPECT_EQ(frame.fragmentCounts.at(24, 18), kLayers);
}

/// First sums of colours exceed half floats, then those of weights too.
TEST_F(TranslucencyTest, WeightedStaysFiniteHoweverManyBrightLayersThereAre) {
    struct Layers {
        float brightness;
        std::uint32_t count;
    };
    for (const auto& [brightness, count] : {Layers{40.0f, 40}, Layers{1.0f, 2000}}) {
        scene::Scene scene = boxScene();
        scene.meshes.push_back(scenes::makeSquare(100.0f));
        scene.materials.push_back({.name = "bright",
                                   .baseColorFactor = glm::vec4(glm::vec3(brightness), 1.0f),
                                   .doubleSided = true,
                                   .unlit = true,
                                   .alphaMode = scene::AlphaMode::blend});
        for (std::uint32_t i = 0; i < count; ++i) {
            scene::addInstance(scene, 1, 1, i, glm::dvec3(0.0, 0.0, -1.05), glm::mat3(1.0f));
        }
        scene::Camera camera;
        camera.nearView = 1.0;
        camera.farView = 1000.0;
        render::RenderOptions options =
            optionsFor(countOf(depth::Mapping::reversed, 1), Translucency::weighted);
        options.width = 32;
        options.height = 18;
        options.linear = true;
        const render::Frame frame = draw(scene, camera, options);
        ASSERT_EQ(frame.linear.pixels.size(), 32u * 18u);
        for (const glm::vec3& light : frame.linear.pixels) {
            ASSERT_TRUE(light.r > 0.99f && light.r < 1.01f * brightness)
                << light.r << " of " << count << " layers";
        }
    }
}

/// Half floats hold what they add, from the faintest layer on that a byte tells from none.
TEST_F(TranslucencyTest, FaintLayersShowAtTheFarEndOfACascade) {
    scene::Camera camera;
    camera.nearView = 0.1;
    camera.farView = 1e5;
    for (const float alpha : {0.01f, 1.0f / 255.0f}) {
        scene::Scene scene = boxScene();
        scene.background = glm::vec3(0.0f);
        scene.meshes.push_back(scenes::makeSquare(1e5f));
        scene.materials.push_back({.name = "smoke",
                                   .baseColorFactor = glm::vec4(glm::vec3(1.0f), alpha),
                                   .unlit = true,
                                   .alphaMode = scene::AlphaMode::blend});
        for (std::uint32_t i = 0; i < 10; ++i) {
            scene::addInstance(scene, 1, 1, i, {0.0, 0.0, -0.99 * camera.farView}, glm::mat3(1.0f));
        }
        const auto drawn = [&](Translucency method) {
            render::RenderOptions options = optionsFor(countOf(depth::Mapping::reversed, 1), method);
            options.width = 16;
            options.height = 9;
            return draw(scene, camera, options).color.at(8, 4);
        };
        const image::Rgba8 sorted = drawn(Translucency::sorted);
        EXPECT_GT(sorted[0], 50) << alpha;
        EXPECT_LE(largestStep(drawn(Translucency::weighted), sorted), 2) << alpha;
    }
}

TEST_F(TranslucencyTest, ListsThatDoNotFitAreDrawnWeightedAndSaySo) {
    render::RenderOptions options = optionsFor(countOf(depth::Mapping::anchored, 4), Translucency::weighted);
    const std::string weighted = hashOf(draw(m_sheets.scene, m_camera, options));
    options.translucency.method = Translucency::sorted;
    const render::Frame sorted = draw(m_sheets.scene, m_camera, options);
    EXPECT_FALSE(sorted.stats.translucency.refusal.has_value());
    EXPECT_GT(sorted.stats.translucency.fragments,
              std::uint64_t{kWidth} * kHeight); // more than it began with
    ASSERT_NE(hashOf(sorted), weighted);
    // First no room for a list at all, then too little for the fragments there are.
    for (const std::uint64_t most : {std::uint64_t{1000}, std::uint64_t{kWidth} * kHeight * 40}) {
        options.translucency.maxBytes = most;
        const render::Frame frame = draw(m_sheets.scene, m_camera, options);
        EXPECT_EQ(frame.stats.translucency.method, Translucency::weighted);
        ASSERT_TRUE(frame.stats.translucency.refusal.has_value());
        const render::ListRefusal& refusal = *frame.stats.translucency.refusal;
        EXPECT_EQ(refusal.cause, render::ListRefusal::Cause::bound);
        EXPECT_EQ(refusal.allowedBytes, most);
        EXPECT_GT(refusal.neededBytes, most);
        EXPECT_EQ(refusal.fragments, most == 1000 ? 0 : sorted.stats.translucency.fragments);
        EXPECT_EQ(hashOf(frame), weighted);
    }
    // To the byte: heads, and a node for each fragment and one for nobody.
    const std::uint64_t exact =
        std::uint64_t{kWidth} * kHeight * 4 + (sorted.stats.translucency.fragments + 1) * 32;
    options.translucency.maxBytes = exact;
    const render::Frame fits = draw(m_sheets.scene, m_camera, options);
    EXPECT_EQ(hashOf(fits), hashOf(sorted));
    EXPECT_EQ(fits.stats.translucency.bytes, exact);
    options.translucency.maxBytes = exact - 1;
    EXPECT_EQ(hashOf(draw(m_sheets.scene, m_camera, options)), weighted);
}

/// Frames overlap in their lists and repeat where room ran out, and the last is the one it would be alone.
TEST_F(TranslucencyTest, FramesInFlightLeaveTheNextFrameAsItIs) {
    const render::GpuScene gpuScene(device(), m_sheets.scene);
    for (const Translucency method : render::kTranslucencies) {
        render::RenderOptions options = quarterOf(optionsFor(countOf(depth::Mapping::anchored, 4), method));
        const std::string wanted = hashOf(draw(m_sheets.scene, m_camera, options));
        options.framesInFlight = 3;
        render::Renderer renderer(device(), m_sheets.scene, gpuScene, options);
        scene::Camera turned = m_camera;
        for (int frame = 0; frame < 7; ++frame) {
            turned.position.x = 0.02 * frame;
            renderer.submit(turned);
        }
        EXPECT_EQ(hashOf(renderer.render(m_camera)), wanted) << nameOf(method);
    }
}

/// Over the same surfaces twice as opaque: the G-buffer, and so ids and distances, are of the opaque alone.
TEST_F(TranslucencyTest, TheGBufferHoldsOpaqueSurfacesAlone) {
    scene::Scene opaque = m_sheets.scene;
    opaque.instances = {};
    const scene::Instances& all = m_sheets.scene.instances;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (opaque.materials[all.material[i]].alphaMode != scene::AlphaMode::blend) {
            addInstance(opaque, all.mesh[i], all.material[i], all.object[i], all.position(i), all.basis[i]);
        }
    }
    for (scene::Material& material : opaque.materials) {
        material.alphaMode = scene::AlphaMode::opaque;
    }
    const render::RenderOptions options = optionsFor(countOf(depth::Mapping::anchored, 4), {});
    const render::Frame with = draw(m_sheets.scene, m_camera, options);
    const render::Frame without = draw(opaque, m_camera, options);
    EXPECT_EQ(program::sha256Of(with.gbuffer.pixels), program::sha256Of(without.gbuffer.pixels));
    EXPECT_NE(program::sha256Of(with.color.pixels), program::sha256Of(without.color.pixels));
    EXPECT_TRUE(without.fragmentCounts.pixels.empty());
    EXPECT_EQ(wrongIn(with, m_sheets.scene, m_camera).wrong, 0u);
}

TEST_F(TranslucencyTest, AViewWithoutSheetsIsDrawn) {
    scene::Camera away = m_camera;
    away.back = -away.back;
    away.right = -away.right;
    for (const Translucency method : render::kTranslucencies) {
        const render::Frame frame =
            draw(m_sheets.scene, away, optionsFor(countOf(depth::Mapping::anchored, 4), method));
        EXPECT_EQ(frame.stats.translucency.draws, 0u);
        EXPECT_EQ(frame.stats.translucency.fragments, 0u);
        EXPECT_EQ(std::count(frame.fragmentCounts.pixels.begin(), frame.fragmentCounts.pixels.end(), 0u),
                  std::ptrdiff_t(frame.fragmentCounts.pixels.size()));
    }
}

} // namespace

} // namespace cdr::render_test
