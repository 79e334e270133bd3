// Frames over the number of triangles in the scene, with levels of detail, of ever finer meshes. `boulders` (200 instances of 4
// meshes) goes by object and by cluster, `terrain` (one mesh) by cluster. `slope` is that of the frame's time over triangles, both
// in logarithms, from the first size to this one. It is 0 where frames are bound by the picture, 1 where they are by the scene.

#include "paired_cost.h"

#include <cdr/render/renderer.h>
#include <scenes/boulders.h>
#include <scenes/open_scene.h>
#include <scenes/terrain.h>

#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace {

using namespace cdr;

enum Case : std::int64_t { bouldersByObject, bouldersByCluster, terrainByCluster };

scene::SceneSetup sceneOf(std::int64_t kind, std::int64_t fineness) {
    return kind == terrainByCluster
               ? scenes::makeTerrain(scenes::kDefaultSeed, std::uint32_t{64} << fineness)
               : scenes::makeBoulders(scenes::kDefaultSeed,
                                      {.subdivisions = static_cast<std::uint32_t>(fineness)});
}

double trianglesOf(const scene::Scene& scene) {
    double triangles = 0.0;
    for (const std::uint32_t mesh : scene.instances.mesh) {
        triangles += static_cast<double>(scene.meshes[mesh].indices.size()) / 3.0;
    }
    return triangles;
}

/// The largest so far, of the whole process, in GiB.
double peakGib() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / (1 << 20);
}

struct Size {
    double triangles = 0.0;
    double ms = 0.0;
};

/// @param state case, fineness
void detail(benchmark::State& state) {
    static const benchmarks::Gpu gpu;
    static std::map<std::int64_t, Size> first;
    const std::int64_t kind = state.range(0);
    const auto mode =
        kind == bouldersByObject ? visibility::DetailMode::perObject : visibility::DetailMode::perCluster;
    state.SetLabel(std::string(kind == terrainByCluster ? "terrain by " : "boulders by ") +
                   std::string(nameOf(mode)));
    scene::SceneSetup setup = sceneOf(kind, state.range(1));
    platform::WorkerPool workers(2);
    const benchmarks::Cost making =
        benchmarks::costOf([&] { visibility::prepareDetail(setup.scene, mode, workers); });
    const render::GpuScene onDevice(gpu.device, setup.scene);
    render::RenderOptions options{
        .width = 1280, .height = 720, .technique = depth::parseTechnique("anchored")};
    options.detail = {.mode = mode, .pixels = 0.5};
    render::Renderer renderer(gpu.device, setup.scene, onDevice, options);
    std::uint32_t frame = 0;
    renderer.draw(setup.path.at(frame));
    std::vector<double> ms;
    for (auto iteration : state) {
        frame += 7;
        const benchmarks::Cost cost = benchmarks::costOf([&] { renderer.draw(setup.path.at(frame)); });
        state.SetIterationTime(cost.seconds);
        ms.push_back(cost.seconds * 1e3);
    }
    benchmarks::report(state, "ms", ms);
    const Size size{.triangles = trianglesOf(setup.scene), .ms = state.counters["ms"]};
    const Size& smallest = first.try_emplace(kind, size).first->second;
    state.counters["triangles"] = size.triangles;
    state.counters["slope"] =
        size.triangles > smallest.triangles
            ? std::log(size.ms / smallest.ms) / std::log(size.triangles / smallest.triangles)
            : 0.0;
    state.counters["make_s"] = making.seconds;
    state.counters["peak_gib"] = peakGib();
}

BENCHMARK(detail)
    ->ArgNames({"case", "fineness"})
    ->ArgsProduct({{bouldersByObject, bouldersByCluster}, benchmark::CreateDenseRange(1, 8, 1)})
    ->ArgsProduct({{terrainByCluster}, benchmark::CreateDenseRange(0, 5, 1)})
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime()
    ->Iterations(40);

} // namespace
