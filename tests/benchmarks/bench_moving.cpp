// Moving cubes of a world, against frames of the same world that stands still: whole frames, edit included.
// Targets: all of 64,000 moved cost 1.25 times a still frame at most, 1 % of them 1.03 times.
// Still and moved frames take turns, and what is reported is the median of the ratios of neighbours: of time, and of CPU
// time, which other programs disturb less where the device is a software one.

#include <cdr/gpu/device.h>
#include <cdr/render/renderer.h>
#include <scenes/cubes.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <ctime>
#include <vector>

namespace {

using namespace cdr;

struct Gpu {
    gpu::Instance instance{{.validate = false, .extensions = {}}};
    gpu::Device device{instance, ""};
};

constexpr std::uint32_t kCubes = 64'000;

/// Of one piece of work: seconds, and CPU seconds of all threads.
struct Cost {
    double seconds = 0.0;
    double cpuSeconds = 0.0;
};

Cost costOf(const auto& work) {
    const std::clock_t cpuBegin = std::clock();
    const auto begin = std::chrono::steady_clock::now();
    work();
    return {std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(),
            static_cast<double>(std::clock() - cpuBegin) / CLOCKS_PER_SEC};
}

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
    static const Gpu gpu;
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
        const Cost still = costOf([&] { renderer.draw(camera); });
        isThere = !isThere;
        Cost edit;
        const Cost moved = costOf([&] {
            edit = costOf([&] { world.setTransforms(movers.handles, isThere ? movers.there : movers.here); });
            renderer.draw(camera);
        });
        state.SetIterationTime(moved.seconds);
        ratios.push_back(moved.seconds / still.seconds);
        cpuRatios.push_back(moved.cpuSeconds / still.cpuSeconds);
        editMs.push_back(edit.seconds * 1e3);
    }
    const auto quantile = [](std::vector<double>& values, double share) {
        std::sort(values.begin(), values.end());
        return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
    };
    state.counters["ratio"] = quantile(ratios, 0.5);
    state.counters["ratio_05"] = quantile(ratios, 0.05);
    state.counters["ratio_95"] = quantile(ratios, 0.95);
    state.counters["cpu_ratio"] = quantile(cpuRatios, 0.5);
    state.counters["cpu_05"] = quantile(cpuRatios, 0.05);
    state.counters["cpu_95"] = quantile(cpuRatios, 0.95);
    state.counters["edit_ms"] = quantile(editMs, 0.5);
}

BENCHMARK(move)
    ->ArgNames({"percent", "submission"}) // secondaries, primaries, gpu-driven
    ->ArgsProduct({{1, 10, 100}, {0, 1, 2}})
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime()
    ->Iterations(60);

} // namespace
