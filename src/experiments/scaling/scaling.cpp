#include "thread_sweep.h"

#include <cdr/base/format_error.h>
#include <scenes/cubes.h>

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <thread>

namespace cdr::experiments {

namespace {

std::size_t cpuCount() {
    return std::max(1u, std::thread::hardware_concurrency());
}

/// Ascending, each once, 1 among them: it is what the others are compared with.
std::vector<std::size_t> threadList(const ScalingOptions& options) {
    std::vector<std::size_t> list = options.threads.empty() ? threadSteps(cpuCount()) : options.threads;
    list.push_back(1);
    const std::set<std::size_t> sorted(list.begin(), list.end());
    return {sorted.begin(), sorted.end()};
}

ScalingFit fit(const std::vector<ScalingPoint>& points) {
    std::vector<measure::SpeedUp> all;
    std::vector<measure::SpeedUp> onCpus;
    for (const ScalingPoint& point : points) {
        all.push_back({.threads = static_cast<double>(point.threads), .factor = point.recordSpeedUp});
        if (point.threads <= cpuCount()) {
            onCpus.push_back(all.back());
        }
    }
    return {.variant = points.front().variant,
            .cubes = points.front().cubes,
            .serialFraction = measure::fitAmdahl(onCpus),
            .universal = measure::fitUniversalScalability(all)};
}

template <typename Value>
void requireAll(const char* what, const std::vector<Value>& values, std::size_t most) {
    if (values.empty()) {
        throw base::inputError("scaling: at least one number of {} is needed", what);
    }
    for (const Value value : values) {
        if (value < 1 || value > most) {
            throw base::inputError("{} must be 1 to {}, not {}", what, most, value);
        }
    }
}

} // namespace

double ScalingPoint::recordNsPerDraw() const {
    constexpr double kNsPerMs = 1e6;
    return draws > 0 ? record.medianMs * kNsPerMs / static_cast<double>(draws) : 0.0;
}

std::vector<std::size_t> threadSteps(std::size_t cpus) {
    const std::size_t most = std::min(2 * cpus, platform::WorkerPool::kMaxThreads);
    std::set<std::size_t> steps{1, std::min(cpus, most), most};
    for (std::size_t power = 1; power <= most; power *= 2) {
        steps.insert(power);
        if (power >= 2 && power + power / 2 <= most) {
            steps.insert(power + power / 2);
        }
    }
    return {steps.begin(), steps.end()};
}

void requireUsable(const ScalingOptions& options) {
    requireAll("draws", options.draws, scene::kMaxObjects);
    requireAll("threads", threadList(options), platform::WorkerPool::kMaxThreads);
    requireAll("cascades", options.cascades, depth::kMaxCascades);
    requireAll("repeats", std::vector{options.repeats}, 10'000);
    if (options.targets.empty() || options.submissions.empty()) {
        throw base::InputError("scaling: at least one kind of targets and one submission is needed");
    }
}

namespace {

std::vector<ScalingVariant> scalingVariants(const ScalingOptions& options) {
    std::vector<ScalingVariant> variants;
    for (const render::TargetsChoice targets : options.targets) {
        for (const render::Submission submission : options.submissions) {
            for (const unsigned cascades : options.cascades) {
                variants.push_back({targets, submission, cascades});
            }
        }
    }
    return variants;
}

} // namespace

ScalingResult runScaling(const gpu::Device& device, const ScalingOptions& options,
                         const NamedProgress& progress) {
    requireUsable(options);
    const std::vector<ScalingVariant> variants = scalingVariants(options);
    const std::size_t frames = options.draws.size() * variants.size() * threadList(options).size() *
                               (options.repeats + std::size_t{1});
    std::size_t done = 0;
    ScalingResult result;
    for (const std::uint32_t cubes : options.draws) {
        const double aspect = static_cast<double>(options.width) / options.height;
        const scene::SceneSetup setup = scenes::makeCrowd(options.seed, cubes, aspect);
        const render::GpuScene gpuScene(device, setup.scene);
        for (const ScalingVariant& variant : variants) {
            const std::string what = fmt::format("{} {} {} cascades {} draws", nameOf(variant.targets),
                                                 nameOf(variant.submission), variant.cascades, cubes);
            const auto step = [&] { progress(done++, frames, what); };
            ScalingPoint common;
            common.variant = variant;
            common.cubes = cubes;
            ThreadSweep sweep(device, options, setup, gpuScene, threadList(options), common);
            sweep.hash(step);
            for (std::uint32_t repeat = 0; repeat < options.repeats; ++repeat) {
                sweep.repeat(step);
            }
            const std::vector<ScalingPoint> points = sweep.points();
            result.fits.push_back(fit(points));
            result.points.insert(result.points.end(), points.begin(), points.end());
        }
    }
    return result;
}

} // namespace cdr::experiments
