#include "focus.h"

#include "lens_reference.h"

#include <cdr/base/error.h>
#include <cdr/image/srgb.h>
#include <cdr/measure/compare/flip_difference.h>
#include <cdr/render/renderer.h>
#include <cdr/scene/frustum.h>

#include <runs/interleaved_frames.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <memory>

namespace cdr::experiments {

namespace {

struct FocusMode {
    const char* name;
    render::TargetsKind targets;
    bool isFocused;
    bool blends;
};
constexpr std::array kFocusModes{FocusMode{"single", render::TargetsKind::single, false, false},
                                 FocusMode{"layers", render::TargetsKind::layers, false, false},
                                 FocusMode{"focus", render::TargetsKind::layers, true, false},
                                 FocusMode{"focus-blend", render::TargetsKind::layers, true, true}};
/// All others are compared with it.
constexpr std::size_t kBase = 1;
constexpr const char* kReference = "cameras"; // a mode too, of results

/// Of linear light, over all channels.
double rmseOf(const image::ImageRgba8& a, const image::ImageRgba8& b) {
    const std::array<double, 256>& linear = image::linearOfSrgb();
    double sum = 0.0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const double apart = linear[a.pixels[i][channel]] - linear[b.pixels[i][channel]];
            sum += apart * apart;
        }
    }
    return std::sqrt(sum / (3.0 * static_cast<double>(a.pixels.size())));
}

/// A renderer per mode over one scene, and what each showed and took so far.
class FocusComparison {
  public:
    FocusComparison(const gpu::Device& device, const scene::SceneSetup& setup, const FocusOptions& options)
        : m_options(options),
          m_workers(options.drawing.threads),
          m_setup(setup),
          m_camera(m_setup.path.at(0)),
          m_lens(options.lens, scene::frustumOf(m_camera, options.drawing.width, options.drawing.height).tanY,
                 options.drawing.height),
          m_gpuScene(device, m_setup.scene),
          m_frames(kFocusModes.size(), options.seed) {
        for (const FocusMode& mode : kFocusModes) {
            m_renderers.push_back(
                std::make_unique<render::Renderer>(device, m_setup.scene, m_gpuScene, renderOptions(mode)));
        }
    }

    void time(runs::TimedRanks& ranks, const std::function<void()>& step) {
        m_frames.run(ranks, m_options.frames, step,
                     [&](std::size_t mode, std::uint32_t) { return m_renderers[mode]->draw(m_camera); });
    }

    /// The reference is of pictures by "single". They are drawn twice, since modes are timed without reading back.
    void addToReference(std::uint32_t camera) {
        render::Renderer& single = *m_renderers.front();
        const scene::Camera onLens = cameraOnLens(m_camera, m_options.lens, camera, m_options.cameras);
        const runs::FrameSample sample = runs::timed([&] { return single.draw(onLens); });
        m_referenceMs += sample.frameMs;
        m_referenceExecuteMs += sample.executeMs;
        m_reference.add(single.render(onLens).color);
    }

    FocusReport report() {
        FocusReport report;
        const image::ImageRgba8 reference = m_reference.mean();
        for (std::size_t mode = 0; mode < kFocusModes.size(); ++mode) {
            const render::Frame frame = m_renderers[mode]->render(m_camera);
            if (mode == kBase) {
                report.cascades = cascadesOf(frame);
            }
            FocusResult result = summarise(mode);
            result.flip = m_flip.mean(reference, frame.color, m_workers);
            result.rmse = rmseOf(reference, frame.color);
            result.picture = frame.color;
            report.results.push_back(std::move(result));
        }
        for (std::size_t mode = 0; mode < kFocusModes.size(); ++mode) {
            report.results[mode].pixels = pixelsOf(kFocusModes[mode], report.cascades);
        }
        report.results.push_back({.mode = kReference,
                                  .frameMs = m_referenceMs,
                                  .executeMs = m_referenceExecuteMs,
                                  .speedup = report.results[kBase].executeMs / m_referenceExecuteMs,
                                  .pixels = m_options.cameras * reference.pixels.size(),
                                  .picture = reference});
        return report;
    }

  private:
    render::RenderOptions renderOptions(const FocusMode& mode) const {
        const depth::Split split = m_options.split.value_or(depth::SplitAt{m_lens.boundaries()});
        render::RenderOptions options = m_options.drawing;
        options.technique = {m_options.mapping, split, depth::DepthFormat::d32f};
        options.targets = mode.targets;
        if (mode.isFocused) {
            options.focus = m_options.lens;
            options.focus.blend = mode.blends;
        }
        return options;
    }

    std::vector<FocusCascade> cascadesOf(const render::Frame& frame) const {
        std::vector<FocusCascade> cascades;
        for (const depth::Cascade& cascade : frame.cascades) {
            cascades.push_back(
                {.nearView = cascade.nearView, .farView = cascade.farView, .scale = m_lens.scaleOf(cascade)});
        }
        return cascades;
    }

    std::uint64_t pixelsOf(const FocusMode& mode, const std::vector<FocusCascade>& cascades) const {
        std::uint64_t pixels = 0;
        for (const FocusCascade& cascade : cascades) {
            const std::uint32_t scale = mode.isFocused ? cascade.scale : 1;
            const std::uint64_t columns = (m_options.drawing.width + scale - 1) / scale;
            pixels += columns * ((m_options.drawing.height + scale - 1) / scale);
        }
        return mode.targets == render::TargetsKind::single
                   ? std::uint64_t{m_options.drawing.width} * m_options.drawing.height
                   : pixels;
    }

    FocusResult summarise(std::size_t mode) const {
        const std::vector<double> ratios = m_frames.ratios(kBase, mode, &runs::FrameSample::executeMs);
        return {.mode = kFocusModes[mode].name,
                .frameMs = m_frames.median(mode, &runs::FrameSample::frameMs),
                .executeMs = m_frames.median(mode, &runs::FrameSample::executeMs),
                .speedup = measure::median(ratios),
                .speedup95 = measure::bootstrapMedian(ratios, m_options.seed + mode),
                .picture = {}};
    }

    const FocusOptions& m_options;
    platform::WorkerPool m_workers;
    const scene::SceneSetup& m_setup;
    scene::Camera m_camera;
    render::FocusLens m_lens;
    render::GpuScene m_gpuScene;
    std::vector<std::unique_ptr<render::Renderer>> m_renderers; ///< by mode
    runs::InterleavedFrames m_frames;
    LensReference m_reference;
    double m_referenceMs = 0.0;
    double m_referenceExecuteMs = 0.0;
    measure::FlipDifference m_flip;
};

} // namespace

std::vector<std::string> focusModeNames() {
    std::vector<std::string> names{kReference};
    for (const FocusMode& mode : kFocusModes) {
        names.emplace_back(mode.name);
    }
    return names;
}

FocusReport runFocus(const gpu::Device& device, const scene::SceneSetup& setup, const FocusOptions& options,
                     const Progress& progress, runs::TimedRanks& ranks) {
    if (options.frames < 1 || options.cameras < 1) {
        throw base::InputError("focus needs a frame and a camera");
    }
    requireUsable(options.lens);
    if (!options.lens.isOn() || !(options.lens.aperture > 0.0)) {
        throw base::InputError("focus needs a distance and an aperture above 0");
    }
    const std::size_t all =
        std::size_t{runs::InterleavedFrames::kWarmUp} + options.frames + std::size_t{options.cameras};
    std::size_t done = 0;
    FocusComparison comparison(device, setup, options);
    comparison.time(ranks, [&] { progress(done++, all); });
    if (!ranks.isFirst()) {
        return {};
    }
    for (std::uint32_t i = 0; i < options.cameras; ++i) {
        progress(done++, all);
        comparison.addToReference(i);
    }
    return comparison.report();
}

} // namespace cdr::experiments
