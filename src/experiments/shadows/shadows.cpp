#include "shadows.h"

#include <cdr/base/format_error.h>
#include <cdr/measure/truth/truth.h>
#include <cdr/platform/host_memory.h>
#include <cdr/render/renderer.h>

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace cdr::experiments {

namespace {

/// What is drawn with.
struct ShadowVariant {
    std::string technique;
    render::RenderOptions options;
};

/// base::InputError for a method that casts no shadows.
std::vector<ShadowVariant> shadowVariants(const ShadowExperiment& experiment) {
    std::vector<ShadowVariant> variants;
    for (const depth::NamedTechnique& named : experiment.techniques) {
        for (const render::ShadowMethod method : experiment.methods) {
            ShadowVariant& variant = variants.emplace_back(ShadowVariant{named.name, experiment.options});
            variant.options.technique = named.technique;
            variant.options.shadows.method = method;
            if (!variant.options.shadows.isOn()) {
                throw base::InputError("shadows: the method none has nothing to compare");
            }
        }
    }
    return variants;
}

/// Fills in a frame's counts.
/// @param result names the technique, the method, the frame, the light and its channel.
ShadowResult compared(const render::Frame& frame, const measure::ShadowImage& truth, ShadowResult result) {
    const measure::RenderedLight light{frame.litMask, result.channel};
    result.wrong = measure::countWrongShadows(light, truth);
    result.maps = frame.stats.shadows.maps;
    result.casters = frame.stats.shadows.casters;
    result.executeMs = frame.stats.times.executeMs;
    result.picture = frame.color;
    result.heatMap = measure::shadowHeatMap(light, truth, frame.color);
    return result;
}

} // namespace

void runShadows(const gpu::Device& device, const scene::SceneSetup& setup,
                const options::FrameCameras& cameras, const ShadowExperiment& experiment,
                const Progress& progress, const std::function<void(const ShadowResult&)>& take) {
    const std::vector<ShadowVariant> variants = shadowVariants(experiment);
    const scene::Scene& scene = setup.scene;
    const std::vector<std::uint32_t> lights = scene::shadowLights(scene.lights);
    if (lights.empty()) {
        throw base::inputError("{}: it has no light that could cast a shadow", scene.name);
    }
    platform::requireHostBytes(
        platform::saturatingProduct({experiment.options.width, experiment.options.height, lights.size(),
                                     cameras.frames, sizeof(measure::ShadowPixel)}),
        fmt::format("the truth of {} frames under {} lights", cameras.frames, lights.size()));
    platform::WorkerPool workers(experiment.options.threads);
    const measure::TruthCaster shapes(scene, workers);
    const measure::ShadowTruthCaster caster(scene, shapes.shapes());
    const render::GpuScene gpuScene(device, scene);
    std::vector<measure::ShadowImage> truths; // by frame and light
    const std::size_t steps = cameras.frames * (lights.size() + variants.size());
    std::size_t done = 0;
    for (std::uint32_t i = 0; i < cameras.frames; ++i) {
        const scene::Camera camera = cameras.at(setup.path, cameras.first + i);
        for (const std::uint32_t light : lights) {
            progress(done++, steps);
            truths.push_back(
                caster.cast(camera, experiment.options.width, experiment.options.height, light, workers));
        }
    }
    for (const ShadowVariant& variant : variants) {
        render::Renderer renderer(device, scene, gpuScene, variant.options);
        renderer.draw(cameras.at(setup.path, cameras.first)); // what compiles late is not timed
        renderer.forgetFrames();
        image::ImageRgba8 reachedBefore;
        for (std::uint32_t i = 0; i < cameras.frames; ++i) {
            progress(done++, steps);
            const render::Frame frame = renderer.render(cameras.at(setup.path, cameras.first + i));
            for (std::size_t channel = 0; channel < lights.size(); ++channel) {
                const measure::ShadowImage& truth = truths[i * lights.size() + channel];
                ShadowResult result;
                result.technique = variant.technique;
                result.method = nameOf(variant.options.shadows.method);
                result.frame = cameras.first + i;
                result.light = lights[channel];
                result.channel = channel;
                if (i > 0) {
                    result.flips =
                        measure::countShadowFlips({.light = {reachedBefore, channel},
                                                   .truth = truths[(i - 1) * lights.size() + channel]},
                                                  {.light = {frame.litMask, channel}, .truth = truth});
                }
                take(compared(frame, truth, std::move(result)));
            }
            reachedBefore = frame.litMask;
        }
    }
}

} // namespace cdr::experiments
