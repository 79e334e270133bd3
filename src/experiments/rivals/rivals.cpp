#include "rivals.h"

#include "drawer.h"

#include <cdr/base/format_error.h>
#include <cdr/measure/truth/truth.h>
#include <cdr/render/renderer.h>
#include <experiments/orbit/orbit.h>
#include <experiments/probe/resolved.h>
#include <scenes/ladder.h>

#include <fmt/format.h>
#include <runs/interleaved_frames.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cdr::experiments {

namespace {

/// Finer than other probes': with a distance from its own object, a rival may be.
constexpr double kSmallestSeparation = 1e-9;
/// Of the front of unlike pairs; no power of two, so that its corners round in their own way.
constexpr double kUnlikeDepth = 0.37;
/// The median is of those in which a pixel tells.
constexpr std::uint64_t kLadders = 5;

/// A scene with every contender on it.
class RivalField {
  public:
    /// What it is made of must outlive it.
    RivalField(const gpu::Device& device, const RivalsOptions& options, const scene::SceneSetup& setup,
               platform::WorkerPool& workers)
        : m_options(options),
          m_workers(workers),
          m_setup(setup),
          m_gpuScene(device, m_setup.scene),
          m_caster(m_setup.scene, workers) {
        const vk::Extent2D extent{options.width, options.height};
        for (const NamedContender& named : options.contenders) {
            m_contenders.emplace_back(device, m_gpuScene, named.competing, extent, workers);
        }
    }

    measure::TruthImage truthAt(const scene::Camera& camera) const {
        return m_caster.cast(camera, m_options.width, m_options.height, m_workers);
    }

    const scene::SceneSetup& setup() const { return m_setup; }
    const render::GpuScene& gpuScene() const { return m_gpuScene; }
    Drawer& contender(std::size_t index) { return m_contenders[index]; }
    std::size_t size() const { return m_contenders.size(); }

  private:
    const RivalsOptions& m_options;
    platform::WorkerPool& m_workers;
    const scene::SceneSetup& m_setup;
    render::GpuScene m_gpuScene;
    measure::TruthCaster m_caster;
    std::vector<Drawer> m_contenders;
};

/// The experiment as it runs.
class RivalsRun {
  public:
    RivalsRun(const gpu::Device& device, const std::vector<NamedScene>& scenes, const RivalsOptions& options,
              const NamedProgress& progress)
        : m_device(device),
          m_scenes(scenes),
          m_options(options),
          m_progress(progress),
          m_workers(options.threads),
          m_baseline(findBaseline(options)),
          m_steps(scenes.size() * (2 * options.frames + runs::InterleavedFrames::kWarmUp) +
                  options.distancesView.size() * 2 * kLadders) {
        for (const double distanceView : options.distancesView) {
            probeLadder(distanceView); // an unusable one ends here, before any work
        }
    }

    RivalsReport run() {
        RivalsReport report;
        for (const NamedScene& scene : m_scenes) {
            measureScene(scene, report);
        }
        for (const double distanceView : m_options.distancesView) {
            measureLadder(distanceView, report);
        }
        for (const NamedContender& named : m_options.contenders) {
            report.needs.push_back(needsOf(named.name, named.competing));
        }
        return report;
    }

  private:
    static std::size_t findBaseline(const RivalsOptions& options) {
        const auto found = std::ranges::find_if(
            options.contenders, [&](const NamedContender& named) { return named.name == options.baseline; });
        if (found == options.contenders.end() || found->isRival()) {
            throw base::inputError("{} must be among the techniques, because times are relative to it",
                                   options.baseline);
        }
        return static_cast<std::size_t>(found - options.contenders.begin());
    }

    void step(const std::string& what) {
        if (m_progress) {
            m_progress(std::min(m_done++, m_steps - 1), m_steps, what);
        }
    }

    void measureScene(const NamedScene& scene, RivalsReport& report) {
        RivalField field(m_device, m_options, scene.setup, m_workers);
        std::vector<RivalScene> results;
        for (const NamedContender& named : m_options.contenders) {
            RivalScene result;
            result.scene = scene.name;
            result.contender = named.name;
            result.isRival = named.isRival();
            results.push_back(result);
        }
        const std::vector<std::uint32_t> frames = zoomFrames(field.setup().path.frames, m_options.frames);
        compareWithTruth(field, frames, results);
        report.wholeFrames.push_back(time(field, frames, results));
        report.scenes.insert(report.scenes.end(), results.begin(), results.end());
    }

    void compareWithTruth(RivalField& field, const std::vector<std::uint32_t>& frames,
                          std::vector<RivalScene>& results) {
        measure::SceneTruth expected;
        std::vector<image::ImageU32> idsBefore(field.size());
        for (const std::uint32_t frame : frames) {
            step(fmt::format("{} against the truth", results.front().scene));
            const scene::Camera camera = field.setup().path.at(frame);
            expected.add(field.truthAt(camera));
            for (std::size_t i = 0; i < field.size(); ++i) {
                DrawnFrame drawn = field.contender(i).render(camera);
                results[i].wrong += measure::countWrong(drawn.ids, expected.truth, expected.inner);
                if (expected.steady) {
                    results[i].flips += measure::countFlips(idsBefore[i], drawn.ids, *expected.steady);
                }
                idsBefore[i] = std::move(drawn.ids);
                results[i].cascades = std::max(results[i].cascades, drawn.cascades);
                ++results[i].frames;
            }
        }
    }

    /// Contenders, and last the library's own frame.
    RivalWholeFrame time(RivalField& field, const std::vector<std::uint32_t>& frames,
                         std::vector<RivalScene>& results) {
        const std::size_t whole = field.size();
        render::Renderer renderer(
            m_device, field.setup().scene, field.gpuScene(),
            {.width = m_options.width,
             .height = m_options.height,
             .technique = std::get<depth::Technique>(m_options.contenders[m_baseline].competing),
             .threads = m_options.threads});
        runs::InterleavedFrames timings(whole + 1, m_options.seed);
        timings.runAlone(
            m_options.frames, [&] { step(fmt::format("{} timed", results.front().scene)); },
            [&](std::size_t mode, std::uint32_t frame) {
                const scene::Camera camera = field.setup().path.at(frames[frame % frames.size()]);
                return mode == whole ? renderer.draw(camera) : field.contender(mode).draw(camera);
            });
        for (std::size_t i = 0; i < results.size(); ++i) {
            const std::vector<double> ratios = timings.ratios(i, m_baseline, &runs::FrameSample::frameMs);
            results[i].frameMs = timings.median(i, &runs::FrameSample::frameMs);
            results[i].executeMs = timings.median(i, &runs::FrameSample::executeMs);
            results[i].ratio = measure::median(ratios);
            results[i].ratio95 = measure::bootstrapMedian(ratios, m_options.seed + i);
        }
        const std::vector<double> ratios = timings.ratios(whole, m_baseline, &runs::FrameSample::frameMs);
        return {.scene = results.front().scene,
                .ratio = measure::median(ratios),
                .ratio95 = measure::bootstrapMedian(ratios, m_options.seed + whole)};
    }

    void measureLadder(double distanceView, RivalsReport& report) {
        scenes::LadderOptions ladder = probeLadder(distanceView);
        ladder.smallestSeparation = kSmallestSeparation;
        const std::vector<Resolved> equal = resolvedOn(ladder);
        ladder.frontDepth = kUnlikeDepth;
        const std::vector<Resolved> unlike = resolvedOn(ladder);
        const std::optional<double> baseline = unlike[m_baseline].view;
        for (std::size_t i = 0; i < equal.size(); ++i) {
            report.resolved.push_back(
                {.contender = m_options.contenders[i].name,
                 .isRival = m_options.contenders[i].isRival(),
                 .distanceView = distanceView,
                 .resolvedView = equal[i].view,
                 .unlikeView = unlike[i].view,
                 .resolvesAll = equal[i].all,
                 .unlikeResolvesAll = unlike[i].all,
                 .pairsSeen = equal[i].pairsSeen,
                 .unlikePairsSeen = unlike[i].pairsSeen,
                 .ratio =
                     baseline && unlike[i].view ? std::optional(*unlike[i].view / *baseline) : std::nullopt,
                 .smallestView = scenes::ladderSeparation(ladder, 0),
                 .largestView = scenes::ladderSeparation(ladder, scenes::kLadderPairs - 1)});
        }
    }

    /// By contender: the median over ladders of other seeds, since a single pair that rounds well or badly moves one.
    std::vector<Resolved> resolvedOn(const scenes::LadderOptions& ladder) {
        constexpr double kNone = std::numeric_limits<double>::infinity();
        std::vector<std::vector<double>> samples(m_options.contenders.size());
        std::vector<Resolved> medians(m_options.contenders.size());
        std::vector<std::size_t> ended(
            medians.size()); // ladders without a wrong pixel, whose samples are bounds
        for (std::uint64_t i = 0; i < kLadders; ++i) {
            step(fmt::format("ladder at {}", ladder.distanceView));
            const scene::SceneSetup setup = scenes::makeLadder(m_options.seed + i, ladder);
            RivalField field(m_device, m_options, setup, m_workers);
            const scene::Camera camera = field.setup().path.at(0);
            const measure::TruthImage truth = field.truthAt(camera);
            for (std::size_t each = 0; each < field.size(); ++each) {
                const image::ImageU32 ids = field.contender(each).render(camera).ids;
                const Resolved resolved = resolvedIn(ids, truth, ladder);
                medians[each].pairsSeen += resolved.pairsSeen;
                if (resolved.pairsSeen > 0) {
                    samples[each].push_back(resolved.view.value_or(kNone));
                    ended[each] += resolved.all ? 1 : 0;
                }
            }
        }
        for (std::size_t each = 0; each < medians.size(); ++each) {
            const double middle = samples[each].empty() ? kNone : measure::median(samples[each]);
            medians[each].view = std::isfinite(middle) ? std::optional(middle) : std::nullopt;
            medians[each].all = medians[each].view && 2 * ended[each] >= samples[each].size();
        }
        return medians;
    }

    const gpu::Device& m_device;
    const std::vector<NamedScene>& m_scenes;
    const RivalsOptions& m_options;
    const NamedProgress& m_progress;
    platform::WorkerPool m_workers;
    std::size_t m_baseline;
    std::size_t m_steps;
    std::size_t m_done = 0;
};

} // namespace

std::vector<NamedContender> defaultContenders(const gpu::DeviceInfo& device) {
    std::vector<NamedContender> all;
    for (const depth::NamedTechnique& preset : depth::presets()) {
        all.push_back({preset.name, preset.technique});
    }
    for (const char* suffix : {"", "/prepass"}) {
        for (const rivals::NamedRival& known : rivals::namedRivals()) {
            if (rivals::missingFeatures(device, known.rival).empty()) {
                const rivals::NamedRival named = rivals::parseRival(known.name + suffix);
                all.push_back({named.name, named.rival});
            }
        }
    }
    return all;
}

RivalsReport runRivals(const gpu::Device& device, const std::vector<NamedScene>& scenes,
                       const RivalsOptions& options, const NamedProgress& progress) {
    RivalsOptions complete = options;
    if (complete.contenders.empty()) {
        complete.contenders = defaultContenders(device.info());
    }
    if (complete.frames < 1) {
        throw base::InputError("rivals: there must be at least one frame");
    }
    return RivalsRun(device, scenes, complete, progress).run();
}

} // namespace cdr::experiments
