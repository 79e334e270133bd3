#include "timing.h"

#include <cdr/base/error.h>
#include <cdr/render/renderer.h>
#include <experiments/shuffled_order.h>
#include <scenes/cubes.h>

#include <algorithm>
#include <chrono>
#include <memory>

namespace cdr::experiments {

namespace {

/// What one mode took, one entry per frame.
struct Samples {
    std::vector<double> frameUs;
    std::vector<double> cullAndBinUs;
    std::vector<double> recordUs;
    std::vector<double> executeUs;
    std::vector<double> draws;
};

constexpr double kUsPerMs = 1000.0;

void drawAndTime(render::Renderer& renderer, const scene::Camera& camera, Samples& samples) {
    const auto begin = std::chrono::steady_clock::now();
    const render::FrameStats stats = renderer.draw(camera);
    const std::chrono::duration<double, std::micro> passed = std::chrono::steady_clock::now() - begin;
    samples.frameUs.push_back(passed.count());
    samples.cullAndBinUs.push_back(kUsPerMs * (stats.times.cullMs + stats.times.binMs));
    samples.recordUs.push_back(kUsPerMs * stats.times.recordMs);
    samples.executeUs.push_back(kUsPerMs * stats.times.executeMs);
    samples.draws.push_back(static_cast<double>(stats.draws));
}

/// Draws a run of cameras with frames in flight; the sample is one frame's share.
void drawRunAndTime(render::Renderer& renderer, const std::vector<scene::Camera>& cameras, Samples& samples) {
    const auto begin = std::chrono::steady_clock::now();
    for (const scene::Camera& camera : cameras) {
        renderer.submit(camera);
    }
    renderer.finish();
    const std::chrono::duration<double, std::micro> passed = std::chrono::steady_clock::now() - begin;
    samples.frameUs.push_back(passed.count() / static_cast<double>(cameras.size()));
}

scene::Scene unshared(scene::Scene scene) {
    std::transform(scene.meshes.begin(), scene.meshes.end(), scene.meshes.begin(), scene::unshareVertices);
    for (scene::Material& material : scene.materials) {
        material.doubleSided = true; // no face is culled
    }
    return scene;
}

TimingResult summarise(const TimingMode& mode, const Samples& samples, const Samples& standard,
                       std::uint64_t seed) {
    std::vector<double> overheads(samples.frameUs.size());
    std::transform(samples.frameUs.begin(), samples.frameUs.end(), standard.frameUs.begin(),
                   overheads.begin(),
                   [](double us, double standardUs) { return 100.0 * (us / standardUs - 1.0); });
    TimingResult result;
    result.mode = mode;
    result.medianUs = measure::median(samples.frameUs);
    result.lowUs = measure::percentile(samples.frameUs, 5.0);
    result.highUs = measure::percentile(samples.frameUs, 95.0);
    if (!samples.recordUs.empty()) {
        result.parts = TimingParts{.cullAndBinUs = measure::median(samples.cullAndBinUs),
                                   .recordUs = measure::median(samples.recordUs),
                                   .executeUs = measure::median(samples.executeUs),
                                   .draws = measure::median(samples.draws)};
    }
    result.overheadPercent = measure::median(overheads);
    result.overheadPercent95 = measure::bootstrapMedian(overheads, seed);
    return result;
}

/// Every mode's renderer over one scene, and what each took so far.
class Race {
  public:
    Race(const gpu::Device& device, const TimingOptions& options)
        : m_options(options),
          m_setup(scenes::makeRotation(options.seed)),
          m_gpuScene(device, m_setup.scene),
          m_unsharedScene(unshared(m_setup.scene)),
          m_unsharedGpuScene(device, m_unsharedScene),
          m_order(options.modes.size(), options.seed),
          m_samples(options.modes.size()) {
        for (const TimingMode& mode : options.modes) {
            const bool isIndexed = mode.meshes == TimingMeshes::indexed;
            m_renderers.push_back(std::make_unique<render::Renderer>(
                device, isIndexed ? m_setup.scene : m_unsharedScene,
                isIndexed ? m_gpuScene : m_unsharedGpuScene,
                render::RenderOptions{.width = options.width,
                                      .height = options.height,
                                      .technique = mode.technique,
                                      .targets = mode.targets,
                                      .threads = options.threads,
                                      .submission = mode.submission,
                                      .batching = mode.batching,
                                      .framesInFlight = options.framesInFlight,
                                      .trace = options.trace}));
        }
        const scene::Camera first = m_setup.path.at(0);
        m_path = scene::turnPath(first, first.position, options.frames);
    }

    void drawFrame(std::uint32_t number) {
        const scene::Camera camera = m_path.at(number);
        for (const std::size_t mode : m_order.next()) {
            if (m_options.trace != nullptr) {
                m_options.trace->beginFrame(m_options.modes[mode].name);
            }
            drawAndTime(*m_renderers[mode], camera, m_samples[mode]);
        }
    }

    /// Every mode draws `count` frames from `first` on, several in flight.
    void drawRun(std::uint32_t first, std::uint32_t count) {
        std::vector<scene::Camera> cameras;
        for (std::uint32_t frame = first; frame < first + count; ++frame) {
            cameras.push_back(m_path.at(frame));
        }
        for (const std::size_t mode : m_order.next()) {
            drawRunAndTime(*m_renderers[mode], cameras, m_samples[mode]);
        }
    }

    void forgetSamples() {
        for (Samples& samples : m_samples) {
            samples = {};
        }
    }

    std::vector<TimingResult> results() {
        std::vector<TimingResult> results;
        for (std::size_t mode = 0; mode < m_renderers.size(); ++mode) {
            results.push_back(
                summarise(m_options.modes[mode], m_samples[mode], m_samples.front(), m_options.seed + mode));
            results.back().cascades = m_renderers[mode]->render(m_path.at(0)).cascades.size();
        }
        return results;
    }

  private:
    const TimingOptions& m_options;
    scene::SceneSetup m_setup;
    scene::CameraPath m_path;
    render::GpuScene m_gpuScene;
    scene::Scene m_unsharedScene;
    render::GpuScene m_unsharedGpuScene;
    std::vector<std::unique_ptr<render::Renderer>> m_renderers; ///< by mode
    ShuffledOrder m_order;
    std::vector<Samples> m_samples; ///< by mode
};

} // namespace

std::vector<TimingResult> runTiming(const gpu::Device& device, const TimingOptions& options,
                                    const TimingProgress& progress) {
    if (options.frames < 1 || options.modes.size() < 2) {
        throw base::InputError("timing needs a frame, and a mode beside the baseline");
    }
    const std::size_t all = std::size_t{kWarmUpFrames} + options.frames;
    Race race(device, options);
    for (std::uint32_t i = 0; i < kWarmUpFrames; ++i) {
        progress(i, all);
        race.drawFrame(i);
    }
    race.forgetSamples();
    if (options.trace != nullptr) {
        options.trace->stop();
    }
    const std::uint32_t step = options.framesInFlight > 1 ? kThroughputRun : 1;
    for (std::uint32_t i = 0; i < options.frames; i += step) {
        progress(std::size_t{kWarmUpFrames} + i, all);
        if (options.framesInFlight > 1) {
            race.drawRun(i, std::min(step, options.frames - i));
        } else {
            race.drawFrame(i);
        }
    }
    return race.results();
}

} // namespace cdr::experiments
