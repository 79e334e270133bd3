#include "stages.h"

#include <cdr/base/error.h>
#include <cdr/render/renderer.h>
#include <scenes/cubes.h>

#include <runs/interleaved_frames.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

namespace cdr::experiments {

namespace {

/// What is left out of a frame.
enum class Variant : std::size_t { whole, noLights, noPixels, noCubes, neither };
constexpr std::size_t kVariants = 5;

std::size_t indexOf(Variant variant) {
    return static_cast<std::size_t>(variant);
}

scene::Scene withoutLights(scene::Scene scene) {
    scene.lights.clear();
    return scene;
}

scene::Scene withoutCubes(scene::Scene scene) {
    scene.instances = {};
    return scene;
}

/// The frames of all variants, drawn in turns.
class StageRace {
  public:
    StageRace(const gpu::Device& device, const TimingOptions& options)
        : m_options(options),
          m_setup(scenes::makeRotation(options.seed)),
          m_noLights(withoutLights(m_setup.scene)),
          m_noCubes(withoutCubes(m_setup.scene)),
          m_gpuScenes{std::make_unique<render::GpuScene>(device, m_setup.scene),
                      std::make_unique<render::GpuScene>(device, m_noLights),
                      std::make_unique<render::GpuScene>(device, m_noCubes)},
          m_frames(kVariants, options.seed) {
        const vk::Extent2D whole{options.width, options.height};
        const vk::Extent2D few = fewPixels(whole);
        addRenderer(device, m_setup.scene, *m_gpuScenes[0], whole);
        addRenderer(device, m_noLights, *m_gpuScenes[1], whole);
        addRenderer(device, m_setup.scene, *m_gpuScenes[0], few);
        addRenderer(device, m_noCubes, *m_gpuScenes[2], whole);
        addRenderer(device, m_noCubes, *m_gpuScenes[2], few);
        const scene::Camera first = m_setup.path.at(0);
        m_path = scene::turnPath(first, first.position, options.frames);
    }

    void run(const Progress& progress, runs::TimedRanks& ranks) {
        std::size_t done = 0;
        const std::size_t all = std::size_t{runs::InterleavedFrames::kWarmUp} + m_options.frames;
        m_frames.run(
            ranks, m_options.frames, [&] { progress(done++, all); },
            [&](std::size_t variant, std::uint32_t frame) {
                return m_renderers[variant]->draw(m_path.at(frame));
            });
    }

    std::vector<StageCost> costs() const {
        const std::vector<double> frame = of(Variant::whole, &runs::FrameSample::frameMs);
        const std::vector<double> cull = of(Variant::whole, &runs::FrameSample::cullAndBinMs);
        const std::vector<double> record = of(Variant::whole, &runs::FrameSample::recordMs);
        const std::vector<double> whole = executeOf(Variant::whole);
        const std::vector<double> noLights = executeOf(Variant::noLights);
        const std::vector<double> noPixels = executeOf(Variant::noPixels);
        const std::vector<double> noCubes = executeOf(Variant::noCubes);
        const std::vector<double> neither = executeOf(Variant::neither);
        return {
            cost("cull and bin", "measured", cull),
            cost("record", "measured", record),
            cost("split and other CPU", "measured", sum({{1, frame}, {-1, cull}, {-1, record}, {-1, whole}})),
            cost("submit and wait", "no cubes, no pixels", neither),
            cost("vertices and set-up", "no pixels", sum({{1, noPixels}, {-1, neither}})),
            cost("clear and background", "no cubes", sum({{1, noCubes}, {-1, neither}})),
            cost("covered pixels", "no lights",
                 sum({{1, noLights}, {-1, noPixels}, {-1, noCubes}, {1, neither}})),
            cost("lights", "no lights", sum({{1, whole}, {-1, noLights}})),
            cost("frame", "measured", frame)};
    }

  private:
    using Term = std::pair<double, const std::vector<double>&>;

    void addRenderer(const gpu::Device& device, const scene::Scene& scene, const render::GpuScene& gpuScene,
                     vk::Extent2D extent) {
        render::RenderOptions options = m_options.modes.front().drawing;
        options.width = extent.width;
        options.height = extent.height;
        options.threads = m_options.threads;
        m_renderers.push_back(std::make_unique<render::Renderer>(device, scene, gpuScene, options));
    }

    std::vector<double> of(Variant variant, double runs::FrameSample::*part) const {
        return m_frames.samples(indexOf(variant), part);
    }
    std::vector<double> executeOf(Variant variant) const {
        return of(variant, &runs::FrameSample::executeMs);
    }

    static std::vector<double> sum(const std::vector<Term>& terms) {
        std::vector<double> sums(terms.front().second.size());
        for (const auto& [factor, values] : terms) {
            for (std::size_t i = 0; i < sums.size(); ++i) {
                sums[i] += factor * values[i];
            }
        }
        return sums;
    }

    StageCost cost(const char* name, const char* how, std::vector<double> ms) const {
        for (double& value : ms) {
            value *= 1000.0;
        }
        const double frameUs = 1000.0 * m_frames.median(indexOf(Variant::whole), &runs::FrameSample::frameMs);
        const double medianUs = measure::median(ms);
        return {.name = name,
                .how = how,
                .medianUs = medianUs,
                .us95 = measure::bootstrapMedian(ms, m_options.seed),
                .framePercent = 100.0 * medianUs / frameUs};
    }

    const TimingOptions& m_options;
    scene::SceneSetup m_setup;
    scene::Scene m_noLights;
    scene::Scene m_noCubes;
    scene::CameraPath m_path;
    std::array<std::unique_ptr<render::GpuScene>, 3> m_gpuScenes;
    std::vector<std::unique_ptr<render::Renderer>> m_renderers; ///< by Variant
    runs::InterleavedFrames m_frames;
};

} // namespace

vk::Extent2D fewPixels(vk::Extent2D whole) {
    constexpr double kShorter = 9.0;
    const double scale = kShorter / std::max(1u, std::min(whole.width, whole.height));
    const auto side = [scale](std::uint32_t pixels) {
        return static_cast<std::uint32_t>(std::max(1.0, std::round(scale * pixels)));
    };
    return {side(whole.width), side(whole.height)};
}

void requireStages(const TimingMode& mode) {
    if (mode.meshes == TimingMeshes::unshared) {
        throw base::InputError(mode.name + " cannot be measured with --stages: it has meshes of its own");
    }
}

std::vector<StageCost> runStages(const gpu::Device& device, const TimingOptions& options,
                                 const Progress& progress, runs::TimedRanks& ranks) {
    if (options.frames < 1 || options.modes.empty()) {
        throw base::InputError("stages need a frame and a mode");
    }
    StageRace race(device, options);
    race.run(progress, ranks);
    return ranks.isFirst() ? race.costs() : std::vector<StageCost>();
}

} // namespace cdr::experiments
