// Frames over the number of triangles of a scene, with levels of detail by object and without: `boulders` of ever finer
// meshes. The last line is the slope of time over triangles, both in logarithms: 0 where frames are bound by the picture.

#include "paired_cost.h"

#include <cdr/render/renderer.h>
#include <cdr/scene/lod/levels.h>
#include <scenes/boulders.h>
#include <scenes/open_scene.h>

#include <benchmark/benchmark.h>

#include <vector>

namespace {

using namespace cdr;

scene::SceneSetup bouldersOf(std::uint32_t subdivisions) {
    return scenes::makeBoulders(scenes::kDefaultSeed, {.subdivisions = subdivisions});
}

double trianglesOf(const scene::Scene& scene) {
    double triangles = 0.0;
    for (const std::uint32_t mesh : scene.instances.mesh) {
        triangles += static_cast<double>(scene.meshes[mesh].indices.size()) / 3.0;
    }
    return triangles;
}

/// @param state subdivisions of a boulder
void byObject(benchmark::State& state) {
    static const benchmarks::Gpu gpu;
    scene::SceneSetup setup = bouldersOf(static_cast<std::uint32_t>(state.range(0)));
    host::WorkerPool workers(2);
    const benchmarks::Cost making = benchmarks::costOf([&] { scene::makeLevels(setup.scene, workers); });
    const render::GpuScene onDevice(gpu.device, setup.scene);
    render::RenderOptions options{
        .width = 1280, .height = 720, .technique = depth::parseTechnique("anchored")};
    options.detail = {.mode = visibility::DetailMode::perObject, .pixels = 0.5};
    render::Renderer renderer(gpu.device, setup.scene, onDevice, options);
    std::size_t frame = 0;
    renderer.draw(setup.path.at(frame));
    for (auto iteration : state) {
        renderer.draw(setup.path.at(frame += 7u));
    }
    state.counters["triangles"] = trianglesOf(setup.scene);
    state.counters["make_s"] = making.seconds;
}

BENCHMARK(byObject)->ArgName("subdivisions")->DenseRange(1, 8)->Unit(benchmark::kMillisecond)->Iterations(24);

} // namespace
