#include "flicker.h"

#include "state.h"

#include <cdr/base/error.h>
#include <cdr/measure/compare/flip_difference.h>
#include <cdr/measure/truth/truth_shading.h>
#include <cdr/render/renderer.h>
#include <scenes/open_scene.h>

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

namespace cdr::experiments {

namespace {

/// One frame's truth, which all techniques share.
struct TruthFrame {
    measure::TruthImage truth;
    image::Raster<std::uint8_t> inner;
    image::ImageRgba8 picture; ///< empty where FLIP is not taken
};

/// One technique on its way through the frames.
struct Lane {
    std::unique_ptr<render::Renderer> renderer;
    bool remembers = false;    ///< whether a frame depends on those before it
    image::ImageU32 idsBefore; ///< of the frame before; empty at first
};

/// The experiment as it runs.
class Flicker {
  public:
    Flicker(const gpu::Device& device, const FlickerOptions& options, const FlickerHooks& hooks)
        : m_options(options),
          m_hooks(hooks),
          m_workers(options.threads),
          m_setup(scenes::openScene(options.nearObject ? "afc-near" : "afc", options.seed).setup),
          m_gpuScene(device, m_setup.scene),
          m_caster(m_setup.scene, m_workers) {
        for (const auto& [name, technique] : options.techniques) {
            m_lanes.push_back({.renderer = std::make_unique<render::Renderer>(
                                   device, m_setup.scene, m_gpuScene,
                                   render::RenderOptions{.width = options.width,
                                                         .height = options.height,
                                                         .technique = technique,
                                                         .threads = options.threads}),
                               .remembers = std::holds_alternative<depth::SplitFitted>(technique.split),
                               .idsBefore = {}});
            FlickerResult result;
            result.scene = m_setup.scene.name;
            result.technique = name;
            result.format = nameOf(technique.format);
            m_state.results.push_back(std::move(result));
        }
    }

    std::vector<FlickerResult> run(const FlickerStateFile* file) {
        if (file != nullptr) {
            file->load(m_state);
        }
        catchUp();
        while (m_state.framesDone < m_options.frames) {
            measureFrame(m_state.framesDone);
            ++m_state.framesDone;
            if (file != nullptr) {
                file->save(m_state);
            }
        }
        return m_state.results;
    }

  private:
    scene::Camera cameraAt(std::uint32_t frame) const {
        return m_setup.path.at(
            static_cast<std::uint32_t>(std::uint64_t{frame} * m_setup.path.frames / m_options.frames));
    }

    void step(std::uint32_t frame, std::size_t lane) const {
        if (m_hooks.progress) {
            m_hooks.progress(frame * m_lanes.size() + lane, m_options.frames * m_lanes.size(),
                             m_state.results[lane].technique);
        }
    }

    /// Renders again what an earlier run has measured, as far as what follows depends on it: fitted splits
    /// remember the frame before, flips need its ids, and pictures are wanted from the first frame on.
    void catchUp() {
        for (std::uint32_t frame = 0; frame < m_state.framesDone; ++frame) {
            const bool last = frame + 1 == m_state.framesDone && m_state.framesDone < m_options.frames;
            std::vector<image::ImageRgba8> pictures;
            for (std::size_t i = 0; i < m_lanes.size(); ++i) {
                if (m_hooks.pictures || m_lanes[i].remembers || last) {
                    step(frame, i);
                    render::Frame rendered = m_lanes[i].renderer->render(cameraAt(frame));
                    m_lanes[i].idsBefore = rendered.ids();
                    pictures.push_back(std::move(rendered.color));
                }
            }
            if (last) {
                m_truthBefore = truthAt(frame);
            }
            handOut(frame, pictures);
        }
    }

    TruthFrame truthAt(std::uint32_t frame) {
        const scene::Camera camera = cameraAt(frame);
        TruthFrame made{.truth = m_caster.cast(camera, m_options.width, m_options.height, m_workers),
                        .inner = {},
                        .picture = {}};
        made.inner = measure::innerMask(made.truth);
        if (takesFlip(frame)) {
            made.picture = measure::shadeTruth(m_setup.scene, camera, made.truth, m_workers);
        }
        return made;
    }

    bool takesFlip(std::uint32_t frame) const { return frame % m_options.flipEvery == 0; }

    void measureFrame(std::uint32_t frame) {
        TruthFrame truth = truthAt(frame);
        image::Raster<std::uint8_t> steady;
        if (frame > 0) {
            steady = measure::steadyMask(m_truthBefore.truth, m_truthBefore.inner, truth.truth, truth.inner);
        }
        std::vector<image::ImageRgba8> pictures;
        for (std::size_t i = 0; i < m_lanes.size(); ++i) {
            step(frame, i);
            render::Frame rendered = m_lanes[i].renderer->render(cameraAt(frame));
            addFrame(rendered, truth, steady, m_lanes[i], m_state.results[i]);
            pictures.push_back(std::move(rendered.color));
        }
        m_truthBefore = std::move(truth);
        handOut(frame, pictures);
    }

    /// Adds one frame of one technique to its result.
    void addFrame(const render::Frame& rendered, const TruthFrame& truth,
                  const image::Raster<std::uint8_t>& steady, Lane& lane, FlickerResult& result) {
        image::ImageU32 ids = rendered.ids();
        result.wrong += measure::countWrong(ids, truth.truth, truth.inner);
        if (!lane.idsBefore.pixels.empty()) {
            result.flips += measure::countFlips(lane.idsBefore, ids, steady);
        }
        if (!truth.picture.pixels.empty()) {
            const image::ImageRgba8 ordered =
                measure::orderByTruth(rendered.color, ids, truth.truth, truth.picture);
            result.flipSum += m_flip.mean(ordered, rendered.color, m_workers);
            ++result.flipFrames;
        }
        result.duplicationSum += rendered.stats.duplication;
        result.cascades = std::max(result.cascades, rendered.cascades.size());
        ++result.frames;
        lane.idsBefore = std::move(ids);
    }

    void handOut(std::uint32_t frame, const std::vector<image::ImageRgba8>& pictures) const {
        if (m_hooks.pictures) {
            m_hooks.pictures(frame, pictures);
        }
    }

    const FlickerOptions& m_options;
    const FlickerHooks& m_hooks;
    host::WorkerPool m_workers;
    scene::SceneSetup m_setup;
    render::GpuScene m_gpuScene;
    measure::TruthCaster m_caster;
    measure::FlipDifference m_flip;
    std::vector<Lane> m_lanes;
    FlickerState m_state;
    TruthFrame m_truthBefore;
};

} // namespace

std::vector<FlickerResult> runFlicker(const gpu::Device& device, const FlickerOptions& options,
                                      const FlickerHooks& hooks) {
    FlickerOptions complete = options;
    if (complete.techniques.empty()) {
        complete.techniques.assign(depth::presets().begin(), depth::presets().end());
    }
    if (complete.frames < 1 || complete.flipEvery < 1) {
        throw base::InputError("flicker: there must be at least one frame, and FLIP of every first or more");
    }
    std::optional<FlickerStateFile> file;
    if (complete.state) {
        file.emplace(*complete.state, complete, device.info());
    }
    return Flicker(device, complete, hooks).run(file ? &*file : nullptr);
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
