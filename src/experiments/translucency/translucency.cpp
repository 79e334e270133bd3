#include "translucency.h"

#include <cdr/base/error.h>
#include <cdr/gpu/memory.h>
#include <cdr/measure/statistics/statistics.h>
#include <cdr/render/renderer.h>
#include <cdr/visibility/blended.h>
#include <experiments/frame_notes.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <string>
#include <utility>

namespace cdr::experiments {

namespace {

/// base::InputError unless a split may have that many.
depth::Split splitOf(unsigned cascades) {
    return depth::parseSplit("count:" + std::to_string(cascades));
}

render::RenderOptions optionsFor(const TranslucencyExperiment& experiment, unsigned cascades,
                                 render::Translucency method) {
    return {.width = experiment.width,
            .height = experiment.height,
            .technique = depth::Technique{experiment.mapping, splitOf(cascades), depth::DepthFormat::d32f},
            .threads = experiment.threads,
            .translucency = {.method = method, .mostBytes = experiment.mostBytes}};
}

/// One frame of one method, compared with the truth.
TranslucencyResult compare(const gpu::Device& device, const scene::SceneSetup& setup,
                           const render::GpuScene& gpuScene, render::RenderOptions options,
                           const measure::LayeredTruth& truth) {
    options.translucency.countsFragments = true;
    render::Renderer renderer(device, setup.scene, gpuScene, options);
    render::Frame frame = renderer.render(setup.path.at(0));
    TranslucencyResult result;
    result.technique = partsOf(options.technique);
    result.cascades = static_cast<unsigned>(frame.cascades.size());
    result.stats = frame.stats.translucency;
    if (result.stats.refusal) {
        result.note = noteOn(*result.stats.refusal, device.info().name, options.width, options.height);
    }
    result.difference = measure::compareLayers(frame.color, frame.fragmentCounts, truth);
    result.picture = std::move(frame.color);
    return result;
}

/// base::RunError unless the device has room for the renderers that are timed in turns, of which each has at least
/// a G-buffer, a depth buffer and a picture.
void requireRoom(const gpu::Device& device, const TranslucencyExperiment& experiment) {
    constexpr std::uint64_t kBytesPerPixel = 16 + 4 + 4;
    const std::size_t timed =
        experiment.repeats > 0 ? experiment.cascades.size() * render::kTranslucencies.size() : 0;
    gpu::requireDeviceBytes(
        device, kBytesPerPixel * experiment.width * experiment.height * (timed + 1),
        fmt::format("timing {}x{} pixels of {} renderers in turns (--repeats 0 times none)", experiment.width,
                    experiment.height, timed));
}

} // namespace

TranslucencyResults runTranslucency(const gpu::Device& device, const scene::SceneSetup& setup,
                                    const TranslucencyExperiment& experiment,
                                    const TranslucencyProgress& progress) {
    if (!visibility::hasBlended(setup.scene)) {
        throw base::InputError(setup.scene.name + ": the scene has no translucent surfaces");
    }
    const scene::Camera camera = setup.path.at(0);
    for (const unsigned cascades : experiment.cascades) {
        splitOf(cascades); // refused before the truth is cast
    }
    requireRoom(device, experiment);
    const render::GpuScene gpuScene(device, setup.scene);
    host::WorkerPool workers(experiment.threads);
    const measure::LayeredTruth truth =
        measure::castLayers(setup.scene, camera, experiment.width, experiment.height, workers);
    TranslucencyResults all{.truth = measure::pictureOf(truth), .results = {}};
    std::vector<std::unique_ptr<render::Renderer>> renderers; // all alive, so that timing takes turns
    const std::size_t pairs = experiment.cascades.size() * render::kTranslucencies.size();
    const std::size_t steps = pairs * (1 + experiment.repeats);
    for (const unsigned cascades : experiment.cascades) {
        for (const render::Translucency method : render::kTranslucencies) {
            progress(all.results.size(), steps);
            const render::RenderOptions options = optionsFor(experiment, cascades, method);
            all.results.push_back(compare(device, setup, gpuScene, options, truth));
            if (!experiment.keepsPictures) {
                all.results.back().picture = {};
            }
            if (experiment.repeats > 0) {
                renderers.push_back(
                    std::make_unique<render::Renderer>(device, setup.scene, gpuScene, options));
                renderers.back()->draw(camera); // lists grow, pipelines warm up
            }
        }
    }
    std::vector<std::vector<double>> executeMs(renderers.size());
    for (std::size_t repeat = 0; repeat < experiment.repeats; ++repeat) {
        for (std::size_t i = 0; i < renderers.size(); ++i) {
            progress(pairs + repeat * pairs + i, steps);
            executeMs[i].push_back(renderers[i]->draw(camera).times.executeMs);
        }
    }
    for (std::size_t i = 0; i < executeMs.size(); ++i) {
        all.results[i].executeMs = measure::median(executeMs[i]);
    }
    return all;
}

image::ImageRgba8 errorPicture(const image::ImageRgba8& picture, const image::ImageRgba8& truth) {
    image::ImageRgba8 error(truth.width, truth.height, {0, 0, 0, 255});
    for (std::size_t i = 0; i < error.pixels.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            const int difference = std::abs(int{picture.pixels[i][c]} - int{truth.pixels[i][c]});
            error.pixels[i][c] = static_cast<std::uint8_t>(std::min(8 * difference, 255));
        }
    }
    return error;
}

} // namespace cdr::experiments
