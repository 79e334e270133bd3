#include "../fixture.h"
#include "../snapping.h"

#include <cdr/depth/make_cascades.h>
#include <cdr/depth/separation.h>
#include <cdr/render/targets/targets.h>
#include <scenes/cubes.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace cdr::render_test {

namespace {

using render::DepthSlice;
using render::Frame;
using render::TargetsKind;

class OnePassTest : public RenderTest {
  protected:
    Frame drawWith(const scene::Scene& scene, const render::GpuScene& gpuScene, const scene::Camera& camera,
                   const depth::Technique& technique, TargetsKind targets = TargetsKind::onePass) {
        auto options = smallOptions(technique);
        options.targets = targets;
        return draw(scene, gpuScene, camera, options);
    }
};

TEST_F(OnePassTest, SlicesShareNoValueAndTheNearestComesFirst) {
    for (const depth::DepthFormat format : available(depth::kDepthFormats)) {
        const depth::DepthFormatTraits& traits = traitsOf(format);
        const double step = traits.isFloat ? 0.0 : std::exp2(-traits.bits);
        for (const bool reversed : {false, true}) {
            const auto targets =
                render::makeTargets(device(), TargetsKind::onePass,
                                    {.extent = {8, 8}, .depthFormat = format, .reversedDepth = reversed});
            for (std::size_t cascades = 1; cascades <= depth::kMaxCascades; ++cascades) {
                // From the bottom of the depth range to its top.
                float below = -1.0f;
                for (std::size_t i = 0; i < cascades; ++i) {
                    const std::size_t cascade = reversed ? cascades - 1 - i : i;
                    const DepthSlice slice = targets->depthSlice(cascade, cascades);
                    ASSERT_GT(double(slice.min), double(below) + step) << cascades << " " << i;
                    ASSERT_GT(slice.max, slice.min);
                    ASSERT_TRUE(slice.min == 0.0f || std::isnormal(slice.min));
                    ASSERT_EQ(slice.min == 0.0f, i == 0);
                    below = slice.max;
                }
                ASSERT_EQ(below, 1.0f);
            }
        }
    }
}

TEST_F(OnePassTest, HasNoMoreWrongPixelsThanSingle) {
    const bool snaps = snapReach(device()) > 0.0;
    for (const scene::SceneSetup& setup :
         {scenes::makeAfc(2013), scenes::makeRotation(2013, 8000), scenes::makeCubes(2013)}) {
        const render::GpuScene gpuScene(device(), setup.scene);
        const scene::Camera camera = setup.path.at(20);
        const auto truth = truthOf(setup.scene, camera);
        for (const depth::NamedTechnique& preset : depth::presets()) {
            const auto wrong = [&](TargetsKind targets) {
                const Frame frame = drawWith(setup.scene, gpuScene, camera, preset.technique, targets);
                return measure::countWrong(frame.ids(), truth);
            };
            const std::uint64_t single = wrong(TargetsKind::single).wrong;
            // Where vertices are snapped, ties fall one way or the other by chance.
            const double chance = snaps ? std::sqrt(static_cast<double>(single)) : 0.0;
            EXPECT_LE(static_cast<double>(wrong(TargetsKind::onePass).wrong),
                      static_cast<double>(single) + chance)
                << setup.scene.name << " " << preset.name;
        }
    }
}

/// For the few cascades here, 24 less log2 N bits are more than 16. More bits do not always give fewer wrong
/// pixels: where neither resolves anything, the draw order decides. So the bound is the worse of the two.
TEST_F(OnePassTest, SlicesOf24BitsLieBetween24And16BitsOfOnesOwn) {
    if (available({depth::DepthFormat::d24}).empty()) {
        return;
    }
    const scene::SceneSetup setup = scenes::makeAfc(2013);
    const render::GpuScene gpuScene(device(), setup.scene);
    const scene::Camera camera = setup.path.at(20);
    const auto truth = truthOf(setup.scene, camera);
    for (const depth::NamedTechnique& preset : depth::presets()) {
        const auto wrong = [&](depth::DepthFormat format, TargetsKind targets) {
            depth::Technique technique = preset.technique;
            technique.format = format;
            const Frame frame = drawWith(setup.scene, gpuScene, camera, technique, targets);
            return measure::countWrong(frame.ids(), truth).wrong;
        };
        EXPECT_LE(wrong(depth::DepthFormat::d24, TargetsKind::onePass),
                  std::max(wrong(depth::DepthFormat::d24, TargetsKind::single),
                           wrong(depth::DepthFormat::d16, TargetsKind::single)))
            << preset.name;
    }
}

/// Pairs of boxes at three view distances in each cascade, drawn in both orders. In each a smaller box is a gap
/// behind the front of a larger one.
/// @param gapSteps gaps in steps of a cascade with a depth range of its own.
scene::Scene pairsScene(const depth::Technique& technique, const depth::Cascades& cascades, double gapSteps) {
    scene::Scene scene = boxScene();
    for (const depth::Cascade& cascade : cascades) {
        for (const double along : {0.03, 0.5, 0.93}) {
            const double w = cascade.nearView * std::pow(cascade.farView / cascade.nearView, along);
            const double gap =
                gapSteps * depth::separationView(technique.mapping, cascades, technique.format, w);
            const auto add = [&](double frontView, double share) {
                // Cells of 0.02 by 0.02 of the picture's plane at distance 1, in rows of 24.
                const auto pair = static_cast<double>(scene.instances.size() / 2);
                const double x = 0.02 * (std::fmod(pair, 24.0) - 12.0);
                const double y = 0.02 * (std::floor(pair / 24.0) - 2.0);
                const double side = 0.012 * w;
                addBox(scene, {x * w, y * w, -(frontView + 0.5 * side)},
                       glm::mat3(static_cast<float>(share * side), 0.0f, 0.0f, 0.0f,
                                 static_cast<float>(share * side), 0.0f, 0.0f, 0.0f,
                                 static_cast<float>(side)));
            };
            add(w, 1.0);
            add(w + gap, 0.7);
            add(w + gap, 0.7);
            add(w, 1.0);
        }
    }
    return scene;
}

/// The cost that the class states for integers: a gap of N steps and a little is told apart in every slice.
TEST_F(OnePassTest, IntegerSlicesCostTheBitsTheySay) {
    const scene::Camera camera{.fovY = 0.3, .nearView = 1.0, .farView = 1e4};
    for (const char* split : {"count:4", "count:16"}) {
        const depth::Cascades cascades = depth::makeCascades(
            depth::parseSplit(split), {.nearView = camera.nearView, .farView = camera.farView});
        for (const auto format : available({depth::DepthFormat::d16, depth::DepthFormat::d24})) {
            for (const depth::Mapping mapping : depth::kMappings) {
                const auto technique = depth::Technique{mapping, depth::parseSplit(split), format};
                // Beside 24 bits, float32 vertices and viewports round by as much again.
                const double steps = format == depth::DepthFormat::d16 ? 1.2 : 3.0;
                const scene::Scene scene =
                    pairsScene(technique, cascades, steps * static_cast<double>(cascades.size()));
                const render::GpuScene gpuScene(device(), scene);
                const auto wrong = wrongIn(drawWith(scene, gpuScene, camera, technique), scene, camera);
                EXPECT_GT(wrong.pixels, 1000u);
                EXPECT_EQ(wrong.wrong, 0u) << nameOf(technique) << " " << nameOf(format);
            }
        }
    }
}

/// The same for float32. Slices of 20 octaves resolve what a depth range of their own does. Slices of 6 octaves
/// resolve at least what it does with a bit less.
TEST_F(OnePassTest, FloatSlicesCostTheBitsTheySay) {
    const scene::Camera camera{.fovY = 0.3, .nearView = 1.0, .farView = 1e4};
    for (const auto& [text, cost] : {std::pair{"count:5", 1.0}, {"count:16", 2.0}}) {
        const depth::Split split = depth::parseSplit(text);
        const depth::Cascades cascades =
            depth::makeCascades(split, {.nearView = camera.nearView, .farView = camera.farView});
        for (const depth::Mapping mapping : depth::kMappings) {
            const auto technique = depth::Technique{mapping, split, depth::DepthFormat::d32f};
            const auto wrong = [&](double steps, TargetsKind targets) {
                const scene::Scene scene = pairsScene(technique, cascades, steps);
                const render::GpuScene gpuScene(device(), scene);
                return wrongIn(drawWith(scene, gpuScene, camera, technique, targets), scene, camera).wrong;
            };
            for (const double steps : {0.5, 3.0, 8.0}) {
                EXPECT_LE(wrong(steps * cost, TargetsKind::onePass), wrong(steps, TargetsKind::single))
                    << nameOf(technique) << " " << steps;
            }
        }
    }
}

/// One depth buffer rounds otherwise than several, so pictures may differ where a technique cannot tell surfaces apart.
TEST_F(OnePassTest, IsTheImageOfTheOthersWhereNothingTies) {
    for (const scene::SceneSetup& setup : {scenes::makeAfc(2013), scenes::makeRotation(2013, 20'000)}) {
        const render::GpuScene gpuScene(device(), setup.scene);
        for (const char* technique : {"anchored", "anchored-reversed/fitted"}) {
            for (const render::SurfacePath surface :
                 {render::SurfacePath::gbuffer, render::SurfacePath::visibility}) {
                const auto hash = [&](TargetsKind targets) {
                    render::RenderOptions options = smallOptions(depth::parseTechnique(technique));
                    options.targets = targets;
                    options.surface = surface;
                    return hashOf(draw(setup.scene, gpuScene, setup.path.at(40), options));
                };
                EXPECT_EQ(hash(TargetsKind::onePass), hash(TargetsKind::single))
                    << setup.scene.name << " " << technique << " " << nameOf(surface);
            }
        }
    }
}

} // namespace

} // namespace cdr::render_test
