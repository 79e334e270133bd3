// Frames of each surface path against those that keep a G-buffer. They take turns, and what is reported is the median of the
// ratios of neighbours: of time, and of CPU time.

#include "paired_cost.h"

#include <cdr/render/renderer.h>
#include <scenes/open_scene.h>

#include <benchmark/benchmark.h>

#include <array>
#include <string>
#include <vector>

namespace {

using namespace cdr;

struct SurfaceCase {
    const char* scene;
    const char* technique;
};

constexpr std::array kCases{SurfaceCase{"rotation", "standard"}, SurfaceCase{"rotation", "anchored"},
                            SurfaceCase{"rotation", "log"}, SurfaceCase{"afc", "anchored"},
                            SurfaceCase{"city", "anchored"}};

/// @param state case, surface path, threads
void surface(benchmark::State& state) {
    static const benchmarks::Gpu gpu;
    const SurfaceCase& drawn = kCases[static_cast<std::size_t>(state.range(0))];
    const render::SurfacePath path = render::kSurfacePaths[static_cast<std::size_t>(state.range(1))];
    state.SetLabel(std::string(drawn.scene) + " " + drawn.technique + " " + std::string(nameOf(path)));
    const scene::SceneSetup setup = scenes::openScene(drawn.scene, scenes::kDefaultSeed).setup;
    const render::GpuScene onDevice(gpu.device, setup.scene);
    render::RenderOptions options{.technique = depth::parseTechnique(drawn.technique),
                                  .threads = static_cast<std::size_t>(state.range(2))};
    render::Renderer gbuffer(gpu.device, setup.scene, onDevice, options);
    options.surface = path;
    render::Renderer measured(gpu.device, setup.scene, onDevice, options);
    std::uint32_t frame = 0;
    for (; frame < 4; ++frame) {
        gbuffer.draw(setup.path.at(frame));
        measured.draw(setup.path.at(frame));
    }
    std::vector<double> ratios;
    std::vector<double> cpuRatios;
    for (auto iteration : state) {
        const scene::Camera camera = setup.path.at(frame++);
        const benchmarks::Cost kept = benchmarks::costOf([&] { gbuffer.draw(camera); });
        const benchmarks::Cost own = benchmarks::costOf([&] { measured.draw(camera); });
        state.SetIterationTime(own.seconds);
        ratios.push_back(own.seconds / kept.seconds);
        cpuRatios.push_back(own.cpuSeconds / kept.cpuSeconds);
    }
    benchmarks::report(state, "ratio", ratios);
    benchmarks::report(state, "cpu_ratio", cpuRatios);
}

BENCHMARK(surface)
    ->ArgNames({"case", "surface", "threads"})
    ->ArgsProduct({benchmark::CreateDenseRange(0, kCases.size() - 1, 1), {0, 1, 2}, {1}})
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime()
    ->Iterations(60);

} // namespace
