// Recording on the real device: CPU time per draw, without culling, binning and executing.
// Targets: 120 ns per draw on one thread; from 50,000 draws on, two threads are 1.7 times as fast.

#include <cdr/gpu/device.h>
#include <cdr/render/renderer.h>
#include <scenes/cubes.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdint>
#include <limits>

namespace {

using namespace cdr;

struct Gpu {
    gpu::Instance instance{{.validate = false, .extensions = {}}};
    gpu::Device device{instance, ""};
};

void record(benchmark::State& state) {
    static const Gpu gpu;
    const scene::SceneSetup setup = scenes::makeCrowd(2013, static_cast<std::uint32_t>(state.range(0)));
    const render::GpuScene gpuScene(gpu.device, setup.scene);
    depth::Technique technique = depth::parseTechnique("cdr");
    technique.split = depth::SplitCount{static_cast<unsigned>(state.range(2))};
    render::Renderer renderer(gpu.device, setup.scene, gpuScene,
                              {.width = 320,
                               .height = 180,
                               .technique = technique,
                               .threads = static_cast<std::size_t>(state.range(1)),
                               .placement = platform::Placement::pinned,
                               .batching = render::kBatchings[static_cast<std::size_t>(state.range(3))]});
    const scene::Camera camera = setup.path.at(0);
    renderer.draw(camera); // the first frame allocates
    // The kernel may leave two threads on one CPU for milliseconds, which would disturb the measurement.
    const platform::PinnedThread pin(0, platform::allowedCpus());
    double leastMs = std::numeric_limits<double>::infinity();
    std::size_t draws = 0;
    for (auto iteration : state) {
        const render::FrameStats stats = renderer.draw(camera);
        state.SetIterationTime(stats.times.recordMs / 1000.0);
        leastMs = std::min(leastMs, stats.times.recordMs);
        draws = stats.draws;
    }
    // The least beside the mean: the time that recording takes undisturbed.
    state.counters["least_ms"] = leastMs;
    state.counters["least_ns_per_draw"] = leastMs * 1e6 / static_cast<double>(draws);
}

BENCHMARK(record)
    ->ArgNames({"draws", "threads", "cascades", "batching"}) // per object, push constants, instanced
    ->ArgsProduct({{1'000, 10'000, 50'000, 200'000}, {1, 2}, {1, 4}, {0, 1, 2}})
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime()
    // Manual time is a small part of a frame. A minimum time would take thousands of frames.
    ->Iterations(15);

} // namespace
