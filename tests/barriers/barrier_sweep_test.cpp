#include "weakened_barriers.h"

#include <cdr/gpu/commands.h>
#include <cdr/gpu/memory.h>
#include <cdr/render/renderer.h>
#include <cdr/render/targets/gbuffer_rendering.h>
#include <scenes/open_scene.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <optional>
#include <ostream>
#include <string>

namespace cdr::render_test {

namespace {

using render::RenderOptions;
using test::WeakenedBarriers;

/// A renderer whose barriers are weakened.
struct Swept {
    const char* name;
    const char* scene;
    std::function<void(RenderOptions&)> set;
    std::optional<std::size_t> unseen{}; ///< a barrier whose absence no known layer reports

    friend std::ostream& operator<<(std::ostream& out, const Swept& swept) { return out << swept.name; }
};

/// Whether the validation layer sees that a scope loads what another one stored, with no barrier in between. Older
/// layers do not, and later ones only where a setting says so.
bool seesLoadAfterStore() {
    const gpu::Instance instance({.validate = true, .extensions = {}});
    const gpu::Device device(instance, "");
    const gpu::Image image = render::makeGBuffer(device, {8, 8}, "canary");
    gpu::runOnce(device, [&](vk::CommandBuffer commands) {
        gpu::pipelineBarrier(commands, {render::attachBarrier(image)});
        for (const auto load :
             {vk::AttachmentLoadOp::eClear, vk::AttachmentLoadOp::eLoad}) { // no barrier in between
            const vk::RenderingAttachmentInfo color{.imageView = image.view(),
                                                    .imageLayout = vk::ImageLayout::eColorAttachmentOptimal,
                                                    .loadOp = load,
                                                    .storeOp = vk::AttachmentStoreOp::eStore};
            commands.beginRendering({.renderArea = {{0, 0}, {8, 8}},
                                     .layerCount = 1,
                                     .colorAttachmentCount = 1,
                                     .pColorAttachments = &color});
            commands.endRendering();
        }
    });
    return instance.validation().count() > 0;
}

/// Whether the layer is told to follow buffers into shaders.
bool followsShaders() {
    return std::getenv("VK_KHRONOS_VALIDATION_SYNCVAL_SHADER_ACCESSES_HEURISTIC") != nullptr;
}

class BarrierSweep : public testing::TestWithParam<Swept> {
  protected:
    /// What the last of three frames did.
    struct Run {
        std::size_t barriers = 0;
        std::string weakened;
        std::size_t messages = 0; ///< of the layer, about all frames
    };

    /// Draws three frames, two of them in flight. In each, the barrier of that number is weakened. A layer says the same
    /// thing a few times only, so each run has a layer of its own.
    static Run drawUnder(const std::optional<std::size_t>& weakened) {
        Run run;
        const gpu::Instance instance({.validate = true, .extensions = {}});
        const gpu::Device device(instance, "");
        const scene::SceneSetup setup = scenes::openScene(GetParam().scene, scenes::kDefaultSeed).setup;
        RenderOptions options{
            .width = 32,
            .height = 32,
            .technique = {depth::Mapping::standard, depth::parseSplit("count:3"), depth::DepthFormat::d32f},
            .threads = 1,
            .framesInFlight = 2};
        GetParam().set(options);
        const render::GpuScene gpuScene(device, setup.scene);
        render::Renderer renderer(device, setup.scene, gpuScene, options);
        for (int frame = 0; frame < 3; ++frame) {
            WeakenedBarriers::begin(weakened);
            renderer.submit(setup.path.at(0));
            run.barriers = WeakenedBarriers::counted();
            run.weakened = WeakenedBarriers::weakened();
        }
        renderer.finish();
        run.messages = instance.validation().count();
        return run;
    }

    /// Whether a layer can see that a barrier is needed. None sees what the host reads, nor what conditional rendering does.
    static bool isVisible(const Run& run, std::size_t barrier) {
        const bool isFollowed = !run.weakened.ends_with("of { Host }") &&
                                !run.weakened.ends_with("of { ConditionalRenderingEXT }");
        const bool isOfBuffers = run.weakened.starts_with("memory");
        return isFollowed && (!isOfBuffers || followsShaders()) && barrier != GetParam().unseen;
    }
};

TEST_P(BarrierSweep, EachBarrierIsNeeded) {
    if (!seesLoadAfterStore()) {
        GTEST_SKIP() << "this validation layer does not see loads after stores; see tools/layers.sh";
    }
    if (std::string(GetParam().name).starts_with("Sorted") && followsShaders()) {
        GTEST_SKIP() << "fragments claim their places by atomics, which the layer takes for hazards";
    }
    const Run sound = drawUnder(std::nullopt);
    ASSERT_EQ(sound.messages, 0u);
    ASSERT_GE(sound.barriers, 3u);
    std::size_t seen = 0;
    for (std::size_t barrier = 0; barrier < sound.barriers; ++barrier) {
        const Run run = drawUnder(barrier);
        ASSERT_FALSE(run.weakened.empty());
        if (isVisible(run, barrier)) {
            EXPECT_GT(run.messages, 0u) << "barrier " << barrier << ", " << run.weakened;
            ++seen;
        }
    }
    std::printf("%s: %zu of %zu barriers\n", GetParam().name, seen, sound.barriers);
}

INSTANTIATE_TEST_SUITE_P(
    Renderers, BarrierSweep,
    testing::Values(
        Swept{"Single", "mixed",
              [](RenderOptions& options) { options.targets = render::TargetsKind::single; }},
        Swept{"OnePass", "mixed",
              [](RenderOptions& options) { options.targets = render::TargetsKind::onePass; }},
        Swept{"Accumulate", "mixed",
              [](RenderOptions& options) { options.targets = render::TargetsKind::accumulate; }},
        Swept{"Layers", "mixed",
              [](RenderOptions& options) { options.targets = render::TargetsKind::layers; }},
        Swept{"Primaries", "mixed",
              [](RenderOptions& options) { options.submission = render::Submission::primaries; }},
        Swept{"GpuDriven", "mixed",
              [](RenderOptions& options) { options.submission = render::Submission::gpuDriven; }},
        Swept{"Visibility", "mixed",
              [](RenderOptions& options) { options.surface = render::SurfacePath::visibility; }},
        Swept{"Lit", "mixed", [](RenderOptions& options) { options.surface = render::SurfacePath::lit; }},
        Swept{"Effects", "mixed",
              [](RenderOptions& options) {
                  options.effects.antialias = render::Antialias::edges;
                  options.effects.occlusion.radius = 1.0;
              }},
        Swept{"Focus", "mixed",
              [](RenderOptions& options) {
                  options.targets = render::TargetsKind::layers;
                  options.focus = {.distance = 12000.0, .aperture = 1.0};
              }},
        Swept{"Motion", "mixed", [](RenderOptions& options) { options.motion = true; }},
        Swept{"Shadows", "alley",
              [](RenderOptions& options) {
                  options.technique = depth::parseTechnique("anchored");
                  options.shadows.method = render::ShadowMethod::anchored;
              }},
        Swept{"OcclusionCulling", "alley", [](RenderOptions& options) { options.occlusionCulling = true; }},
        Swept{"DeviceOcclusion", "alley",
              [](RenderOptions& options) {
                  options.occlusionCulling = true;
                  options.submission = render::Submission::gpuDriven;
              },
              0}, // between frames, where the layer does not follow shaders
        Swept{"Weighted", "sheets",
              [](RenderOptions& options) { options.translucency.method = render::Translucency::weighted; }},
        Swept{"Sorted", "sheets",
              [](RenderOptions& options) { options.translucency.method = render::Translucency::sorted; }},
        Swept{"WeightedShadows", "sheets",
              [](RenderOptions& options) {
                  options.translucency.method = render::Translucency::weighted;
                  options.shadows.method = render::ShadowMethod::anchored;
              }},
        Swept{"SortedShadows", "sheets",
              [](RenderOptions& options) {
                  options.translucency.method = render::Translucency::sorted;
                  options.shadows.method = render::ShadowMethod::anchored;
              }}),
    [](const auto& row) { return std::string(row.param.name); });

} // namespace

} // namespace cdr::render_test
