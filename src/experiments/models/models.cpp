#include "models.h"

#include <cdr/measure/compare/flip_difference.h>
#include <cdr/measure/truth/layered_truth.h>
#include <cdr/platform/worker_pool.h>
#include <cdr/render/renderer.h>
#include <cdr/scene/frustum.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace cdr::experiments {

namespace {

/// What is left of a scene whose materials have base colour and the factors of metallic and roughness alone.
scene::Scene withoutDetail(scene::Scene scene) {
    for (scene::Material& material : scene.materials) {
        material.detail = {};
    }
    return scene;
}

render::Frame drawn(const gpu::Device& device, const scene::Scene& scene, const scene::Camera& camera,
                    const ModelsOptions& options) {
    const render::GpuScene onDevice(device, scene);
    render::RenderOptions chosen = options.drawing;
    chosen.translucency.method = render::Translucency::sorted;
    chosen.translucency.countsFragments = true;
    render::Renderer renderer(device, scene, onDevice, chosen);
    return renderer.render(camera);
}

/// Whether a pixel shows a surface, opaque or blended.
bool isCovered(const render::Frame& frame, std::size_t pixel) {
    const auto x = static_cast<std::uint32_t>(pixel % frame.width());
    const auto y = static_cast<std::uint32_t>(pixel / frame.width());
    const bool isAnyBlended = !frame.fragmentCounts.pixels.empty();
    return frame.id(x, y) != 0 || (isAnyBlended && frame.fragmentCounts.at(x, y) != 0);
}

/// Of a picture's half height and half width: by how much a view may be narrowed that shows these pixels.
double shareShown(const render::Frame& frame) {
    double share = 0.0;
    for (std::uint32_t y = 0; y < frame.height(); ++y) {
        for (std::uint32_t x = 0; x < frame.width(); ++x) {
            if (isCovered(frame, std::size_t{y} * frame.width() + x)) {
                share = std::max({share, std::abs(2.0 * (x + 0.5) / frame.width() - 1.0),
                                  std::abs(2.0 * (y + 0.5) / frame.height() - 1.0)});
            }
        }
    }
    return share;
}

/// The camera with a lens that a model fills, where it does not.
scene::Camera closer(const gpu::Device& device, const scene::SceneSetup& model,
                     const ModelsOptions& options) {
    constexpr double kMargin = 1.06;
    scene::Camera camera = model.path.at(0);
    const double share = shareShown(drawn(device, model.scene, camera, options));
    if (share > 0.0 && kMargin * share < 1.0) {
        camera.fovY = 2.0 * std::atan(scene::frustumOf(camera, 1.0, 1.0).tanY * kMargin * share);
    }
    return camera;
}

std::uint64_t trianglesOf(const scene::Scene& scene) {
    std::uint64_t triangles = 0;
    for (const std::uint32_t mesh : scene.instances.mesh) {
        triangles += scene.meshes[mesh].indices.size() / 3;
    }
    return triangles;
}

/// Black, red, yellow, white.
image::Rgba8 heatOf(float value) {
    const auto channel = [&](float from) {
        return static_cast<std::uint8_t>(std::lround(255.0f * std::clamp(3.0f * value - from, 0.0f, 1.0f)));
    };
    return {channel(0.0f), channel(1.0f), channel(2.0f), 255};
}

void measureFlip(ModelResult& result, const render::Frame& frame, platform::WorkerPool& workers) {
    const image::ImageFloat map = measure::FlipDifference().map(result.reference, result.picture, workers);
    double sum = 0.0;
    double covered = 0.0;
    std::size_t count = 0;
    result.difference = image::ImageRgba8(map.width, map.height);
    for (std::size_t i = 0; i < map.pixels.size(); ++i) {
        const bool counts = isCovered(frame, i);
        sum += map.pixels[i];
        covered += counts ? map.pixels[i] : 0.0f;
        count += counts ? 1 : 0;
        result.difference.pixels[i] = heatOf(map.pixels[i]);
    }
    const auto all = static_cast<double>(map.pixels.size());
    result.flip = sum / all;
    result.coveredFraction = static_cast<double>(count) / all;
    if (count > 0) {
        result.coveredFlip = covered / static_cast<double>(count);
    }
}

std::optional<double> meanSteps(const ModelResult& result, const measure::LayeredTruth& truth,
                                const render::Frame& frame) {
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
        const bool counts = truth.pixels[i].isInner && isCovered(frame, i);
        if (!counts) {
            continue;
        }
        int largest = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            largest = std::max(
                largest, std::abs(int{result.picture.pixels[i][c]} - int{result.reference.pixels[i][c]}));
        }
        sum += largest;
        ++count;
    }
    return count > 0 ? std::optional(sum / static_cast<double>(count)) : std::nullopt;
}

} // namespace

ModelResult compareModel(const gpu::Device& device, const scene::SceneSetup& model,
                         const scene::SceneSetup& plain, scene::ModelLight light,
                         const ModelsOptions& options) {
    const scene::Camera camera = options.closer ? closer(device, model, options) : model.path.at(0);
    platform::WorkerPool workers(options.drawing.threads);
    const render::Frame frame = drawn(device, model.scene, camera, options);
    const measure::LayeredTruth truth =
        measure::castLayers(model.scene, camera, options.drawing.width, options.drawing.height, workers);
    ModelResult result{.model = model.scene.name,
                       .light = std::string(nameOf(light)),
                       .triangles = trianglesOf(model.scene),
                       .textures = model.scene.textures.size()};
    result.plain = drawn(device, withoutDetail(plain.scene), camera, options).color;
    result.picture = frame.color;
    result.reference = pictureOf(truth, {.exposure = 0.0, .neutral = model.scene.sky.has_value()});
    measureFlip(result, frame, workers);
    result.meanSteps = meanSteps(result, truth, frame);
    return result;
}

} // namespace cdr::experiments
