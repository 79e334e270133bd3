#include "effects.h"

#include <cdr/base/error.h>
#include <cdr/render/renderer.h>
#include <experiments/interleaved_frames.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <memory>

namespace cdr::experiments {

namespace {

constexpr std::array kEffectModes{"plain", "edges", "occlusion", "occlusion-layers", "fog"};
constexpr std::size_t kWhole = 2;
constexpr std::size_t kPerLayer = 3;

/// Twelve cascades, so that boundaries run through what is near.
depth::Technique shownTechnique() {
    return depth::Technique{depth::Mapping::anchored, depth::SplitCount{12}, depth::DepthFormat::d32f};
}

render::Effects effectsOf(std::size_t mode, const EffectsOptions& options) {
    const std::string name = kEffectModes[mode];
    render::Effects effects;
    if (name == "edges") {
        effects.antialias = render::Antialias::edges;
    } else if (mode == kWhole || mode == kPerLayer) {
        effects.occlusion = {.radius = options.occlusionRadius, .perLayer = mode == kPerLayer};
    } else if (name == "fog") {
        effects.fog.visibility = options.visibility;
    }
    return effects;
}

/// Which pixels are apart: all that differ, or those that are brighter in the first picture.
enum class Apart : std::uint8_t { either, brighter };

/// By how much one pixel's channels differ at most.
int apart(const image::Rgba8& a, const image::Rgba8& b, Apart which) {
    int most = 0;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const int difference = int{a[channel]} - int{b[channel]};
        most = std::max(most, which == Apart::brighter ? difference : std::abs(difference));
    }
    return most;
}

double shareApart(const image::ImageRgba8& a, const image::ImageRgba8& b, Apart which) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        count += apart(a.pixels[i], b.pixels[i], which) > kEffectTolerance ? 1 : 0;
    }
    return static_cast<double>(count) / static_cast<double>(a.pixels.size());
}

/// A renderer per mode over one scene, and what each took so far.
class EffectsComparison {
  public:
    EffectsComparison(const gpu::Device& device, const scene::SceneSetup& setup,
                      const EffectsOptions& options)
        : m_device(device),
          m_options(options),
          m_setup(setup),
          m_camera(m_setup.path.at(0)),
          m_gpuScene(device, m_setup.scene),
          m_frames(kEffectModes.size(), options.seed) {
        for (std::size_t mode = 0; mode < kEffectModes.size(); ++mode) {
            m_renderers.push_back(makeRenderer(mode, shownTechnique()));
        }
    }

    void time(TimedRanks& ranks, const std::function<void()>& step) {
        m_frames.run(ranks, m_options.frames, step,
                     [&](std::size_t mode, std::uint32_t) { return m_renderers[mode]->draw(m_camera); });
    }

    EffectsResult summarise(std::size_t mode) {
        const std::vector<double> ratios = m_frames.ratios(mode, 0, &FrameSample::executeMs);
        EffectsResult result{.mode = kEffectModes[mode],
                             .executeMs = m_frames.median(mode, &FrameSample::executeMs),
                             .ratio = measure::median(ratios),
                             .ratio95 = measure::bootstrapMedian(ratios, m_options.seed + mode),
                             .leastAlike = {},
                             .picture = m_renderers[mode]->render(m_camera).color};
        for (const auto& [name, technique] : depth::presets()) {
            const double share = shareApart(makeRenderer(mode, technique)->render(m_camera).color,
                                            result.picture, Apart::either);
            if (result.leastAlike.empty() || share > result.differing) {
                result.leastAlike = name;
                result.differing = share;
            }
        }
        return result;
    }

  private:
    std::unique_ptr<render::Renderer> makeRenderer(std::size_t mode,
                                                   const depth::Technique& technique) const {
        const render::RenderOptions options{.width = m_options.width,
                                            .height = m_options.height,
                                            .technique = technique,
                                            .targets = mode == kPerLayer ? render::TargetsKind::accumulate
                                                                         : render::TargetsKind::single,
                                            .threads = m_options.threads,
                                            .effects = effectsOf(mode, m_options)};
        return std::make_unique<render::Renderer>(m_device, m_setup.scene, m_gpuScene, options);
    }

    const gpu::Device& m_device;
    const EffectsOptions& m_options;
    const scene::SceneSetup& m_setup;
    scene::Camera m_camera;
    render::GpuScene m_gpuScene;
    std::vector<std::unique_ptr<render::Renderer>> m_renderers; ///< by mode
    InterleavedFrames m_frames;
};

} // namespace

EffectsReport runEffects(const gpu::Device& device, const scene::SceneSetup& setup,
                         const EffectsOptions& options, const EffectsProgress& progress, TimedRanks& ranks) {
    if (options.frames < 1) {
        throw base::InputError("effects needs a frame");
    }
    const std::size_t all = std::size_t{InterleavedFrames::kWarmUp} + options.frames + kEffectModes.size();
    std::size_t done = 0;
    EffectsComparison comparison(device, setup, options);
    comparison.time(ranks, [&] { progress(done++, all); });
    if (!ranks.isFirst()) {
        return {};
    }
    EffectsReport report;
    for (std::size_t mode = 0; mode < kEffectModes.size(); ++mode) {
        progress(done++, all);
        report.results.push_back(comparison.summarise(mode));
    }
    report.lostPerLayer =
        shareApart(report.results[kPerLayer].picture, report.results[kWhole].picture, Apart::brighter);
    return report;
}

} // namespace cdr::experiments
