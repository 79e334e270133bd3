#include "orbit.h"

#include <cdr/measure/truth/truth.h>
#include <experiments/rivals/drawer.h>

#include <runs/units.h>

#include <numbers>

namespace cdr::experiments {

namespace {

/// One technique or rival in one frame.
struct Measured {
    std::size_t cascades = 0;
    measure::WrongPixels wrong;
};

/// Draws and measures frames in ascending order.
class Zoom {
  public:
    Zoom(const gpu::Device& device, const scene::SceneSetup& setup, const OrbitOptions& options)
        : m_setup(setup),
          m_options(options),
          m_numbers(zoomFrames(setup.path.frames, options.frames)),
          m_gpuScene(device, setup.scene),
          m_workers(options.drawing.threads),
          m_caster(setup.scene, m_workers),
          m_drawers(makeDrawers(device, m_gpuScene, options.drawing, options.techniques, options.rivalsBeside,
                                m_workers)) {}

    std::size_t frames() const { return m_numbers.size(); }

    /// All techniques and rivals in one frame; of the first and the last one pictures too.
    output::Json measure(std::size_t unit, const NamedProgress& progress) {
        for (; m_next < unit; ++m_next) {
            for (NamedDrawer& each : m_drawers) {
                each.drawer.skip(cameraOf(m_next));
            }
        }
        ++m_next;
        const scene::Camera camera = cameraOf(unit);
        const measure::TruthImage truth =
            m_caster.cast(camera, m_options.drawing.width, m_options.drawing.height, m_workers);
        const image::Raster<std::uint8_t> inner = measure::innerMask(truth);
        std::vector<Measured> measured;
        output::Json made{{"last", output::Json::array()}};
        for (std::size_t i = 0; i < m_drawers.size(); ++i) {
            progress(unit * m_drawers.size() + i, m_numbers.size() * m_drawers.size(), m_drawers[i].name);
            const DrawnFrame frame = m_drawers[i].drawer.render(camera);
            measured.push_back(
                {.cascades = frame.cascades, .wrong = measure::countWrong(frame.ids, truth, inner)});
            const bool isWindow = unit == 0 && m_numbers.size() > 1; // else it is the last frame too
            if (m_options.keepsPictures && isWindow && i + 1 == m_options.techniques.size()) {
                made["window"] = runs::packedPicture(frame.color);
            }
            if (m_options.keepsPictures && unit + 1 == m_numbers.size() && m_drawers[i].drawer.shades()) {
                made["last"].push_back(
                    {{"picture", runs::packedPicture(frame.color)},
                     {"heat_map", runs::packedPicture(measure::heatMap(frame.ids, truth, frame.color))}});
            }
        }
        made["measured"] = runs::packed(measured);
        return made;
    }

    /// Adds what measure() made.
    void add(std::size_t unit, const output::Json& made, OrbitRun& run) const {
        const double fovYDegrees = cameraOf(unit).fovY * 180.0 / std::numbers::pi;
        const std::vector<Measured> measured =
            runs::unpacked<Measured>(made.at("measured"), m_drawers.size());
        for (std::size_t i = 0; i < measured.size(); ++i) {
            run.results.push_back({.frame = m_numbers[unit],
                                   .fovYDegrees = fovYDegrees,
                                   .technique = m_drawers[i].name,
                                   .isRival = i >= m_options.techniques.size(),
                                   .cascades = measured[i].cascades,
                                   .wrong = measured[i].wrong});
        }
        if (made.contains("window")) {
            run.window = runs::unpackedPicture(made["window"]);
        }
        for (const output::Json& pictures : made.at("last")) {
            PictureResult& picture = run.last.emplace_back();
            picture.scene = "orbit";
            picture.technique = m_drawers.at(run.last.size() - 1).name;
            picture.fovYDegrees = fovYDegrees;
            picture.frames = 1;
            picture.wrong = measured[run.last.size() - 1].wrong;
            picture.picture = runs::unpackedPicture(pictures.at("picture"));
            picture.heatMap = runs::unpackedPicture(pictures.at("heat_map"));
        }
    }

  private:
    scene::Camera cameraOf(std::size_t unit) const { return m_setup.path.at(m_numbers[unit]); }

    const scene::SceneSetup& m_setup;
    const OrbitOptions& m_options;
    std::vector<std::uint32_t> m_numbers; ///< of the frames, by unit
    render::GpuScene m_gpuScene;
    platform::WorkerPool m_workers;
    measure::TruthCaster m_caster;
    std::vector<NamedDrawer> m_drawers; ///< by technique, then rival
    std::size_t m_next = 0;             ///< unit that comes after those done or skipped
};

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

OrbitRun runOrbit(const gpu::Device& device, const scene::SceneSetup& setup, const OrbitOptions& options,
                  const NamedProgress& progress, ranks::Ranks& ranks) {
    Zoom zoom(device, setup, options);
    OrbitRun run;
    runs::forEachUnit(
        ranks, zoom.frames(), [&](std::size_t unit) { return zoom.measure(unit, progress); },
        [&](std::size_t unit, const output::Json& made) { zoom.add(unit, made, run); });
    return run;
}

} // namespace cdr::experiments
