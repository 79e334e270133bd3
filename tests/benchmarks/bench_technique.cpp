// Frames of one technique against those of another, and of the parts that make one out of the other. They take turns, and what
// is reported is the median of the ratios of neighbours: of time, and of CPU time. Target: anchored in 1.01 of reversed.

#include "paired_cost.h"

#include <cdr/render/renderer.h>
#include <scenes/open_scene.h>

#include <benchmark/benchmark.h>

#include <array>
#include <string>
#include <vector>

namespace {

using namespace cdr;

struct TechniqueCase {
    const char* measured;
    const char* base;
};

constexpr std::array kTechniqueCases{
    TechniqueCase{"anchored", "reversed"},         // all of it
    TechniqueCase{"anchored/none", "reversed"},    // distances from an anchor plane
    TechniqueCase{"reversed/fitted", "reversed"},  // cutting, where one cascade suffices
    TechniqueCase{"reversed/count:2", "reversed"}, // one boundary
    TechniqueCase{"anchored", "anchored/none"},    // cutting and the boundaries that it makes
    TechniqueCase{"reversed", "reversed"},         // noise
};

/// @param state case
void technique(benchmark::State& state) {
    static const benchmarks::Gpu gpu;
    const TechniqueCase& drawn = kTechniqueCases[static_cast<std::size_t>(state.range(0))];
    state.SetLabel(std::string("rotation ") + drawn.measured + " over " + drawn.base);
    const scene::SceneSetup setup = scenes::openScene("rotation", scenes::kDefaultSeed).setup;
    const render::GpuScene onDevice(gpu.device, setup.scene);
    render::Renderer base(gpu.device, setup.scene, onDevice,
                          {.technique = depth::parseTechnique(drawn.base)});
    render::Renderer measured(gpu.device, setup.scene, onDevice,
                              {.technique = depth::parseTechnique(drawn.measured)});
    std::uint32_t frame = 0;
    for (; frame < 4; ++frame) {
        base.draw(setup.path.at(frame));
        measured.draw(setup.path.at(frame));
    }
    std::vector<double> ratios;
    std::vector<double> cpuRatios;
    std::vector<double> milliseconds;
    for (auto iteration : state) {
        const scene::Camera camera = setup.path.at(frame++);
        const benchmarks::Cost before = benchmarks::costOf([&] { base.draw(camera); });
        const benchmarks::Cost own = benchmarks::costOf([&] { measured.draw(camera); });
        const benchmarks::Cost after = benchmarks::costOf([&] { base.draw(camera); });
        state.SetIterationTime(own.seconds);
        ratios.push_back(2.0 * own.seconds / (before.seconds + after.seconds));
        cpuRatios.push_back(2.0 * own.cpuSeconds / (before.cpuSeconds + after.cpuSeconds));
        milliseconds.push_back(own.cpuSeconds * 1e3);
    }
    benchmarks::report(state, "ratio", ratios);
    benchmarks::report(state, "cpu_ratio", cpuRatios);
    benchmarks::report(state, "cpu_ms", milliseconds);
}

BENCHMARK(technique)
    ->ArgName("case")
    ->DenseRange(0, kTechniqueCases.size() - 1, 1)
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime()
    ->Iterations(100);

} // namespace
