#include "thread_sweep.h"

#include <cdr/measure/statistics/statistics.h>

#include <output/aov.h>

#include <utility>

namespace cdr::experiments {

namespace {

Spread spreadOf(const std::vector<double>& samples) {
    const double middle = measure::median(samples);
    const double quartiles = measure::percentile(samples, 75.0) - measure::percentile(samples, 25.0);
    return {.medianMs = middle, .spread = middle > 0.0 ? quartiles / middle : 0.0};
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
      m_frames(m_threads.size(), options.seed) {
    depth::Technique technique = depth::parseTechnique("cdr");
    technique.split = depth::SplitCount{m_common.variant.cascades};
    for (const std::size_t count : m_threads) {
        m_renderers.push_back(std::make_unique<render::Renderer>(
            device, setup.scene, gpuScene,
            render::RenderOptions{.width = options.width,
                                  .height = options.height,
                                  .technique = technique,
                                  .targets = m_common.variant.targets,
                                  .threads = count,
                                  .placement = options.placement,
                                  .submission = m_common.variant.submission,
                                  // A draw is a command here: that is what is counted.
                                  .batching = render::Batching::perObject}));
    }
}

void ThreadSweep::hash(const std::function<void()>& step) {
    for (const auto& renderer : m_renderers) {
        step();
        const render::Frame frame = renderer->render(m_camera);
        m_hashes.push_back(output::hashOf(frame));
        m_common.draws = frame.stats.draws;
    }
}

void ThreadSweep::repeat(const std::function<void()>& step) {
    const platform::PinnedThread pin(0, m_cpus);
    m_frames.draw([&](std::size_t point) {
        step();
        return runs::timed([&] { return m_renderers[point]->draw(m_camera); });
    });
}

std::vector<ScalingPoint> ThreadSweep::points() const {
    using Sample = runs::FrameSample;
    std::vector<ScalingPoint> points;
    for (std::size_t i = 0; i < m_threads.size(); ++i) {
        const auto spread = [&](double Sample::*part) { return spreadOf(m_frames.samples(i, part)); };
        const auto speedUp = [&](double Sample::*part) {
            return measure::median(m_frames.ratios(0, i, part));
        };
        ScalingPoint point = m_common;
        point.threads = m_threads[i];
        point.cull = spread(&Sample::cullMs);
        point.bin = spread(&Sample::binMs);
        point.record = spread(&Sample::recordMs);
        point.execute = spread(&Sample::executeMs);
        point.frame = spread(&Sample::frameMs);
        point.recordSpeedUp = speedUp(&Sample::recordMs);
        point.cullAndBinSpeedUp = speedUp(&Sample::cullAndBinMs);
        point.frameSpeedUp = speedUp(&Sample::frameMs);
        point.hash = m_hashes[i];
        point.sameImage = m_hashes[i] == m_hashes.front();
        points.push_back(point);
    }
    return points;
}

} // namespace cdr::experiments
