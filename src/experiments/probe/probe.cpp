#include "probe.h"

#include "resolved.h"

#include <cdr/depth/forecast.h>
#include <cdr/measure/truth/truth.h>
#include <cdr/render/renderer.h>
#include <cdr/scene/frustum.h>
#include <experiments/rivals/drawer.h>
#include <scenes/ladder.h>

#include <fmt/format.h>
#include <runs/units.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace cdr::experiments {

namespace {

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

/// @param snapBits 0: vertices are not rounded.
depth::ForecastScene forecastScene(const scene::SceneSetup& setup, const scenes::LadderOptions& ladder,
                                   std::uint32_t height, std::uint32_t snapBits) {
    const scene::Camera camera = setup.path.at(0);
    return {.nearView = ladder.nearView,
            .farView = ladder.farView,
            .footprintSlope = scene::frustumOf(camera, 1.0, height).footprintSlope,
            .atView = ladder.distanceView,
            .spanView = spanOf(setup),
            .somethingNear = false,
            .subPixelBits = snapBits > 0 ? std::optional<unsigned>(snapBits) : std::nullopt};
}

/// depth::forecast() knows no rival.
constexpr double kNotForecast = std::numeric_limits<double>::quiet_NaN();

/// What a picture comes to.
struct Probed {
    Resolved resolved;
    double predictedView = 0.0;
    double guaranteedView = 0.0;
    std::size_t cascades = 0;
};

class Prober {
  public:
    Prober(const gpu::Device& device, const ProbeOptions& options)
        : m_device(device),
          m_options(options),
          m_workers(options.drawing.threads) {
        if (m_options.formats.empty()) {
            m_options.formats = device.info().depthFormats;
        }
        for (const rivals::NamedRival& named : m_options.rivalsBeside) {
            rivals::requireFeatures(device.info(), named.rival);
        }
    }

    /// Pictures of a distance.
    std::size_t pictures() const {
        return m_options.techniques.size() * m_options.formats.size() + m_options.rivalsBeside.size();
    }

    /// Every technique in every format, then every rival, in their order.
    std::vector<Probed>
    probe(double distanceView,
          const std::function<void(std::size_t done, const std::string& name)>& progress) {
        const scenes::LadderOptions ladder = probeLadder(distanceView, m_options.nearView, m_options.farView);
        const scene::SceneSetup setup = scenes::makeLadder(m_options.seed, ladder);
        const scene::Camera camera = setup.path.at(0);
        const render::GpuScene gpuScene(m_device, setup.scene);
        render::RenderOptions drawing = m_options.drawing;
        const measure::TruthImage truth =
            measure::castTruth(setup.scene, camera, drawing.width, drawing.height, m_workers);
        const auto measured = [&](Drawer& drawer, double predictedView, double guaranteedView) -> Probed {
            const DrawnFrame frame = drawer.render(camera);
            return {.resolved = resolvedIn(frame.ids, truth, ladder),
                    .predictedView = predictedView,
                    .guaranteedView = guaranteedView,
                    .cascades = frame.cascades};
        };
        std::vector<Probed> all;
        for (auto [name, technique] : m_options.techniques) {
            for (const depth::DepthFormat format : m_options.formats) {
                technique.format = format;
                progress(all.size(), name);
                drawing.technique = technique;
                Drawer drawer(std::make_unique<render::Renderer>(m_device, setup.scene, gpuScene, drawing));
                const auto forecast = depth::forecast(
                    technique, forecastScene(setup, ladder, drawing.height, drawing.snapBits));
                all.push_back(measured(drawer, forecast.resolvedView(), forecast.guaranteedView()));
            }
        }
        for (const rivals::NamedRival& named : m_options.rivalsBeside) {
            progress(all.size(), named.name);
            Drawer drawer(m_device, gpuScene, named.rival, {drawing.width, drawing.height}, m_workers);
            all.push_back(measured(drawer, kNotForecast, kNotForecast));
        }
        return all;
    }

    /// Their rows.
    void addRows(double distanceView, const std::vector<Probed>& all,
                 std::vector<ProbeResult>& results) const {
        const scenes::LadderOptions ladder = probeLadder(distanceView, m_options.nearView, m_options.farView);
        auto probed = all.begin();
        const auto add = [&](const std::string& name, std::optional<depth::DepthFormat> format) {
            ProbeResult& row = results.emplace_back();
            row.technique = name;
            row.format = format;
            row.distanceView = distanceView;
            row.resolvedView = probed->resolved.view;
            row.resolvesAll = probed->resolved.all;
            row.pairsSeen = probed->resolved.pairsSeen;
            row.predictedView = probed->predictedView;
            row.guaranteedView = probed->guaranteedView;
            row.smallestView = scenes::ladderSeparation(ladder, 0);
            row.largestView = scenes::ladderSeparation(ladder, scenes::kLadderPairs - 1);
            row.cascades = probed->cascades;
            ++probed;
        };
        for (const auto& [name, technique] : m_options.techniques) {
            for (const depth::DepthFormat format : m_options.formats) {
                add(name, format);
            }
        }
        for (const rivals::NamedRival& named : m_options.rivalsBeside) {
            add(named.name, std::nullopt);
        }
    }

  private:
    const gpu::Device& m_device;
    ProbeOptions m_options; ///< with what was left to the device
    platform::WorkerPool m_workers;
};

} // namespace

std::vector<ProbeResult> runProbe(const gpu::Device& device, const ProbeOptions& options,
                                  const NamedProgress& progress, ranks::Ranks& ranks) {
    const std::vector<double>& distances = options.distancesView;
    for (const double distanceView : distances) {
        probeLadder(distanceView, options.nearView,
                    options.farView); // an unusable one ends here, before any work
    }
    Prober prober(device, options);
    const auto make = [&](std::size_t unit) {
        const auto step = [&](std::size_t done, const std::string& name) {
            progress(unit * prober.pictures() + done, distances.size() * prober.pictures(),
                     fmt::format("{} at {}", name, distances[unit]));
        };
        return runs::packed(prober.probe(distances[unit], step));
    };
    std::vector<ProbeResult> results;
    runs::forEachUnit(ranks, distances.size(), make, [&](std::size_t unit, const output::Json& made) {
        prober.addRows(distances[unit], runs::unpacked<Probed>(made, prober.pictures()), results);
    });
    return results;
}

} // namespace cdr::experiments
