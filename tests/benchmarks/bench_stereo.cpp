// Two eyes against one, of the same size for each eye. Frames take turns, and what is reported is the median of the ratios
// of neighbours: of time, and of CPU time. `mono_twice` is a renderer of one eye that draws both, one after the other.
// `to_in_turn` compares both eyes with eyes that are drawn in turn, as they are where the device's clock times each.

#include "paired_cost.h"

#include <cdr/render/views/views_renderer.h>
#include <cdr/scene/stereo_rig.h>
#include <scenes/open_scene.h>

#include <benchmark/benchmark.h>

#include <array>
#include <string>
#include <vector>

namespace {

using namespace cdr;

struct StereoCase {
    const char* scene;
    const char* technique;
    render::Submission submission = render::Submission::secondaries;
    render::ShadowMethod shadows = render::ShadowMethod::none;
};

constexpr std::array kCases{
    StereoCase{"rotation", "cdr"},
    StereoCase{"rotation", "anchored"},
    StereoCase{"rotation", "cdr", render::Submission::gpuDriven},
    StereoCase{"afc", "anchored"},
    StereoCase{"city", "anchored"},
    StereoCase{"alley", "anchored"},
    StereoCase{"alley", "anchored", render::Submission::secondaries, render::ShadowMethod::anchored},
    StereoCase{"rotation", "reversed"},
};

/// @param state case, width, eyes toed in
void stereo(benchmark::State& state) {
    static const benchmarks::Gpu gpu;
    const StereoCase& drawn = kCases[static_cast<std::size_t>(state.range(0))];
    state.SetLabel(std::string(drawn.scene) + " " + drawn.technique + " " +
                   std::string(nameOf(drawn.submission)) +
                   (drawn.shadows == render::ShadowMethod::none ? "" : " shadows"));
    const scene::SceneSetup setup = scenes::openScene(drawn.scene, scenes::kDefaultSeed).setup;
    const render::GpuScene onDevice(gpu.device, setup.scene);
    render::RenderOptions options{.width = static_cast<std::uint32_t>(state.range(1)),
                                  .height = static_cast<std::uint32_t>(state.range(1) * 9 / 16),
                                  .technique = depth::parseTechnique(drawn.technique),
                                  .submission = drawn.submission};
    options.shadows.method = drawn.shadows;
    const scene::Camera centre = setup.path.at(0);
    const auto eyes = scene::eyesOf({.centre = centre,
                                     .eyeDistance = 0.065,
                                     .convergence = 5.0,
                                     .mode = scene::kStereoModes[static_cast<std::size_t>(state.range(2))]});
    render::Renderer mono(gpu.device, setup.scene, onDevice, options);
    render::ViewsRenderer both(gpu.device, setup.scene, onDevice, options, eyes.size());
    options.deviceClock = true;
    render::ViewsRenderer inTurn(gpu.device, setup.scene, onDevice, options, eyes.size());
    for (int warm = 0; warm < 4; ++warm) {
        mono.draw(eyes[0]);
        both.draw(eyes);
        inTurn.draw(eyes);
    }
    std::vector<double> ratios;
    std::vector<double> cpuRatios;
    std::vector<double> twice;
    std::vector<double> toInTurn;
    for (auto iteration : state) {
        const benchmarks::Cost one = benchmarks::costOf([&] { mono.draw(eyes[0]); });
        const benchmarks::Cost two = benchmarks::costOf([&] { both.draw(eyes); });
        const benchmarks::Cost alone = benchmarks::costOf([&] {
            mono.draw(eyes[0]);
            mono.draw(eyes[1]);
        });
        const benchmarks::Cost turns = benchmarks::costOf([&] { inTurn.draw(eyes); });
        state.SetIterationTime(two.seconds);
        ratios.push_back(two.seconds / one.seconds);
        cpuRatios.push_back(two.cpuSeconds / one.cpuSeconds);
        twice.push_back(alone.seconds / one.seconds);
        toInTurn.push_back(two.seconds / turns.seconds);
    }
    benchmarks::report(state, "ratio", ratios);
    benchmarks::report(state, "cpu_ratio", cpuRatios);
    benchmarks::report(state, "mono_twice", twice);
    benchmarks::report(state, "to_in_turn", toInTurn);
}

BENCHMARK(stereo)
    ->ArgNames({"case", "width", "toed_in"})
    ->ArgsProduct({benchmark::CreateDenseRange(0, kCases.size() - 1, 1), {640, 1280}, {0}})
    ->Args({1, 1280, 1})
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime()
    ->Iterations(40);

} // namespace
