#include "probe.h"

#include <cdr/base/error.h>
#include <cdr/depth/forecast.h>
#include <cdr/measure/compare/wrong_pixels.h>
#include <cdr/measure/truth/truth.h>
#include <cdr/render/renderer.h>
#include <cdr/scene/frustum.h>
#include <scenes/ladder.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace cdr::experiments {

namespace {

/// The ladder as it stands at one distance.
scenes::LadderOptions ladderAt(double distanceView, const ProbeOptions& options) {
    if (!std::isfinite(distanceView) || distanceView < 0.1) {
        throw base::InputError(
            fmt::format("a probe's distance must be finite and at least 0.1, not {}", distanceView));
    }
    return {.distanceView = distanceView,
            .nearView = options.nearView.value_or(0.001),
            .farView = std::max(options.farView.value_or(2.0 * distanceView), 1.02 * distanceView),
            .scale = std::min(1.0, distanceView / 1000.0)};
}

std::uint32_t pairOf(std::uint32_t id) {
    return (id - 1) / 2;
}

/// Which pixels tell whether a pair is resolved: off silhouettes, the pair's second surface behind the first,
/// and not so close behind that the two are sides in one plane.
bool tells(const measure::TruthPixel& pixel, bool inner, const scenes::LadderOptions& ladder) {
    if (!inner || pixel.secondId == 0 || pairOf(pixel.id) != pairOf(pixel.secondId)) {
        return false;
    }
    const double separation = scenes::ladderSeparation(ladder, pairOf(pixel.id));
    return pixel.gapView() >= 0.5 * separation;
}

/// The smallest separation that is resolved. Of surfaces a depth buffer cannot tell apart the one drawn last
/// shows, so a pair whose front is drawn last comes out right by luck: it can fail the test but not pass it.
std::optional<double> smallestResolved(const image::ImageU32& ids, const measure::TruthImage& truth,
                                       const scenes::LadderOptions& ladder) {
    const auto inner = measure::innerMask(truth);
    std::array<bool, scenes::kLadderPairs> lucky;
    lucky.fill(true); // nor does a pair that no pixel tells of pass
    std::array<bool, scenes::kLadderPairs> wrong{};
    for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
        const measure::TruthPixel& pixel = truth.pixels[i];
        if (tells(pixel, inner.pixels[i] != 0, ladder)) {
            lucky[pairOf(pixel.id)] = pixel.id > pixel.secondId;
            wrong[pairOf(pixel.id)] |= ids.pixels[i] != pixel.id;
        }
    }
    std::optional<double> resolved;
    for (std::uint32_t pair = scenes::kLadderPairs; pair-- > 0 && !wrong[pair];) {
        if (!lucky[pair]) {
            resolved = scenes::ladderSeparation(ladder, pair);
        }
    }
    return resolved;
}

/// Depth of the ladder along the view: cubes on a turned 30 by 30 grid.
double spanOf(const scene::SceneSetup& setup) {
    const scene::Camera camera = setup.path.at(0);
    double nearest = INFINITY;
    double farthest = 0.0;
    for (std::size_t i = 0; i < setup.scene.instances.size(); ++i) {
        const double w = camera.viewDistance(setup.scene.instances.position(i));
        const auto radius = static_cast<double>(setup.scene.instances.radius[i]);
        nearest = std::min(nearest, w - radius);
        farthest = std::max(farthest, w + radius);
    }
    return farthest - nearest;
}

depth::ForecastScene forecastScene(const scene::SceneSetup& setup, const scenes::LadderOptions& ladder,
                                   std::uint32_t height) {
    const scene::Camera camera = setup.path.at(0);
    return {.nearView = ladder.nearView,
            .farView = ladder.farView,
            .footprintSlope = scene::frustumOf(camera, 1.0, height).footprintSlope,
            .atView = ladder.distanceView,
            .spanView = spanOf(setup),
            .somethingNear = false};
}

} // namespace

std::vector<ProbeResult> runProbe(const gpu::Device& device, const ProbeOptions& options,
                                  const ProbeProgress& progress) {
    const std::vector<depth::NamedTechnique> techniques =
        options.techniques.empty() ? std::vector(depth::presets().begin(), depth::presets().end())
                                   : options.techniques;
    for (const double distanceView : options.distancesView) {
        ladderAt(distanceView, options); // an unusable one ends here, before any work
    }
    const std::vector<depth::DepthFormat>& formats =
        options.formats.empty() ? device.info().depthFormats : options.formats;
    host::WorkerPool workers(options.threads);
    const std::size_t all = options.distancesView.size() * techniques.size() * formats.size();
    std::vector<ProbeResult> results;
    for (const double distanceView : options.distancesView) {
        const scenes::LadderOptions ladder = ladderAt(distanceView, options);
        const scene::SceneSetup setup = scenes::makeLadder(options.seed, ladder);
        const scene::Camera camera = setup.path.at(0);
        const render::GpuScene gpuScene(device, setup.scene);
        const measure::TruthImage truth =
            measure::castTruth(setup.scene, camera, options.width, options.height, workers);
        for (auto [name, technique] : techniques) {
            for (const depth::DepthFormat format : formats) {
                technique.format = format;
                progress(results.size(), all, fmt::format("{} at {}", name, distanceView));
                render::Renderer renderer(device, setup.scene, gpuScene,
                                          {.width = options.width,
                                           .height = options.height,
                                           .technique = technique,
                                           .threads = options.threads});
                const render::Frame frame = renderer.render(camera);
                const auto forecast =
                    depth::forecast(technique, forecastScene(setup, ladder, options.height));
                results.push_back({.technique = name,
                                   .format = std::string(nameOf(format)),
                                   .distanceView = distanceView,
                                   .resolvedView = smallestResolved(frame.ids(), truth, ladder),
                                   .predictedView = forecast.resolvedView(),
                                   .guaranteedView = forecast.guaranteedView(),
                                   .smallestView = scenes::ladderSeparation(ladder, 0),
                                   .largestView = scenes::ladderSeparation(ladder, scenes::kLadderPairs - 1),
                                   .cascades = frame.cascades.size()});
            }
        }
    }
    return results;
}

} // namespace cdr::experiments
