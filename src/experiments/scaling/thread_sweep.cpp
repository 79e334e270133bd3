#include "thread_sweep.h"

#include <cdr/measure/statistics/statistics.h>
#include <cdr/platform/stopwatch.h>

#include <program/sha256.h>

#include <algorithm>
#include <utility>

namespace cdr::experiments {

namespace {

Spread spreadOf(const std::vector<double>& samples) {
    const double middle = measure::median(samples);
    const double quartiles = measure::percentile(samples, 75.0) - measure::percentile(samples, 25.0);
    return {.medianMs = middle, .spread = middle > 0.0 ? quartiles / middle : 0.0};
}

/// How much faster than `base`, repeat by repeat, so that what slows a whole repeat cancels.
double speedUp(const std::vector<double>& base, const std::vector<double>& samples) {
    std::vector<double> ratios(samples.size());
    std::transform(base.begin(), base.end(), samples.begin(), ratios.begin(),
                   [](double one, double many) { return many > 0.0 ? one / many : 1.0; });
    return measure::median(ratios);
}

/// One hash over the whole G-buffer and the picture.
std::string hashOf(const render::Frame& frame) {
    return program::sha256Of(program::sha256Of(frame.color.pixels) + program::sha256Of(frame.gbuffer.pixels));
}

} // namespace

ThreadSweep::ThreadSweep(const gpu::Device& device, const ScalingOptions& options,
                         const scene::SceneSetup& setup, const render::GpuScene& gpuScene,
                         std::vector<std::size_t> threads, ScalingPoint common)
    : m_cpus(options.placement == platform::Placement::pinned ? platform::allowedCpus()
                                                              : std::vector<std::size_t>()),
      m_camera(setup.path.at(0)),
      m_threads(std::move(threads)),
      m_common(std::move(common)),
      m_samples(m_threads.size()) {
    depth::Technique technique = depth::parseTechnique("cdr");
    technique.split = depth::SplitCount{m_common.cascades};
    for (const std::size_t count : m_threads) {
        m_renderers.push_back(std::make_unique<render::Renderer>(
            device, setup.scene, gpuScene,
            render::RenderOptions{.width = options.width,
                                  .height = options.height,
                                  .technique = technique,
                                  .targets = m_common.targets,
                                  .threads = count,
                                  .placement = options.placement,
                                  .submission = m_common.submission,
                                  // A draw is a command here: that is what is counted.
                                  .batching = render::Batching::perObject}));
    }
}

void ThreadSweep::hash(const std::function<void()>& step) {
    for (const auto& renderer : m_renderers) {
        step();
        const render::Frame frame = renderer->render(m_camera);
        m_hashes.push_back(hashOf(frame));
        m_common.draws = frame.stats.draws;
    }
}

void ThreadSweep::repeat(std::size_t number, const std::function<void()>& step) {
    const platform::PinnedThread pin(0, m_cpus);
    for (std::size_t i = 0; i < m_renderers.size(); ++i) {
        const std::size_t point = (number + i) % m_renderers.size();
        step();
        const platform::Stopwatch watch;
        const render::FrameTimes times = m_renderers[point]->draw(m_camera).times;
        const double frameMs = watch.milliseconds();
        Samples& samples = m_samples[point];
        samples.cull.push_back(times.cullMs);
        samples.bin.push_back(times.binMs);
        samples.cullAndBin.push_back(times.cullMs + times.binMs);
        samples.record.push_back(times.recordMs);
        samples.execute.push_back(times.executeMs);
        samples.frame.push_back(frameMs);
    }
}

std::vector<ScalingPoint> ThreadSweep::points() const {
    std::vector<ScalingPoint> points;
    const Samples& one = m_samples.front();
    for (std::size_t i = 0; i < m_threads.size(); ++i) {
        const Samples& samples = m_samples[i];
        ScalingPoint point = m_common;
        point.threads = m_threads[i];
        point.cull = spreadOf(samples.cull);
        point.bin = spreadOf(samples.bin);
        point.record = spreadOf(samples.record);
        point.execute = spreadOf(samples.execute);
        point.frame = spreadOf(samples.frame);
        point.recordSpeedUp = speedUp(one.record, samples.record);
        point.cullAndBinSpeedUp = speedUp(one.cullAndBin, samples.cullAndBin);
        point.frameSpeedUp = speedUp(one.frame, samples.frame);
        point.hash = m_hashes[i];
        point.sameImage = m_hashes[i] == m_hashes.front();
        points.push_back(point);
    }
    return points;
}

} // namespace cdr::experiments
