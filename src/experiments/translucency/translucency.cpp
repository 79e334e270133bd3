#include "translucency.h"

#include <cdr/base/error.h>
#include <cdr/gpu/memory.h>
#include <cdr/render/renderer.h>
#include <cdr/visibility/blended.h>

#include <fmt/format.h>
#include <output/frame_notes.h>
#include <runs/interleaved_frames.h>
#include <runs/units.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

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
            .translucency = {.method = method, .maxBytes = experiment.maxBytes}};
}

/// The numbers of a result.
struct Compared {
    unsigned cascades = 1;
    render::TranslucencyStats stats;
    measure::LayerDifference difference;
};

/// One frame of one method, compared with the truth.
TranslucencyResult compare(const gpu::Device& device, const scene::SceneSetup& setup,
                           const render::GpuScene& gpuScene, render::RenderOptions options,
                           const measure::LayeredTruth& truth) {
    options.translucency.countsFragments = true;
    render::Renderer renderer(device, setup.scene, gpuScene, options);
    render::Frame frame = renderer.render(setup.path.at(0));
    TranslucencyResult result;
    result.cascades = static_cast<unsigned>(frame.cascades.size());
    result.stats = frame.stats.translucency;
    if (result.stats.refusal) {
        result.note =
            output::noteOn(*result.stats.refusal, device.info().name, options.width, options.height);
    }
    result.difference = measure::compareLayers(frame.color, frame.fragmentCounts, truth);
    result.picture = std::move(frame.color);
    return result;
}

/// base::RunError unless the device has room for the renderers that are timed in turns. Each has at least a
/// G-buffer, a depth buffer and a picture.
void requireRoom(const gpu::Device& device, const TranslucencyExperiment& experiment) {
    constexpr std::uint64_t kBytesPerPixel = 16 + 4 + 4;
    const std::size_t timed =
        experiment.repeats > 0 ? experiment.cascades.size() * render::kTranslucencies.size() : 0;
    gpu::requireDeviceBytes(
        device, kBytesPerPixel * experiment.width * experiment.height * (timed + 1),
        fmt::format("timing {}x{} pixels of {} renderers in turns (--repeats 0 times none)", experiment.width,
                    experiment.height, timed));
}

/// Every number of cascades by every method.
std::vector<render::RenderOptions> pairsOf(const TranslucencyExperiment& experiment) {
    std::vector<render::RenderOptions> pairs;
    for (const unsigned cascades : experiment.cascades) {
        for (const render::Translucency method : render::kTranslucencies) {
            pairs.push_back(optionsFor(experiment, cascades, method));
        }
    }
    return pairs;
}

/// For the first rank. The technique is known there.
output::Json packedResult(const TranslucencyResult& result, const TranslucencyExperiment& experiment) {
    const std::vector<Compared> compared{
        {.cascades = result.cascades, .stats = result.stats, .difference = result.difference}};
    output::Json made{{"compared", runs::packed(compared)}, {"note", result.note}};
    if (experiment.keepsPictures) {
        made["picture"] = runs::packedPicture(result.picture);
    }
    return made;
}

/// std::out_of_range for what is no result of such an experiment.
TranslucencyResult unpackedResult(const output::Json& made, const TranslucencyExperiment& experiment) {
    const Compared compared = runs::unpacked<Compared>(made.at("compared"), 1)[0];
    TranslucencyResult result;
    result.cascades = compared.cascades;
    result.stats = compared.stats;
    result.note = made.at("note").get<std::string>();
    result.difference = compared.difference;
    if (experiment.keepsPictures) {
        result.picture = runs::unpackedPicture(made.at("picture"));
    }
    const image::ImageRgba8& picture = result.picture;
    if (std::ranges::count(render::kTranslucencies, result.stats.method) == 0 ||
        (experiment.keepsPictures &&
         (picture.width != experiment.width || picture.height != experiment.height))) {
        throw std::out_of_range("another method or size");
    }
    return result;
}

/// The median time of each, in milliseconds; all are alive, so that they take turns.
std::vector<double> timeInTurns(const gpu::Device& device, const scene::SceneSetup& setup,
                                const render::GpuScene& gpuScene,
                                const std::vector<render::RenderOptions>& pairs,
                                const TranslucencyExperiment& experiment, const std::function<void()>& step) {
    const scene::Camera camera = setup.path.at(0);
    std::vector<std::unique_ptr<render::Renderer>> renderers;
    for (const render::RenderOptions& options : pairs) {
        renderers.push_back(std::make_unique<render::Renderer>(device, setup.scene, gpuScene, options));
    }
    runs::InterleavedFrames frames(pairs.size(), experiment.seed);
    frames.runAlone(static_cast<std::uint32_t>(experiment.repeats), step,
                    [&](std::size_t pair, std::uint32_t) { return renderers[pair]->draw(camera); });
    std::vector<double> medians;
    for (std::size_t pair = 0; pair < pairs.size(); ++pair) {
        medians.push_back(frames.median(pair, &runs::FrameSample::executeMs));
    }
    return medians;
}

} // namespace

TranslucencyResults runTranslucency(const gpu::Device& device, const scene::SceneSetup& setup,
                                    const TranslucencyExperiment& given, const Progress& progress,
                                    ranks::Ranks& ranks) {
    if (!visibility::hasBlended(setup.scene)) {
        throw base::InputError(setup.scene.name + ": the scene has no translucent surfaces");
    }
    TranslucencyExperiment experiment = given;
    if (!ranks.isFirst()) {
        experiment.repeats = 0; // the first one times, while the others wait for its end
    }
    const std::vector<render::RenderOptions> pairs = pairsOf(experiment); // refused before the truth is cast
    requireRoom(device, experiment);
    const render::GpuScene gpuScene(device, setup.scene);
    platform::WorkerPool workers(experiment.threads);
    const measure::LayeredTruth truth =
        measure::castLayers(setup.scene, setup.path.at(0), experiment.width, experiment.height, workers);
    TranslucencyResults all{.truth = measure::pictureOf(truth), .results = {}};
    const std::size_t turns =
        experiment.repeats > 0 ? runs::InterleavedFrames::kWarmUp + experiment.repeats : 0;
    const std::size_t steps = pairs.size() * (1 + turns);
    runs::forEachUnit(
        ranks, pairs.size(),
        [&](std::size_t unit) {
            progress(unit, steps);
            return packedResult(compare(device, setup, gpuScene, pairs[unit], truth), experiment);
        },
        [&](std::size_t unit, const output::Json& made) {
            all.results.push_back(unpackedResult(made, experiment));
            all.results.back().technique = partsOf(pairs[unit].technique);
        });
    if (experiment.repeats > 0) {
        runs::forEachUnit(
            ranks, 1,
            [&](std::size_t) {
                std::size_t done = 0;
                return runs::packed(timeInTurns(device, setup, gpuScene, pairs, experiment,
                                                [&] { progress(done += pairs.size(), steps); }));
            },
            [&](std::size_t, const output::Json& made) {
                const auto medians = runs::unpacked<double>(made, pairs.size());
                for (std::size_t i = 0; i < pairs.size(); ++i) {
                    all.results[i].executeMs = medians[i];
                }
            },
            &ranks::Ranks::forEachUnitOnFirst);
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
