#include "forecast.h"

#include <cdr/measure/truth/truth.h>
#include <cdr/platform/stopwatch.h>
#include <cdr/platform/worker_pool.h>
#include <cdr/render/gpu_scene.h>
#include <cdr/render/renderer.h>
#include <scenes/cubes.h>
#include <scenes/open_scene.h>

#include <algorithm>
#include <limits>

namespace cdr::cli {

namespace {

/// What the piece of work takes on the machine that the plan's seconds are of: two CPUs under lavapipe.
constexpr double kPlannedSeconds = 0.05;

constexpr std::uint32_t kFrames = 10;
constexpr int kRounds = 5;      ///< the quickest counts, since whatever else runs only adds
constexpr double kTooFew = 5.0; ///< seconds of a plan that say less than the pace does

} // namespace

double measuredPace(const gpu::Device& device, std::size_t threads) {
    const scene::SceneSetup setup = scenes::makeAfc(scenes::kDefaultSeed);
    const render::GpuScene onDevice(device, setup.scene);
    render::Renderer renderer(
        device, setup.scene, onDevice,
        {.width = 640, .height = 360, .technique = depth::parseTechnique("anchored"), .threads = threads});
    platform::WorkerPool workers(threads);
    double quickest = std::numeric_limits<double>::infinity();
    for (int round = 0; round < kRounds; ++round) {
        const platform::Stopwatch watch;
        for (std::uint32_t frame = 0; frame < kFrames; ++frame) {
            renderer.draw(setup.path.at(frame));
        }
        measure::castTruth(setup.scene, setup.path.at(0), 640, 360, workers);
        quickest = std::min(quickest, watch.seconds());
    }
    return quickest / kPlannedSeconds;
}

Forecast::Forecast(const std::vector<report::Section>& plan, double pace) : m_pace(pace) {
    for (const report::Section& section : plan) {
        m_left += section.expectedSeconds;
    }
}

void Forecast::done(const report::Section& section, double seconds) {
    m_left -= section.expectedSeconds;
    m_expected += section.expectedSeconds;
    m_taken += seconds;
}

double Forecast::secondsLeft() const {
    return m_left * (m_taken > kTooFew ? m_taken / m_expected : m_pace);
}

} // namespace cdr::cli
