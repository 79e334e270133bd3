#include "shadows.h"

#include <cdr/base/error.h>
#include <cdr/measure/truth/truth.h>
#include <cdr/render/renderer.h>

#include <fmt/format.h>

#include <algorithm>

namespace cdr::experiments {

namespace {

/// How many lights the renderer has cast shadows.
constexpr std::size_t kMostLights = 4;

image::Raster<std::uint8_t> channelOf(const image::ImageRgba8& reached, std::size_t light) {
    image::Raster<std::uint8_t> channel(reached.width, reached.height);
    std::transform(reached.pixels.begin(), reached.pixels.end(), channel.pixels.begin(),
                   [&](const image::Rgba8& pixel) { return pixel[light]; });
    return channel;
}

} // namespace

void runShadows(const gpu::Device& device, const scene::SceneSetup& setup, const FrameCameras& cameras,
                const ShadowExperiment& experiment, const ShadowProgress& progress,
                const std::function<void(const ShadowResult&)>& take) {
    const scene::Scene& scene = setup.scene;
    if (scene.lights.empty()) {
        throw base::InputError(fmt::format("{}: it has no light that could cast a shadow", scene.name));
    }
    host::WorkerPool workers(experiment.options.threads);
    const measure::TruthCaster shapes(scene, workers);
    const measure::ShadowTruthCaster caster(scene, shapes.shapes());
    const render::GpuScene gpuScene(device, scene);
    const std::size_t lights = std::min(scene.lights.size(), kMostLights);
    std::vector<measure::ShadowImage> truths; // by frame and light
    const std::size_t steps = cameras.frames * (lights + experiment.techniques.size());
    std::size_t done = 0;
    for (std::uint32_t i = 0; i < cameras.frames; ++i) {
        const scene::Camera camera = cameras.at(setup.path, cameras.first + i);
        for (std::size_t light = 0; light < lights; ++light) {
            progress(done++, steps);
            truths.push_back(
                caster.cast(camera, experiment.options.width, experiment.options.height, light, workers));
        }
    }
    for (const std::string& technique : experiment.techniques) {
        render::RenderOptions options = experiment.options;
        options.technique = depth::namedTechnique(technique).technique;
        options.shadows = true;
        render::Renderer renderer(device, scene, gpuScene, options);
        for (std::uint32_t i = 0; i < cameras.frames; ++i) {
            progress(done++, steps);
            const render::Frame frame = renderer.render(cameras.at(setup.path, cameras.first + i));
            for (std::size_t light = 0; light < lights; ++light) {
                const measure::ShadowImage& truth = truths[i * lights + light];
                const image::Raster<std::uint8_t> reached = channelOf(frame.reached, light);
                take({.technique = technique,
                      .frame = cameras.first + i,
                      .light = light,
                      .wrong = measure::countWrongShadows(reached, truth),
                      .maps = frame.stats.shadows.maps,
                      .casters = frame.stats.shadows.casters,
                      .executeMs = frame.stats.times.executeMs,
                      .picture = frame.color,
                      .heatMap = measure::shadowHeatMap(reached, truth, frame.color)});
            }
        }
    }
}

} // namespace cdr::experiments
