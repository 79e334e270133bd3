#include "../../support/all_cases.h"
#include "../failing_calls.h"
#include "../fixture.h"
#include "../steps.h"

#include <cdr/measure/truth/layered_truth.h>
#include <scenes/sheets.h>

namespace cdr::render_test {

namespace {

using render::RenderOptions;
using render::ShadowMethod;
using render::Translucency;

constexpr std::uint32_t kWidth = 240; // sheets lie many deep, and each reads a shadow map
constexpr std::uint32_t kHeight = 135;

class TranslucentShadowsTest : public RenderTest {
  protected:
    RenderOptions optionsFor(const char* technique, Translucency method) const {
        RenderOptions options = smallOptions(depth::namedTechnique(technique).technique, kWidth, kHeight);
        options.shadows.method = ShadowMethod::anchored;
        options.translucency = {.method = method, .countsFragments = true};
        return options;
    }
    measure::LayeredTruth truthOf(const scene::Scene& scene, const scene::Camera& camera) const {
        platform::WorkerPool workers(2);
        return measure::castLayers(scene, camera, kWidth, kHeight, workers, measure::Lights::castShadows);
    }
    /// The sheets' is cast once.
    const measure::LayeredTruth& truthOfSheets() const {
        static const measure::LayeredTruth truth = truthOf(m_sheets.scene, m_camera);
        return truth;
    }
    /// Too small for their quality to matter.
    RenderOptions tinyOptionsFor(const char* technique, Translucency method) const {
        RenderOptions options = optionsFor(technique, method);
        options.shadows.maxTexels = 128;
        options.width = 64;
        options.height = 36;
        return options;
    }

    scene::SceneSetup m_sheets = scenes::makeSheets(2013);
    scene::Camera m_camera = m_sheets.path.at(0);
};

/// Sheets from 0.1 to 10^6 units, a light beyond them all and one among the nearest.
TEST_F(TranslucentShadowsTest, SortedSheetsReceiveThoseOfTheTruth) {
    const measure::LayeredTruth& truth = truthOfSheets();
    const RenderOptions options = optionsFor("anchored", Translucency::sorted);
    const render::Frame frame = draw(m_sheets.scene, m_camera, options);
    EXPECT_EQ(frame.stats.translucency.method, Translucency::sorted);
    const measure::LayerDifference difference =
        measure::compareLayers(frame.color, frame.fragmentCounts, truth);
    EXPECT_GT(difference.translucent, 8'000u);
    EXPECT_EQ(difference.miscounted, 0u) << "each fragment is drawn in one slice";
    EXPECT_GE(difference.withinFraction(), 0.9999);
    RenderOptions lit = options;
    lit.shadows = {};
    const render::Frame without = draw(m_sheets.scene, m_camera, lit);
    EXPECT_LT(measure::compareLayers(without.color, without.fragmentCounts, truth).withinFraction(), 0.99);
}

TEST_F(TranslucentShadowsTest, WeightedCountsEachFragmentOnce) {
    const render::Frame frame =
        draw(m_sheets.scene, m_camera, optionsFor("anchored", Translucency::weighted));
    EXPECT_EQ(measure::compareLayers(frame.color, frame.fragmentCounts, truthOfSheets()).miscounted, 0u);
}

/// One sheet over each pixel, so that weights cancel: both methods show its shadow.
TEST_F(TranslucentShadowsTest, ASheetUnderABoxShowsItsShadowByBothMethods) {
    scene::Scene scene = boxScene();
    scene.ambient = glm::vec3(0.2f);
    scene.meshes.push_back(scenes::makeSquare(1.0f));
    scene.materials.push_back({.name = "glass",
                               .baseColorFactor = glm::vec4(0.5f, 0.7f, 0.9f, 0.5f),
                               .doubleSided = true,
                               .alphaMode = scene::AlphaMode::blend});
    scene.lights.front() = {.position = glm::dvec3(1e9, 2e9, 1e9), .halfDistance = 1e12};
    // It lies flat, with a box over it.
    const glm::dvec3 place(3e6, -2.0, -1e5);
    addInstance(scene, 1, 1, 0, place, glm::mat3(8, 0, 0, 0, 0, -8, 0, 8, 0));
    addInstance(scene, 0, 0, 1, place + glm::dvec3(0.0, 2.5, 0.0), glm::mat3(3.0f));
    const scene::Camera camera{
        .position = place + glm::dvec3(0.0, 3.0, 12.0), .fovY = 1.0, .nearView = 0.1, .farView = 1e6};
    const measure::LayeredTruth truth = truthOf(scene, camera);
    platform::WorkerPool workers(1);
    const measure::LayeredTruth lit = measure::castLayers(scene, camera, kWidth, kHeight, workers);
    for (const Translucency method : render::kTranslucencies) {
        const render::Frame frame = draw(scene, camera, optionsFor("anchored", method));
        const measure::LayerDifference difference =
            measure::compareLayers(frame.color, frame.fragmentCounts, truth);
        EXPECT_GT(difference.translucent, 2'800u);
        EXPECT_GE(difference.withinFraction(), 0.9999) << nameOf(method);
        EXPECT_LT(measure::compareLayers(frame.color, frame.fragmentCounts, lit).withinFraction(), 0.99);
    }
}

/// Vulkan promises four storage buffers in a fragment shader. Lists need three, lights one, and shadows another.
TEST_F(TranslucentShadowsTest, ADeviceWithTooFewStorageBuffersDrawsThemWeighted) {
    RenderOptions options = tinyOptionsFor("reversed", Translucency::weighted);
    const std::string weighted = hashOf(draw(m_sheets.scene, m_camera, options));
    options.translucency.method = Translucency::sorted;
    const StandIn few = fewStorageBuffers(4);
    const render::Frame frame = draw(m_sheets.scene, m_camera, options);
    EXPECT_EQ(hashOf(frame), weighted);
    ASSERT_TRUE(frame.stats.translucency.refusal);
    EXPECT_EQ(frame.stats.translucency.refusal->cause, render::ListRefusal::Cause::storageBuffers);
    options.shadows = {};
    EXPECT_EQ(draw(m_sheets.scene, m_camera, options).stats.translucency.method, Translucency::sorted);
}

/// A number of threads and a submission with each kind of targets, or all with CDR_ALL_CASES.
TEST_F(TranslucentShadowsTest, ThreadsTargetsAndSubmissionsChangeNoBit) {
    std::size_t turn = 1; // from a submission other than that of the first picture
    for (const Translucency method : render::kTranslucencies) {
        const RenderOptions options = tinyOptionsFor("cdr", method);
        const std::string wanted = hashOf(draw(m_sheets.scene, m_camera, options));
        for (const render::TargetsKind targets :
             {render::TargetsKind::accumulate, render::TargetsKind::pool, render::TargetsKind::layers}) {
            for (const std::size_t threads : test::sampleOf(std::vector<std::size_t>{2, 16}, turn)) {
                for (const render::Submission submission : test::sampleOf(submissions(), turn)) {
                    RenderOptions other = options;
                    other.targets = targets;
                    other.threads = threads;
                    other.submission = submission;
                    EXPECT_EQ(hashOf(draw(m_sheets.scene, m_camera, other)), wanted)
                        << nameOf(targets) << " " << threads << " " << nameOf(submission);
                }
            }
            ++turn;
        }
    }
}

/// Slices have no maps then. Layers newer than Debian 12's refuse a scope without texels.
TEST_F(TranslucentShadowsTest, WithoutLightsOrSheetsNoMapIsDrawn) {
    scene::Scene dark = m_sheets.scene;
    dark.lights.clear();
    scene::Camera away = m_camera;
    away.back = -away.back;
    away.right = -away.right;
    for (const Translucency method : render::kTranslucencies) {
        const RenderOptions options = tinyOptionsFor("anchored", method);
        RenderOptions unshadowed = options;
        unshadowed.shadows = {};
        const render::Frame frame = draw(dark, m_camera, options);
        EXPECT_EQ(frame.stats.shadows.maps, 0u);
        // Weighted sums are halves, and slices add them in another order.
        EXPECT_LE(largestStep(frame.color, draw(dark, m_camera, unshadowed).color),
                  method == Translucency::sorted ? 0 : 1);
        EXPECT_EQ(draw(m_sheets.scene, away, options).stats.translucency.draws, 0u);
    }
}

TEST_F(TranslucentShadowsTest, FramesInFlightLeaveTheNextFrameAsItIs) {
    const render::GpuScene gpuScene(device(), m_sheets.scene);
    for (const Translucency method : render::kTranslucencies) {
        RenderOptions options = tinyOptionsFor("anchored", method);
        const std::string wanted = hashOf(draw(m_sheets.scene, m_camera, options));
        options.framesInFlight = 3;
        render::Renderer renderer(device(), m_sheets.scene, gpuScene, options);
        scene::Camera moved = m_camera;
        for (int frame = 0; frame < 5; ++frame) {
            moved.position.x = 0.02 * frame;
            renderer.submit(moved);
        }
        EXPECT_EQ(hashOf(renderer.render(m_camera)), wanted) << nameOf(method);
    }
}

} // namespace

} // namespace cdr::render_test
