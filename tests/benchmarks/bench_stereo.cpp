// Two eyes against one, of the same size for each eye. Frames take turns, and what is reported is the median of the ratios
// of neighbours: of time, and of CPU time. `mono_twice` is a renderer of one eye that draws both, one after the other.

#include <cdr/gpu/device.h>
#include <cdr/render/views/views_renderer.h>
#include <cdr/scene/stereo_rig.h>
#include <scenes/open_scene.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <ctime>
#include <string>
#include <vector>

namespace {

using namespace cdr;

struct StereoGpu {
    gpu::Instance instance{{.validate = false, .extensions = {}}};
    gpu::Device device{instance, ""};
};

/// Of one piece of work: seconds, and CPU seconds of all threads.
struct StereoCost {
    double seconds = 0.0;
    double cpuSeconds = 0.0;
};

StereoCost stereoCostOf(const auto& work) {
    const std::clock_t cpuBegin = std::clock();
    const auto begin = std::chrono::steady_clock::now();
    work();
    return {std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(),
            static_cast<double>(std::clock() - cpuBegin) / CLOCKS_PER_SEC};
}

void report(benchmark::State& state, const std::string& name, std::vector<double>& ratios) {
    std::sort(ratios.begin(), ratios.end());
    const auto at = [&](double share) {
        return ratios[static_cast<std::size_t>(share * static_cast<double>(ratios.size() - 1))];
    };
    state.counters[name] = at(0.5);
    state.counters[name + "_05"] = at(0.05);
    state.counters[name + "_95"] = at(0.95);
}

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
};

/// @param state case, width, eyes toed in
void stereo(benchmark::State& state) {
    static const StereoGpu gpu;
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
    for (int warm = 0; warm < 4; ++warm) {
        mono.draw(eyes[0]);
        both.draw(eyes);
    }
    std::vector<double> ratios;
    std::vector<double> cpuRatios;
    std::vector<double> twice;
    for (auto iteration : state) {
        const StereoCost one = stereoCostOf([&] { mono.draw(eyes[0]); });
        const StereoCost two = stereoCostOf([&] { both.draw(eyes); });
        const StereoCost alone = stereoCostOf([&] {
            mono.draw(eyes[0]);
            mono.draw(eyes[1]);
        });
        state.SetIterationTime(two.seconds);
        ratios.push_back(two.seconds / one.seconds);
        cpuRatios.push_back(two.cpuSeconds / one.cpuSeconds);
        twice.push_back(alone.seconds / one.seconds);
    }
    report(state, "ratio", ratios);
    report(state, "cpu_ratio", cpuRatios);
    report(state, "mono_twice", twice);
}

BENCHMARK(stereo)
    ->ArgNames({"case", "width", "toed_in"})
    ->ArgsProduct({benchmark::CreateDenseRange(0, kCases.size() - 1, 1), {640, 1280}, {0}})
    ->Args({1, 1280, 1})
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime()
    ->Iterations(40);

} // namespace
