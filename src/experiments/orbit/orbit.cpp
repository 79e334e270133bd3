#include "orbit.h"

#include <cdr/measure/truth/truth.h>
#include <cdr/render/renderer.h>
#include <experiments/units.h>

#include <memory>
#include <numbers>

namespace cdr::experiments {

namespace {

/// One technique in one frame.
struct Drawn {
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
          m_workers(options.threads),
          m_caster(setup.scene, m_workers) {
        for (const auto& [name, technique] : options.techniques) {
            m_renderers.push_back(
                std::make_unique<render::Renderer>(device, setup.scene, m_gpuScene,
                                                   render::RenderOptions{.width = options.width,
                                                                         .height = options.height,
                                                                         .technique = technique,
                                                                         .threads = options.threads}));
        }
    }

    std::size_t frames() const { return m_numbers.size(); }

    /// All techniques in one frame; of the first and the last one pictures too.
    Json measure(std::size_t unit, const Progress& progress) {
        for (; m_next < unit; ++m_next) {
            for (const auto& renderer : m_renderers) {
                renderer->skip(cameraOf(m_next));
            }
        }
        ++m_next;
        const scene::Camera camera = cameraOf(unit);
        const measure::TruthImage truth = m_caster.cast(camera, m_options.width, m_options.height, m_workers);
        const image::Raster<std::uint8_t> inner = measure::innerMask(truth);
        std::vector<Drawn> drawn;
        Json made{{"last", Json::array()}};
        for (const auto& renderer : m_renderers) {
            progress(unit * m_renderers.size() + drawn.size(), m_numbers.size() * m_renderers.size(),
                     m_options.techniques[drawn.size()].name);
            const render::Frame frame = renderer->render(camera);
            drawn.push_back(
                {.cascades = frame.cascades.size(), .wrong = measure::countWrong(frame.ids(), truth, inner)});
            if (unit == 0 && renderer == m_renderers.back()) {
                made["window"] = packedPicture(frame.color);
            }
            if (unit + 1 == m_numbers.size()) {
                made["last"].push_back(
                    {{"picture", packedPicture(frame.color)},
                     {"heat_map", packedPicture(measure::heatMap(frame.ids(), truth, frame.color))}});
            }
        }
        made["drawn"] = packed(drawn);
        return made;
    }

    /// Adds what measure() made.
    void add(std::size_t unit, const Json& made, OrbitRun& run) const {
        const double fovYDegrees = cameraOf(unit).fovY * 180.0 / std::numbers::pi;
        const std::vector<Drawn> drawn = unpacked<Drawn>(made.at("drawn"), m_renderers.size());
        for (std::size_t i = 0; i < drawn.size(); ++i) {
            run.results.push_back({.frame = m_numbers[unit],
                                   .fovYDegrees = fovYDegrees,
                                   .technique = m_options.techniques[i].name,
                                   .cascades = drawn[i].cascades,
                                   .wrong = drawn[i].wrong});
        }
        if (made.contains("window")) {
            run.window = unpackedPicture(made["window"]);
        }
        for (const Json& pictures : made.at("last")) {
            PictureResult& picture = run.last.emplace_back();
            picture.scene = "orbit";
            picture.technique = m_options.techniques.at(run.last.size() - 1).name;
            picture.fovYDegrees = fovYDegrees;
            picture.frames = 1;
            picture.wrong = drawn[run.last.size() - 1].wrong;
            picture.picture = unpackedPicture(pictures.at("picture"));
            picture.heatMap = unpackedPicture(pictures.at("heat_map"));
        }
    }

  private:
    scene::Camera cameraOf(std::size_t unit) const { return m_setup.path.at(m_numbers[unit]); }

    const scene::SceneSetup& m_setup;
    const OrbitOptions& m_options;
    std::vector<std::uint32_t> m_numbers; ///< of the frames, by unit
    render::GpuScene m_gpuScene;
    host::WorkerPool m_workers;
    measure::TruthCaster m_caster;
    std::vector<std::unique_ptr<render::Renderer>> m_renderers; ///< by technique
    std::size_t m_next = 0; ///< unit that comes after those done or skipped
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

OrbitRun runOrbit(const gpu::Device& device, const scene::SceneSetup& setup, const OrbitOptions& given,
                  const Progress& progress, ranks::Ranks& ranks) {
    OrbitOptions options = given;
    if (options.techniques.empty()) {
        options.techniques.assign(depth::presets().begin(), depth::presets().end());
    }
    Zoom zoom(device, setup, options);
    OrbitRun run;
    forEachUnit(
        ranks, zoom.frames(), [&](std::size_t unit) { return zoom.measure(unit, progress); },
        [&](std::size_t unit, const Json& made) { zoom.add(unit, made, run); });
    return run;
}

} // namespace cdr::experiments
