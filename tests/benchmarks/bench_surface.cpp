// Frames of each surface path against those that keep a G-buffer. They take turns, and what is reported is the median of the
// ratios of neighbours: of time, and of CPU time.

#include "paired_cost.h"

#include <cdr/render/renderer.h>
#include <scenes/open_scene.h>

#include <benchmark/benchmark.h>

#include <array>
#include <string>

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
    benchmarks::reportOver(state, setup.path, gbuffer, measured);
}

BENCHMARK(surface)
    ->ArgNames({"case", "surface", "threads"})
    ->ArgsProduct({benchmark::CreateDenseRange(0, kCases.size() - 1, 1), {0, 1, 2}, {1}})
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime()
    ->Iterations(60);

} // namespace
