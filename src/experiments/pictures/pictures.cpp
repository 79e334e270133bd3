#include "pictures.h"

#include <cdr/measure/compare/flips.h>
#include <cdr/render/renderer.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <numbers>
#include <utility>

namespace cdr::experiments {

namespace {

/// Adds one frame of one technique to its result.
/// @param before what it showed in the frame before, in place of which the ids of this one are kept.
void addFrame(const render::Frame& frame, const measure::SceneTruth& scene, image::ImageU32& before,
              PictureResult& result) {
    const measure::TruthImage& truth = scene.truth;
    image::ImageU32 ids = frame.ids();
    result.wrong += measure::countWrong(ids, truth);
    if (result.frames == 0) {
        result.picture = frame.color;
        result.heatMap = measure::heatMap(ids, truth, frame.color);
    }
    if (scene.steady) {
        result.flips += measure::countFlips(before, ids, *scene.steady).flips;
    }
    before = std::move(ids);
    ++result.frames;
}

/// A scene may have fewer frames than are asked for.
std::uint32_t framesOf(const scene::SceneSetup& setup, const PicturesOptions& options) {
    return std::min(options.frames, setup.path.frames);
}

/// All techniques over one scene; they share the truth of each frame.
std::vector<PictureResult> runScene(const gpu::Device& device, const PicturesOptions& options,
                                    const scene::SceneSetup& setup,
                                    const std::function<void(const std::string&)>& step) {
    const render::GpuScene gpuScene(device, setup.scene);
    render::RenderOptions drawing = options.drawing;
    platform::WorkerPool workers(drawing.threads);
    std::vector<std::unique_ptr<render::Renderer>> renderers;
    std::vector<PictureResult> results;
    std::vector<image::ImageU32> before(options.techniques.size());
    measure::SceneTruth truth;
    for (const auto& [name, technique] : options.techniques) {
        drawing.technique = technique;
        renderers.push_back(std::make_unique<render::Renderer>(device, setup.scene, gpuScene, drawing));
        PictureResult result;
        result.scene = setup.scene.name;
        result.technique = name;
        result.fovYDegrees = setup.path.at(0).fovY * 180.0 / std::numbers::pi;
        results.push_back(std::move(result));
    }
    const std::uint32_t frames = framesOf(setup, options);
    for (std::uint32_t i = 0; i < frames; ++i) {
        const auto number = static_cast<std::uint32_t>(std::uint64_t{i} * setup.path.frames / frames);
        const scene::Camera camera = setup.path.at(number);
        truth.add(measure::castTruth(setup.scene, camera, drawing.width, drawing.height, workers));
        for (std::size_t t = 0; t < renderers.size(); ++t) {
            step(results[t].scene + " " + results[t].technique);
            addFrame(renderers[t]->render(camera), truth, before[t], results[t]);
        }
    }
    return results;
}

} // namespace

std::vector<PictureResult> runPictures(const gpu::Device& device, std::vector<scene::SceneSetup> scenes,
                                       const PicturesOptions& options, const NamedProgress& progress) {
    std::size_t all = 0;
    for (const scene::SceneSetup& scene : scenes) {
        all += options.techniques.size() * framesOf(scene, options);
    }
    std::size_t done = 0;
    std::vector<PictureResult> results;
    for (scene::SceneSetup& scene : scenes) {
        const scene::SceneSetup own = std::move(scene); // its memory goes before the next scene's turn
        auto part =
            runScene(device, options, own, [&](const std::string& what) { progress(done++, all, what); });
        std::move(part.begin(), part.end(), std::back_inserter(results));
    }
    return results;
}

} // namespace cdr::experiments
