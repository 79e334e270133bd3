#pragma once

#include <cdr/gpu/device.h>
#include <cdr/gpu/instance.h>
#include <cdr/render/renderer.h>
#include <cdr/scene/camera_path.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <string>
#include <vector>

namespace cdr::benchmarks {

/// The device that a benchmark runs on, without validation.
struct Gpu {
    gpu::Instance instance{{.validate = false, .extensions = {}}};
    gpu::Device device{instance, ""};
};

/// Of one piece of work: seconds, and CPU seconds of all threads.
struct Cost {
    double seconds = 0.0;
    double cpuSeconds = 0.0;
};

inline Cost costOf(const auto& work) {
    const std::clock_t cpuBegin = std::clock();
    const auto begin = std::chrono::steady_clock::now();
    work();
    return {std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(),
            static_cast<double>(std::clock() - cpuBegin) / CLOCKS_PER_SEC};
}

/// Reports the median of values as NAME, and their 5 and 95 % quantiles as NAME_05 and NAME_95.
inline void report(benchmark::State& state, const std::string& name, std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const auto at = [&](double share) {
        return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
    };
    state.counters[name] = at(0.5);
    state.counters[name + "_05"] = at(0.05);
    state.counters[name + "_95"] = at(0.95);
}

/// Draws frames of a path with two renderers in turn. Reports the second one's time, and what it takes over the first.
inline void reportOver(benchmark::State& state, const scene::CameraPath& path, render::Renderer& base,
                       render::Renderer& measured) {
    std::uint32_t frame = 0;
    for (; frame < 4; ++frame) { // to warm up
        base.draw(path.at(frame));
        measured.draw(path.at(frame));
    }
    std::vector<double> ratios;
    std::vector<double> cpuRatios;
    for (auto iteration : state) {
        const scene::Camera camera = path.at(frame++);
        const Cost ofBase = costOf([&] { base.draw(camera); });
        const Cost own = costOf([&] { measured.draw(camera); });
        state.SetIterationTime(own.seconds);
        ratios.push_back(own.seconds / ofBase.seconds);
        cpuRatios.push_back(own.cpuSeconds / ofBase.cpuSeconds);
    }
    report(state, "ratio", ratios);
    report(state, "cpu_ratio", cpuRatios);
}

} // namespace cdr::benchmarks
