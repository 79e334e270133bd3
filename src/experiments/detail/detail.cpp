#include "detail.h"

#include <cdr/base/error.h>
#include <cdr/image/compose.h>
#include <cdr/measure/compare/cracks.h>
#include <cdr/measure/compare/flip_difference.h>
#include <cdr/platform/stopwatch.h>
#include <cdr/render/renderer.h>
#include <cdr/render/uploaded_scene.h>
#include <cdr/scene/lod/clusters.h>
#include <cdr/scene/lod/levels.h>
#include <cdr/visibility/bin_cells.h>
#include <cdr/visibility/cluster_choice.h>

#include <runs/interleaved_frames.h>
#include <runs/units.h>

#include <algorithm>
#include <array>
#include <limits>
#include <memory>

namespace cdr::experiments {

namespace {

struct ComparedMode {
    const char* name;
    visibility::DetailMode mode;
};
/// The first is what all others are compared with.
constexpr std::array kDetailModes{ComparedMode{"none", visibility::DetailMode::none},
                                  ComparedMode{"none-again", visibility::DetailMode::none},
                                  ComparedMode{"object", visibility::DetailMode::perObject},
                                  ComparedMode{"cascade", visibility::DetailMode::perCascade},
                                  ComparedMode{"cluster", visibility::DetailMode::perCluster}};

measure::SeenImage seenIn(const render::Frame& frame) {
    return image::rasterOf<measure::SeenPixel>(frame.width(), frame.height(), [&](auto x, auto y) {
        return measure::SeenPixel{.id = frame.id(x, y), .distanceView = frame.distanceView(x, y)};
    });
}

/// Pixels that show another object.
std::uint64_t otherIds(const measure::SeenImage& seen, const measure::SeenImage& whole) {
    std::uint64_t others = 0;
    for (std::size_t i = 0; i < seen.pixels.size(); ++i) {
        others += seen.pixels[i].id != whole.pixels[i].id ? 1 : 0;
    }
    return others;
}

image::ImageRgba8 markCracks(image::ImageRgba8 picture, const std::vector<measure::Crack>& cracks) {
    constexpr std::uint32_t kAround = 3;
    for (const measure::Crack& crack : cracks) {
        for (std::uint32_t y = crack.y - std::min(crack.y, kAround);
             y <= std::min(crack.y + kAround, picture.height - 1); ++y) {
            for (std::uint32_t x = crack.x - std::min(crack.x, kAround);
                 x <= std::min(crack.x + kAround, picture.width - 1); ++x) {
                picture.at(x, y) = {255, 0, 0, 255};
            }
        }
    }
    return picture;
}

/// What one mode showed of one frame, beside what none showed.
struct Shown {
    double flip = 0.0;
    std::uint64_t pixels = 0;
    std::uint64_t otherIds = 0;
    std::uint64_t cracks = 0;
    std::uint64_t triangles = 0;
};

/// A renderer per mode over one scene with levels, and what each showed and took so far.
class DetailComparison {
  public:
    DetailComparison(const gpu::Device& device, scene::SceneSetup setup, const DetailOptions& options)
        : m_options(options),
          m_workers(options.drawing.threads),
          m_setup(std::move(setup)),
          m_makeMs(makeLevels()),
          m_gpuScene(device, m_setup.scene),
          m_frames(kDetailModes.size(), options.seed),
          m_results(kDetailModes.size()) {
        render::RenderOptions drawing = options.drawing;
        for (const ComparedMode& mode : kDetailModes) {
            drawing.detail.mode = mode.mode;
            m_renderers.push_back(
                std::make_unique<render::Renderer>(device, m_setup.scene, m_gpuScene, drawing));
        }
    }

    /// Each mode draws all frames: on the first rank, while the others wait and disturb nothing.
    void time(ranks::Ranks& ranks, const std::function<void()>& step) {
        if (!ranks.isFirst()) {
            skipTimed();
        }
        ranks.share({});
        bool isTimed = false;
        runs::forEachUnit(
            ranks, 1,
            [&](std::size_t) {
                isTimed = true;
                m_frames.runAlone(m_options.frames, step, [&](std::size_t mode, std::uint32_t frame) {
                    return m_renderers[mode]->draw(cameraOf(frame));
                });
                return m_frames.packedSamples();
            },
            [&](std::size_t, const output::Json& made) { m_frames.takeSamples(made, m_options.frames); },
            &ranks::Ranks::forEachUnitOnFirst);
        if (ranks.isFirst() && !isTimed) {
            skipTimed();
        }
    }

    /// What all modes show of a frame; of the first one pictures too. Frames come in ascending order.
    output::Json compare(std::uint32_t frame) {
        for (; m_next < frame; ++m_next) {
            for (const auto& renderer : m_renderers) {
                renderer->skip(cameraOf(m_next));
            }
        }
        ++m_next;
        const scene::Camera camera = cameraOf(frame);
        const render::Frame whole = m_renderers.front()->render(camera);
        const measure::SeenImage wholeSeen = seenIn(whole);
        std::vector<Shown> all;
        output::Json made{{"pictures", output::Json::array()}};
        for (std::size_t mode = 0; mode < kDetailModes.size(); ++mode) {
            const render::Frame shown = mode == 0 ? whole : m_renderers[mode]->render(camera);
            const measure::SeenImage seen = seenIn(shown);
            const std::vector<measure::Crack> cracks = measure::findCracks(seen, wholeSeen);
            all.push_back({.flip = m_flip.mean(whole.color, shown.color, m_workers),
                           .pixels = seen.pixels.size(),
                           .otherIds = otherIds(seen, wholeSeen),
                           .cracks = cracks.size(),
                           .triangles = trianglesOf(shown, kDetailModes[mode].mode)});
            if (frame == 0) {
                made["pictures"].push_back(
                    {runs::packedPicture(shown.color), runs::packedPicture(markCracks(shown.color, cracks))});
            }
        }
        made["shown"] = runs::packed(all);
        return made;
    }

    /// Adds what compare() made.
    void add(const output::Json& made) {
        const std::vector<Shown> all = runs::unpacked<Shown>(made.at("shown"), kDetailModes.size());
        for (std::size_t mode = 0; mode < kDetailModes.size(); ++mode) {
            DetailResult& result = m_results[mode];
            const Shown& shown = all[mode];
            result.flip += shown.flip / m_options.frames;
            result.largestFlip = std::max(result.largestFlip, shown.flip);
            result.pixels += shown.pixels;
            result.otherIds += shown.otherIds;
            result.cracks += shown.cracks;
            result.triangles += static_cast<double>(shown.triangles) / m_options.frames;
        }
        for (std::size_t mode = 0; mode < made.at("pictures").size(); ++mode) {
            m_results.at(mode).picture = runs::unpackedPicture(made["pictures"][mode].at(0));
            m_results[mode].cracked = runs::unpackedPicture(made["pictures"][mode].at(1));
        }
    }

    DetailReport report() {
        DetailReport report{.makeMs = m_makeMs, .results = m_results};
        const scene::Scene& scene = m_setup.scene;
        for (const std::uint32_t mesh : scene.instances.mesh) {
            report.sceneTriangles += scene.meshes[mesh].indices.size() / 3;
        }
        for (const scene::Mesh& mesh : scene.meshes) {
            report.meshLevels += mesh.levels.size();
            report.clusters += mesh.clusters.clusters.size();
        }
        for (std::size_t mode = 0; mode < kDetailModes.size(); ++mode) {
            summarise(mode, report.results[mode]);
        }
        return report;
    }

  private:
    /// A fitted split keeps to the frames before, those that were timed elsewhere among them.
    void skipTimed() {
        for (const auto& renderer : m_renderers) {
            for (std::uint32_t i = 0; i < runs::InterleavedFrames::kWarmUp + m_options.frames; ++i) {
                const std::uint32_t frame =
                    i < runs::InterleavedFrames::kWarmUp ? i : i - runs::InterleavedFrames::kWarmUp;
                renderer->skip(cameraOf(frame % m_options.frames));
            }
        }
    }

    double makeLevels() {
        const platform::Stopwatch watch;
        scene::makeLevels(m_setup.scene, m_workers); // of large meshes too, for the modes without clusters
        scene::makeClusters(m_setup.scene, m_workers);
        return watch.milliseconds();
    }

    scene::Camera cameraOf(std::uint32_t frame) const {
        const std::uint64_t length = m_setup.path.frames;
        return m_setup.path.at(static_cast<std::uint32_t>(frame * length / m_options.frames));
    }

    /// Counted by the very functions that the frame was drawn with.
    std::uint64_t trianglesOf(const render::Frame& frame, visibility::DetailMode mode) {
        const scene::Frustum frustum =
            scene::frustumOf(frame.camera, m_options.drawing.width, m_options.drawing.height);
        visibility::cullCells(m_gpuScene.uploaded().cells(m_workers), frame.camera, frustum, m_workers,
                              m_visible);
        depth::Cascades ranges;
        for (std::size_t i = 0; i < frame.cascades.size(); ++i) {
            ranges.push_back(depth::clipRange(m_options.drawing.technique.mapping, frame.cascades, i));
        }
        constexpr double kNoneWide = std::numeric_limits<double>::infinity();
        m_binner.bin(m_visible, ranges, kNoneWide, m_workers, m_lists);
        const visibility::Detail detail{.mode = mode, .pixels = m_options.drawing.detail.pixels};
        visibility::chooseDetail(m_setup.scene,
                                 {.camera = frame.camera,
                                  .frustum = frustum,
                                  .clipRanges = ranges,
                                  .wideSpan = kNoneWide,
                                  .levels = visibility::levelRule(detail, frustum)},
                                 m_workers, m_lists);
        return visibility::trianglesDrawn(m_setup.scene, m_lists);
    }

    void summarise(std::size_t mode, DetailResult& result) const {
        const std::vector<double> ratios = m_frames.ratios(0, mode, &runs::FrameSample::executeMs);
        result.mode = kDetailModes[mode].name;
        result.frameMs = m_frames.median(mode, &runs::FrameSample::frameMs);
        result.recordMs = m_frames.median(mode, &runs::FrameSample::recordMs);
        result.executeMs = m_frames.median(mode, &runs::FrameSample::executeMs);
        result.speedup = measure::median(ratios);
        result.speedup95 = measure::bootstrapMedian(ratios, m_options.seed + mode);
    }

    const DetailOptions& m_options;
    platform::WorkerPool m_workers;
    scene::SceneSetup m_setup;
    double m_makeMs;
    render::GpuScene m_gpuScene;
    std::vector<std::unique_ptr<render::Renderer>> m_renderers; ///< by mode
    runs::InterleavedFrames m_frames;
    std::vector<DetailResult> m_results;
    std::uint32_t m_next = 0; ///< frame that comes after those compared or skipped
    measure::FlipDifference m_flip;
    visibility::VisibleCells m_visible;
    visibility::CellBinner m_binner;
    visibility::DrawLists m_lists;
};

} // namespace

std::vector<std::string> detailModeNames() {
    std::vector<std::string> names;
    for (const ComparedMode& mode : kDetailModes) {
        names.emplace_back(mode.name);
    }
    return names;
}

DetailReport runDetail(const gpu::Device& device, scene::SceneSetup setup, const DetailOptions& options,
                       const Progress& progress, ranks::Ranks& ranks) {
    if (options.frames < 1) {
        throw base::InputError("detail needs a frame");
    }
    const std::size_t timed = std::size_t{runs::InterleavedFrames::kWarmUp} + options.frames;
    const std::size_t all = timed + options.frames;
    std::size_t done = 0;
    DetailComparison comparison(device, std::move(setup), options);
    comparison.time(ranks, [&] { progress(done++, all); });
    runs::forEachUnit(
        ranks, options.frames,
        [&](std::size_t unit) {
            progress(timed + unit, all);
            return comparison.compare(static_cast<std::uint32_t>(unit));
        },
        [&](std::size_t, const output::Json& made) { comparison.add(made); });
    return ranks.isFirst() ? comparison.report() : DetailReport();
}

} // namespace cdr::experiments
