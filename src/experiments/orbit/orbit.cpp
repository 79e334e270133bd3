#include "orbit.h"

#include <cdr/measure/truth/truth.h>
#include <cdr/render/renderer.h>

#include <memory>
#include <numbers>

namespace cdr::experiments {

namespace {

PictureResult pictureOf(const OrbitResult& result, const render::Frame& frame,
                        const measure::TruthImage& truth) {
    PictureResult picture;
    picture.scene = "orbit";
    picture.technique = result.technique;
    picture.fovYDegrees = result.fovYDegrees;
    picture.frames = 1;
    picture.wrong = result.wrong;
    picture.picture = frame.color;
    picture.heatMap = measure::heatMap(frame.ids(), truth, frame.color);
    return picture;
}

} // namespace

std::vector<std::uint32_t> zoomFrames(std::uint32_t length, std::uint32_t count) {
    count = std::min(count, length);
    std::vector<std::uint32_t> frames;
    for (std::uint32_t i = 1; i < count; ++i) {
        frames.push_back(static_cast<std::uint32_t>(std::uint64_t{i - 1} * (length - 1) / (count - 1)));
    }
    if (count > 0) {
        frames.push_back(length - 1);
    }
    return frames;
}

OrbitRun runOrbit(const gpu::Device& device, const scene::SceneSetup& setup, const OrbitOptions& given,
                  const Progress& progress) {
    OrbitOptions options = given;
    if (options.techniques.empty()) {
        options.techniques.assign(depth::presets().begin(), depth::presets().end());
    }
    const render::GpuScene gpuScene(device, setup.scene);
    host::WorkerPool workers(options.threads);
    const measure::TruthCaster caster(setup.scene, workers);
    std::vector<std::unique_ptr<render::Renderer>> renderers;
    for (const auto& [name, technique] : options.techniques) {
        renderers.push_back(
            std::make_unique<render::Renderer>(device, setup.scene, gpuScene,
                                               render::RenderOptions{.width = options.width,
                                                                     .height = options.height,
                                                                     .technique = technique,
                                                                     .threads = options.threads}));
    }
    const std::vector<std::uint32_t> numbers = zoomFrames(setup.path.frames, options.frames);
    const std::size_t all = numbers.size() * renderers.size();
    OrbitRun run;
    for (const std::uint32_t number : numbers) {
        const scene::Camera camera = setup.path.at(number);
        const measure::TruthImage truth = caster.cast(camera, options.width, options.height, workers);
        const image::Raster<std::uint8_t> inner = measure::innerMask(truth);
        for (std::size_t i = 0; i < renderers.size(); ++i) {
            const std::string& name = options.techniques[i].name;
            progress(run.results.size(), all, name);
            const render::Frame frame = renderers[i]->render(camera);
            if (number == numbers.front()) {
                run.window = frame.color;
            }
            run.results.push_back({.frame = number,
                                   .fovYDegrees = camera.fovY * 180.0 / std::numbers::pi,
                                   .technique = name,
                                   .cascades = frame.cascades.size(),
                                   .wrong = measure::countWrong(frame.ids(), truth, inner)});
            if (number == numbers.back()) {
                run.last.push_back(pictureOf(run.results.back(), frame, truth));
            }
        }
    }
    return run;
}

} // namespace cdr::experiments
