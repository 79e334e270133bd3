#include "effects.h"

#include <cdr/base/enum_names.h>
#include <cdr/base/error.h>
#include <cdr/render/renderer.h>

#include <runs/interleaved_frames.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <optional>
#include <span>

namespace cdr::experiments {

namespace {

constexpr base::EnumNames<EffectMode, kEffectModes.size()> kEffectModeNames{
    "effect", {"plain", "edges", "occlusion", "occlusion-layers", "fog"}};

std::size_t indexOf(EffectMode mode) {
    return static_cast<std::size_t>(mode);
}

/// Twelve cascades, so that boundaries run through what is near.
depth::Technique shownTechnique() {
    return depth::Technique{depth::Mapping::anchored, depth::SplitCount{12}, depth::DepthFormat::d32f};
}

render::Effects effectsOf(EffectMode mode, const EffectsOptions& options) {
    switch (mode) {
    case EffectMode::edges:
        return {.antialias = render::Antialias::edges};
    case EffectMode::occlusion:
        return {.occlusion = {.radius = options.occlusionRadius}};
    case EffectMode::occlusionLayers:
        return {.occlusion = {.radius = options.occlusionRadius, .perLayer = true}};
    case EffectMode::fog:
        return {.fog = {.visibility = options.visibility}};
    case EffectMode::plain:
        break;
    }
    return {};
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
        for (const EffectMode mode : kEffectModes) {
            m_renderers.push_back(makeRenderer(mode, shownTechnique()));
        }
    }

    void time(runs::TimedRanks& ranks, const std::function<void()>& step) {
        m_frames.run(ranks, m_options.frames, step,
                     [&](std::size_t mode, std::uint32_t) { return m_renderers[mode]->draw(m_camera); });
    }

    EffectsResult summarise(EffectMode effect) {
        const std::size_t mode = indexOf(effect);
        const std::vector<double> ratios = m_frames.ratios(mode, 0, &runs::FrameSample::executeMs);
        EffectsResult result{.mode = effect,
                             .executeMs = m_frames.median(mode, &runs::FrameSample::executeMs),
                             .ratio = measure::median(ratios),
                             .ratio95 = measure::bootstrapMedian(ratios, m_options.seed + mode),
                             .leastAlike = {},
                             .picture = m_renderers[mode]->render(m_camera).color};
        std::optional<double> most;
        const std::span<const depth::NamedTechnique> techniques =
            m_options.techniques.empty() ? depth::presets() : std::span(m_options.techniques);
        for (const auto& [name, technique] : techniques) {
            const double share = shareApart(makeRenderer(effect, technique)->render(m_camera).color,
                                            result.picture, Apart::either);
            if (!most || share > *most) {
                most = share;
                result.leastAlike = name;
            }
        }
        result.differing = most.value_or(0.0);
        return result;
    }

  private:
    std::unique_ptr<render::Renderer> makeRenderer(EffectMode mode, const depth::Technique& technique) const {
        render::RenderOptions drawing = m_options.drawing;
        drawing.technique = technique;
        if (mode == EffectMode::occlusionLayers) {
            drawing.targets = render::TargetsKind::accumulate;
        }
        drawing.effects = effectsOf(mode, m_options);
        return std::make_unique<render::Renderer>(m_device, m_setup.scene, m_gpuScene, drawing);
    }

    const gpu::Device& m_device;
    const EffectsOptions& m_options;
    const scene::SceneSetup& m_setup;
    scene::Camera m_camera;
    render::GpuScene m_gpuScene;
    std::vector<std::unique_ptr<render::Renderer>> m_renderers; ///< by mode
    runs::InterleavedFrames m_frames;
};

} // namespace

std::string_view nameOf(EffectMode mode) {
    return kEffectModeNames.nameOf(mode);
}

EffectsReport runEffects(const gpu::Device& device, const scene::SceneSetup& setup,
                         const EffectsOptions& options, const Progress& progress, runs::TimedRanks& ranks) {
    if (options.frames < 1) {
        throw base::InputError("effects needs a frame");
    }
    const std::size_t all =
        std::size_t{runs::InterleavedFrames::kWarmUp} + options.frames + kEffectModes.size();
    std::size_t done = 0;
    EffectsComparison comparison(device, setup, options);
    comparison.time(ranks, [&] { progress(done++, all); });
    if (!ranks.isFirst()) {
        return {};
    }
    EffectsReport report;
    for (const EffectMode mode : kEffectModes) {
        progress(done++, all);
        report.results.push_back(comparison.summarise(mode));
    }
    report.lostPerLayer = shareApart(report.results[indexOf(EffectMode::occlusionLayers)].picture,
                                     report.results[indexOf(EffectMode::occlusion)].picture, Apart::brighter);
    return report;
}

} // namespace cdr::experiments
