// Moving cubes of a world, against frames of the same world that stands still: whole frames, edit included.
// Targets: all of 64,000 moved cost 1.25 times a still frame at most, 1 % of them 1.03 times.
// Still and moved frames take turns. The results are medians of the ratios of neighbours, of time and of CPU time. On a
// software device other programs disturb CPU time less.

#include "paired_cost.h"

#include <cdr/render/renderer.h>
#include <scenes/cubes.h>

#include <benchmark/benchmark.h>

#include <cstdint>
#include <vector>

namespace {

using namespace cdr;

constexpr std::uint32_t kCubes = 64'000;

/// Some cubes spread over all places, and two transforms of each, a hundredth of a unit apart.
struct Movers {
    std::vector<scene::InstanceHandle> handles;
    std::vector<scene::Transform> here;
    std::vector<scene::Transform> there;

    Movers(const scene::World& world, std::size_t percent) {
        const scene::Instances& instances = world.scene().instances;
        for (std::size_t i = 0; i < instances.size(); i += 100 / percent) {
            handles.push_back(world.instance(i));
            here.push_back({.position = instances.position(i), .basis = instances.basis[i]});
            there.push_back({.position = instances.position(i) + 0.01, .basis = instances.basis[i]});
        }
    }
};

void move(benchmark::State& state) {
    static const benchmarks::Gpu gpu;
    scene::SceneSetup setup = scenes::makeRotation(2013, kCubes);
    scene::World world(std::move(setup.scene));
    const Movers movers(world, static_cast<std::size_t>(state.range(0)));
    render::GpuScene onDevice(gpu.device, world);
    render::Renderer renderer(gpu.device, onDevice,
                              {.technique = depth::parseTechnique("cdr"),
                               .submission = render::kSubmissions[static_cast<std::size_t>(state.range(1))]});
    const scene::Camera camera = setup.path.at(0);
    std::vector<double> ratios;
    std::vector<double> cpuRatios;
    std::vector<double> editMs;
    bool isThere = false;
    for (int warm = 0; warm < 4; ++warm) {
        renderer.draw(camera);
    }
    for (auto iteration : state) {
        const benchmarks::Cost still = benchmarks::costOf([&] { renderer.draw(camera); });
        isThere = !isThere;
        benchmarks::Cost edit;
        const benchmarks::Cost moved = benchmarks::costOf([&] {
            edit = benchmarks::costOf(
                [&] { world.setTransforms(movers.handles, isThere ? movers.there : movers.here); });
            renderer.draw(camera);
        });
        state.SetIterationTime(moved.seconds);
        ratios.push_back(moved.seconds / still.seconds);
        cpuRatios.push_back(moved.cpuSeconds / still.cpuSeconds);
        editMs.push_back(edit.seconds * 1e3);
    }
    benchmarks::report(state, "ratio", ratios);
    benchmarks::report(state, "cpu_ratio", cpuRatios);
    benchmarks::report(state, "edit_ms", editMs);
}

BENCHMARK(move)
    ->ArgNames({"percent", "submission"}) // secondaries, primaries, gpu-driven
    ->ArgsProduct({{1, 10, 100}, {0, 1, 2}})
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime()
    ->Iterations(60);

} // namespace
