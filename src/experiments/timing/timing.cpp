#include "timing.h"

#include <cdr/base/enum_names.h>
#include <cdr/base/error.h>
#include <cdr/platform/stopwatch.h>
#include <cdr/render/renderer.h>
#include <experiments/rivals/drawer.h>
#include <scenes/city.h>
#include <scenes/cubes.h>
#include <scenes/moving_scene.h>
#include <scenes/traffic.h>

#include <runs/interleaved_frames.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace cdr::experiments {

namespace {

constexpr double kUsPerMs = 1000.0;

constexpr base::EnumNames<TimingScene, kTimingScenes.size()> kSceneNames{"scene",
                                                                         {"rotation", "traffic", "city"}};

/// Draws a run of cameras with frames in flight; the sample is one frame's share.
runs::FrameSample timedRun(render::Renderer& renderer, const std::vector<scene::Camera>& cameras) {
    const platform::Stopwatch watch;
    for (const scene::Camera& camera : cameras) {
        renderer.submit(camera);
    }
    renderer.finish();
    return {.frameMs = watch.milliseconds() / static_cast<double>(cameras.size())};
}

scene::SceneSetup openTimed(const TimingOptions& options) {
    const bool moves = options.scene == TimingScene::traffic;
    if (moves && options.framesInFlight > 1) {
        throw base::InputError("several frames in flight need a scene that does not move, not traffic");
    }
    for (const TimingMode& mode : options.modes) {
        if (mode.idsAlone && options.framesInFlight > 1) {
            throw base::InputError("mode " + mode.name + " draws one frame at a time, not several in flight");
        }
        if (moves && (mode.meshes == TimingMeshes::unshared ||
                      mode.drawing.surface != render::SurfacePath::gbuffer || mode.idsAlone)) {
            throw base::InputError("mode " + mode.name + " needs a scene that does not move, not traffic");
        }
    }
    if (options.scene == TimingScene::city) {
        return scenes::makeCity(options.seed);
    }
    return moves ? scenes::makeTraffic(options.seed) : scenes::makeRotation(options.seed);
}

scene::Scene unshared(scene::Scene scene) {
    std::transform(scene.meshes.begin(), scene.meshes.end(), scene.meshes.begin(), scene::unshareVertices);
    for (scene::Material& material : scene.materials) {
        material.doubleSided = true; // no face is culled
    }
    return scene;
}

/// The scene as naive code draws it.
struct NaiveScene {
    NaiveScene(const gpu::Device& device, const scene::Scene& shared)
        : scene(unshared(shared)),
          onDevice(device, scene) {}
    scene::Scene scene;
    render::GpuScene onDevice;
};

/// Every mode's renderer over one scene, and what each took so far.
class Race {
  public:
    Race(const gpu::Device& device, const TimingOptions& options)
        : m_options(options),
          m_workers(options.threads),
          m_setup(openTimed(options)),
          m_moving(m_setup.motion ? std::make_unique<scenes::MovingScene>(m_setup.scene, m_setup.motion)
                                  : nullptr),
          m_gpuScene(m_moving != nullptr ? render::GpuScene(device, m_moving->world())
                                         : render::GpuScene(device, m_setup.scene)),
          m_frames(options.modes.size(), options.seed) {
        for (const TimingMode& mode : options.modes) {
            m_drawers.push_back(makeDrawer(device, mode));
        }
        m_path = m_setup.path;
        if (options.scene != TimingScene::city) { // which has a street to go along
            const scene::Camera first = m_setup.path.at(0);
            m_path = scene::turnPath(first, first.position, options.frames);
        }
    }

    void warmUp(std::uint32_t number) {
        show(number);
        m_frames.draw([&](std::size_t mode) { return draw(mode, number); });
    }

    /// Drops what was drawn so far, and draws what counts: runs of so many frames, each of every mode, on some rank. The
    /// frames of a run are in flight at once.
    void run(runs::TimedRanks& ranks, std::uint32_t length,
             const std::function<void(std::uint32_t frame)>& step) {
        m_frames.forget();
        const std::uint32_t runs = (m_options.frames + length - 1) / length;
        m_frames.divide(ranks, runs, [&](std::size_t mode, std::size_t unit) {
            const std::uint32_t first = static_cast<std::uint32_t>(unit) * length;
            const std::uint32_t count = std::min(length, m_options.frames - first);
            if (first >= m_next) {
                step(first);
                catchUp(first);
                m_next = first + count;
            }
            return length > 1 ? timedRun(m_drawers[mode].renderer(), cameras(first, count))
                              : draw(mode, first);
        });
    }

    std::vector<TimingResult> results() {
        std::vector<TimingResult> results;
        show(0);
        for (std::size_t mode = 0; mode < m_drawers.size(); ++mode) {
            results.push_back(summarise(mode));
            if (m_drawers[mode].shades()) { // no contender depends on the frames before
                m_drawers[mode].renderer().forgetFrames();
            }
            results.back().cascades = m_drawers[mode].render(m_path.at(0)).cascades;
        }
        return results;
    }

  private:
    void show(std::uint32_t number) {
        if (m_moving != nullptr) {
            m_moving->show(number, m_workers);
            m_gpuScene.update(); // else the first mode to draw would pay for all
        }
    }

    /// Passes over the frames that other ranks draw, which fitted splits keep to.
    void catchUp(std::uint32_t number) {
        for (; m_next < number; ++m_next) {
            show(m_next);
            for (Drawer& drawer : m_drawers) {
                drawer.skip(m_path.at(m_next));
            }
        }
        show(number);
    }

    runs::FrameSample draw(std::size_t mode, std::uint32_t number) {
        if (m_options.trace != nullptr && m_drawers[mode].shades()) { // no contender is traced
            m_options.trace->beginFrame(m_options.modes[mode].name);
        }
        return runs::timed([&] { return m_drawers[mode].draw(m_path.at(number)); });
    }

    std::vector<scene::Camera> cameras(std::uint32_t first, std::uint32_t count) const {
        std::vector<scene::Camera> cameras;
        for (std::uint32_t frame = first; frame < first + count; ++frame) {
            cameras.push_back(m_path.at(frame));
        }
        return cameras;
    }

    Drawer makeDrawer(const gpu::Device& device, const TimingMode& mode) {
        if (mode.idsAlone) {
            return {device, m_gpuScene, *mode.idsAlone, {m_options.width, m_options.height}, m_workers};
        }
        return Drawer(makeRenderer(device, mode));
    }

    std::unique_ptr<render::Renderer> makeRenderer(const gpu::Device& device, const TimingMode& mode) {
        render::RenderOptions options = mode.drawing;
        options.width = m_options.width;
        options.height = m_options.height;
        options.threads = m_options.threads;
        options.framesInFlight = m_options.framesInFlight;
        options.deviceClock = m_options.framesInFlight <= 1;
        options.trace = m_options.trace;
        if (m_moving != nullptr) {
            return std::make_unique<render::Renderer>(device, m_gpuScene, options);
        }
        if (mode.meshes == TimingMeshes::indexed) {
            return std::make_unique<render::Renderer>(device, m_setup.scene, m_gpuScene, options);
        }
        if (m_naive == nullptr) {
            m_naive = std::make_unique<NaiveScene>(device, m_setup.scene);
        }
        return std::make_unique<render::Renderer>(device, m_naive->scene, m_naive->onDevice, options);
    }

    double medianUs(std::size_t mode, double runs::FrameSample::*part) const {
        return kUsPerMs * m_frames.median(mode, part);
    }

    std::optional<double> deviceUs(std::size_t mode) const {
        const std::vector<double> deviceMs = m_frames.samples(mode, &runs::FrameSample::deviceMs);
        const bool isTimed = std::ranges::none_of(deviceMs, [](double ms) { return std::isnan(ms); });
        return isTimed ? std::optional(kUsPerMs * measure::median(deviceMs)) : std::nullopt;
    }

    /// The mode that an overhead is over.
    std::size_t baselineOf(std::size_t mode) const {
        const std::vector<TimingMode>& modes = m_options.modes;
        if (!modes[mode].isRival()) {
            return 0;
        }
        const auto isBaseline = [](const TimingMode& other) { return other.idsAlone && !other.isRival(); };
        const auto found = std::find_if(modes.begin(), modes.end(), isBaseline);
        return found != modes.end() ? static_cast<std::size_t>(found - modes.begin()) : 0;
    }

    TimingResult summarise(std::size_t mode) const {
        const std::size_t baseline = baselineOf(mode);
        std::vector<double> overheads = m_frames.ratios(mode, baseline, &runs::FrameSample::frameMs);
        std::transform(overheads.begin(), overheads.end(), overheads.begin(),
                       [](double ratio) { return 100.0 * (ratio - 1.0); });
        const std::vector<double> frameMs = m_frames.samples(mode, &runs::FrameSample::frameMs);
        TimingResult result;
        result.mode = m_options.modes[mode];
        result.medianUs = medianUs(mode, &runs::FrameSample::frameMs);
        result.lowUs = kUsPerMs * measure::percentile(frameMs, 5.0);
        result.highUs = kUsPerMs * measure::percentile(frameMs, 95.0);
        if (m_options.framesInFlight <= 1) {
            result.parts = TimingParts{.cullAndBinUs = medianUs(mode, &runs::FrameSample::cullAndBinMs),
                                       .recordUs = medianUs(mode, &runs::FrameSample::recordMs),
                                       .executeUs = medianUs(mode, &runs::FrameSample::executeMs),
                                       .deviceUs = deviceUs(mode),
                                       .draws = m_frames.median(mode, &runs::FrameSample::draws)};
        }
        result.over = m_options.modes[baseline].name;
        result.overheadPercent = measure::median(overheads);
        result.overheadPercent95 = measure::bootstrapMedian(overheads, m_options.seed + mode);
        return result;
    }

    const TimingOptions& m_options;
    platform::WorkerPool m_workers; ///< that deform meshes
    scene::SceneSetup m_setup;
    scene::CameraPath m_path;
    std::unique_ptr<scenes::MovingScene> m_moving; ///< where the scene moves
    render::GpuScene m_gpuScene;
    std::unique_ptr<NaiveScene> m_naive; ///< once a mode draws it
    std::vector<Drawer> m_drawers;       ///< by mode
    runs::InterleavedFrames m_frames;
    std::uint32_t m_next = 0; ///< frame that comes after those drawn or passed over
};

} // namespace

std::string_view nameOf(TimingScene scene) {
    return kSceneNames.nameOf(scene);
}

std::span<const std::string_view> timingSceneNames() {
    return kSceneNames.names;
}

TimingScene parseTimingScene(std::string_view name) {
    return kSceneNames.parse(name);
}

bool liesApart(const std::optional<measure::Interval>& overhead,
               const std::optional<measure::Interval>& floor) {
    if (!overhead || !floor) {
        return false;
    }
    const double noise = std::max(std::abs(floor->low), std::abs(floor->high));
    return overhead->low > noise || overhead->high < -noise;
}

std::vector<TimingResult> runTiming(const gpu::Device& device, const TimingOptions& options,
                                    const Progress& progress, runs::TimedRanks& ranks) {
    if (options.frames < 1 || options.modes.size() < 2) {
        throw base::InputError("timing needs a frame, and a mode beside the baseline");
    }
    const std::size_t all = std::size_t{kWarmUpFrames} + options.frames;
    Race race(device, options);
    for (std::uint32_t i = 0; i < kWarmUpFrames; ++i) {
        progress(i, all);
        race.warmUp(i);
    }
    if (options.trace != nullptr) {
        options.trace->stop();
    }
    race.run(ranks, options.framesInFlight > 1 ? kThroughputRun : 1,
             [&](std::uint32_t frame) { progress(std::size_t{kWarmUpFrames} + frame, all); });
    return ranks.isFirst() ? race.results() : std::vector<TimingResult>();
}

} // namespace cdr::experiments
