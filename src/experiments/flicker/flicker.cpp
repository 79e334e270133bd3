#include "flicker.h"

#include <cdr/base/error.h>
#include <cdr/measure/compare/flip_difference.h>
#include <cdr/measure/truth/truth_shading.h>
#include <experiments/rivals/drawer.h>
#include <scenes/open_scene.h>

#include <runs/units.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace cdr::experiments {

namespace {

/// One technique or rival on its way through the frames.
struct Lane {
    Drawer drawer;
    std::uint32_t next = 0;      ///< frame that comes after those rendered or skipped
    image::ImageU32 idsBefore{}; ///< of the frame before
};

/// One technique in one frame.
struct Figures {
    measure::WrongPixels wrong{};
    measure::FlipCount flips{};
    double flip = 0.0;           ///< mean FLIP, where it is taken
    std::uint64_t flipTaken = 0; ///< 1 where it is
    double duplication = 1.0;
    std::uint64_t cascades = 0;
};
// Padding may hold anything, and states of equal runs are equal.
static_assert(sizeof(Figures) == 11 * sizeof(std::uint64_t));

void add(const Figures& figures, FlickerResult& result) {
    result.wrong += figures.wrong;
    result.flips += figures.flips;
    if (figures.flipTaken > 0) {
        result.flipSum += figures.flip;
        ++result.flipFrames;
    }
    result.duplicationSum += figures.duplication;
    result.cascades = std::max<std::size_t>(result.cascades, figures.cascades);
    ++result.frames;
}

/// The experiment as it runs.
class Flicker {
  public:
    Flicker(const gpu::Device& device, const FlickerOptions& options, const NamedProgress& progress)
        : m_options(options),
          m_rangeLength(std::clamp(options.frames / 32, 1u, 8u)),
          m_progress(progress),
          m_workers(options.drawing.threads),
          m_setup(scenes::openScene(options.nearObject ? "afc-near" : "afc", options.seed).setup),
          m_gpuScene(device, m_setup.scene),
          m_caster(m_setup.scene, m_workers) {
        for (NamedDrawer& each : makeDrawers(device, m_gpuScene, options.drawing, options.techniques,
                                             options.rivalsBeside, m_workers)) {
            addLane(std::move(each));
        }
    }

    std::vector<FlickerResult> run(ranks::Ranks& ranks) {
        runs::forEachUnit(
            ranks, (m_options.frames + m_rangeLength - 1) / m_rangeLength,
            [&](std::size_t unit) { return measureRange(unit); },
            [&](std::size_t unit, const output::Json& range) { takeRange(unit, range); });
        return m_results;
    }

    void show(ranks::Ranks& ranks, const FlickerPictures& take) {
        runs::forEachUnit(
            ranks, m_options.frames,
            [&](std::size_t frame) { return picturesOf(static_cast<std::uint32_t>(frame)); },
            [&](std::size_t frame, const output::Json& packed) {
                std::vector<image::ImageRgba8> pictures;
                for (const output::Json& picture : packed) {
                    pictures.push_back(runs::unpackedPicture(picture));
                }
                take(static_cast<std::uint32_t>(frame), pictures);
            });
    }

  private:
    void addLane(NamedDrawer named) {
        FlickerResult& result = m_results.emplace_back();
        result.scene = m_setup.scene.name;
        result.technique = named.name;
        if (m_lanes.size() < m_options.techniques.size()) {
            result.format = m_options.techniques[m_lanes.size()].technique.format;
        }
        m_lanes.push_back({.drawer = std::move(named.drawer)});
    }

    scene::Camera cameraAt(std::uint32_t frame) const {
        return m_setup.path.at(
            static_cast<std::uint32_t>(std::uint64_t{frame} * m_setup.path.frames / m_options.frames));
    }

    void step(std::uint32_t frame, std::size_t lane) const {
        m_progress(frame * m_lanes.size() + lane, m_options.frames * m_lanes.size(),
                   m_results[lane].technique);
    }

    /// Past the frames that other ranks or an earlier run drew, which fitted splits remember.
    DrawnFrame render(std::uint32_t frame, std::size_t lane) {
        step(frame, lane);
        Lane& own = m_lanes[lane];
        for (; own.next < frame; ++own.next) {
            own.drawer.skip(cameraAt(own.next));
        }
        ++own.next;
        return own.drawer.render(cameraAt(frame));
    }

    output::Json picturesOf(std::uint32_t frame) {
        output::Json pictures = output::Json::array();
        for (std::size_t i = 0; i < m_lanes.size(); ++i) {
            pictures.push_back(runs::packedPicture(render(frame, i).color));
        }
        return pictures;
    }

    /// The first frame of a range, or behind the last range the number of frames.
    std::uint32_t beginOf(std::size_t range) const {
        return static_cast<std::uint32_t>(std::min<std::size_t>(range * m_rangeLength, m_options.frames));
    }

    output::Json measureRange(std::size_t range) {
        std::vector<Figures> figures;
        for (std::uint32_t frame = beginOf(range); frame < beginOf(range + 1); ++frame) {
            measureFrame(frame, figures);
        }
        return runs::packed(figures);
    }

    void takeRange(std::size_t range, const output::Json& measured) {
        const std::size_t frames = beginOf(range + 1) - beginOf(range);
        const auto figures = runs::unpacked<Figures>(measured, frames * m_lanes.size());
        for (std::size_t i = 0; i < figures.size(); ++i) {
            add(figures[i], m_results[i % m_lanes.size()]);
        }
    }

    /// Makes sure that ids and truth of the frame before are there, which flips of a frame are counted against.
    void bringBefore(std::uint32_t frame) {
        if (frame == 0 || m_truthFrame == frame - 1) {
            return;
        }
        for (std::size_t i = 0; i < m_lanes.size(); ++i) {
            m_lanes[i].idsBefore = render(frame - 1, i).ids;
        }
        m_truth = {};
        m_truth.add(truthAt(frame - 1));
    }

    measure::TruthImage truthAt(std::uint32_t frame) {
        return m_caster.cast(cameraAt(frame), m_options.drawing.width, m_options.drawing.height, m_workers);
    }

    /// Empty where FLIP is not taken.
    image::ImageRgba8 truePicture(std::uint32_t frame) {
        return frame % m_options.flipEvery == 0
                   ? measure::shadeTruth(m_setup.scene, m_caster, cameraAt(frame), m_truth.truth, m_workers)
                   : image::ImageRgba8();
    }

    void measureFrame(std::uint32_t frame, std::vector<Figures>& figures) {
        bringBefore(frame);
        m_truth.add(truthAt(frame));
        m_truthFrame = frame;
        const image::ImageRgba8 picture = truePicture(frame);
        for (std::size_t i = 0; i < m_lanes.size(); ++i) {
            DrawnFrame drawn = render(frame, i);
            figures.push_back(measure(drawn, picture, m_lanes[i]));
        }
    }

    /// Moves the ids to the lane.
    Figures measure(DrawnFrame& drawn, const image::ImageRgba8& picture, Lane& lane) {
        Figures figures{.wrong = measure::countWrong(drawn.ids, m_truth.truth, m_truth.inner),
                        .duplication = drawn.duplication,
                        .cascades = drawn.cascades};
        if (m_truth.steady) {
            figures.flips = measure::countFlips(lane.idsBefore, drawn.ids, *m_truth.steady);
        }
        if (!picture.pixels.empty() && lane.drawer.shades()) {
            const image::ImageRgba8 ordered =
                measure::orderByTruth(drawn.color, drawn.ids, m_truth.truth, picture);
            figures.flip = m_flip.mean(ordered, drawn.color, m_workers);
            figures.flipTaken = 1;
        }
        lane.idsBefore = std::move(drawn.ids);
        return figures;
    }

    const FlickerOptions& m_options;
    /// A range begins with the frame before it, which flips need, so it has some length. With any number of ranks it has the
    /// same, since they may go on from one state.
    std::uint32_t m_rangeLength;
    const NamedProgress& m_progress;
    platform::WorkerPool m_workers;
    scene::SceneSetup m_setup;
    render::GpuScene m_gpuScene;
    measure::TruthCaster m_caster;
    measure::FlipDifference m_flip;
    std::vector<Lane> m_lanes;
    std::vector<FlickerResult> m_results; ///< by lane
    measure::SceneTruth m_truth;
    std::optional<std::uint32_t> m_truthFrame; ///< that it is of
};

} // namespace

std::vector<FlickerResult> runFlicker(const gpu::Device& device, const FlickerOptions& options,
                                      const NamedProgress& progress, ranks::Ranks& ranks) {
    if (options.frames < 1 || options.flipEvery < 1) {
        throw base::InputError("flicker: there must be at least one frame, and FLIP of every first or more");
    }
    return Flicker(device, options, progress).run(ranks);
}

void showFlicker(const gpu::Device& device, const FlickerOptions& options, const NamedProgress& progress,
                 ranks::Ranks& ranks, const FlickerPictures& take) {
    FlickerOptions shown = options;
    shown.rivalsBeside.clear(); // they have no pictures
    Flicker(device, shown, progress).show(ranks, take);
}

std::vector<depth::NamedTechnique> movedBoundaries() {
    // The field reaches 28 units to either side of 10^6, where ratio:1000 from 0.001 puts its last boundary.
    const auto cut = [](const char* name, double lastView) -> depth::NamedTechnique {
        return {name, {.mapping = depth::Mapping::standard, .split = depth::SplitAt{{1.0, 1e3, lastView}}}};
    };
    return {cut("cdr-before", 1e6 - 1000.0), cut("cdr-behind", 1e6 + 1000.0)};
}

depth::NamedTechnique fittedRange() {
    return {"standard-fitted", {.mapping = depth::Mapping::standard, .split = depth::SplitFitted{.most = 1}}};
}

} // namespace cdr::experiments
