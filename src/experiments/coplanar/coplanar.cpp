#include "coplanar.h"

#include <cdr/base/enum_names.h>
#include <cdr/base/error.h>
#include <cdr/measure/compare/flips.h>
#include <cdr/measure/compare/wrong_pixels.h>
#include <cdr/measure/truth/object_ray.h>
#include <cdr/platform/host_memory.h>
#include <cdr/render/renderer.h>
#include <scenes/coplanar.h>

#include <fmt/format.h>
#include <runs/units.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

namespace cdr::experiments {

namespace {

constexpr render::LayerOptions kNoOffset{.method = render::LayerMethod::polygonOffset};

constexpr base::EnumNames<CoplanarMethod, kCoplanarMethods.size()> kCoplanarMethodNames{
    "method", {"none", "polygon offset", "layers"}};

/// A view, and one from a little aside.
std::array<scene::Camera, 2> viewPair(std::uint64_t seed, std::uint32_t view) {
    const scene::Camera first = scenes::coplanarView(seed, view);
    scene::Camera second = first;
    second.position += 0.01 * first.right;
    return {first, second};
}

/// One technique and method in a pair of views.
struct PairCount {
    std::array<std::uint64_t, 2> pixels{};
    std::array<std::uint64_t, 2> wrong{}; ///< coverage differences left out
    std::array<std::uint64_t, 2> coverage{};
    std::array<std::uint64_t, 2> through{};
    std::uint64_t flips = 0;
    std::uint64_t coverageFlips = 0;
};

class CoplanarComparison {
  public:
    CoplanarComparison(const gpu::Device& device, const CoplanarOptions& options)
        : m_device(device),
          m_options(options),
          m_workers(options.drawing.threads),
          m_setup(scenes::makeCoplanar()),
          m_gpuScene(device, m_setup.scene),
          m_truth(m_setup.scene, m_workers),
          m_subPixelBits(device.info().subPixelBits) {
        if (options.drawing.snapBits > 0) {
            m_subPixelBits = std::min(m_subPixelBits, options.drawing.snapBits);
        }
        const auto& names = m_setup.scene.objectNames;
        m_hiddenId = static_cast<std::uint32_t>(std::ranges::find(names, "hidden sign") - names.begin()) + 1;
    }

    /// The setting with the fewest wrong pixels, over a few views.
    render::LayerOptions bestOffset(const depth::Technique& technique) {
        std::pair<std::uint64_t, render::LayerOptions> best{UINT64_MAX, {}};
        for (const float slope : m_options.offsets.slopes) {
            for (const float constant : m_options.offsets.constants) {
                const render::LayerOptions layers{render::LayerMethod::polygonOffset, slope, constant};
                const std::uint64_t wrong = wrongOver(technique, layers);
                if (wrong < best.first) {
                    best = {wrong, layers};
                }
            }
        }
        return best.second;
    }

    void add(const depth::NamedTechnique& named, CoplanarMethod method, const render::LayerOptions& layers) {
        m_results.push_back({.technique = named.name, .method = method, .layers = layers});
        m_renderers.push_back(makeRenderer(named.technique, layers));
        m_worst.push_back(0);
        m_shownWrong.push_back(0);
    }

    /// All techniques and methods in a pair of views, and heat maps that may be the worst one's. Views come in ascending
    /// order, and fitted splits remember those that other ranks look from.
    output::Json compare(std::uint32_t view) {
        for (; m_next < view; ++m_next) {
            for (const scene::Camera& camera : viewPair(m_options.seed + 1, m_next)) {
                for (const auto& renderer : m_renderers) {
                    renderer->skip(camera);
                }
            }
        }
        ++m_next;
        const std::array cameras = viewPair(m_options.seed + 1, view);
        const std::array truths{truthOf(cameras[0]), truthOf(cameras[1])};
        const std::array inner{measure::innerMask(truths[0]), measure::innerMask(truths[1])};
        const auto steady = measure::steadyMask(truths[0], inner[0], truths[1], inner[1]);
        std::vector<PairCount> counts(m_results.size());
        output::Json pictures = output::Json::array();
        for (std::size_t i = 0; i < m_results.size(); ++i) {
            std::array<image::ImageU32, 2> ids;
            image::Raster<std::uint8_t> steadyCovered = steady;
            for (std::size_t eye = 0; eye < cameras.size(); ++eye) {
                const render::Frame frame = m_renderers[i]->render(cameras[eye]);
                ids[eye] = frame.ids();
                count(frame, ids[eye], truths[eye], inner[eye], eye, counts[i], steadyCovered);
                if (counts[i].wrong[eye] > m_worst[i]) {
                    m_worst[i] = counts[i].wrong[eye];
                    pictures.push_back({{"result", i},
                                        {"wrong", m_worst[i]},
                                        {"picture", runs::packedPicture(measure::heatMap(
                                                        ids[eye], truths[eye], frame.color))}});
                }
            }
            counts[i].flips = measure::countFlips(ids[0], ids[1], steady).flips;
            counts[i].coverageFlips =
                counts[i].flips - measure::countFlips(ids[0], ids[1], steadyCovered).flips;
        }
        return {{"counts", runs::packed(counts)}, {"pictures", std::move(pictures)}};
    }

    /// Adds what compare() made on some rank.
    void take(const output::Json& made) {
        const std::vector<PairCount> counts = runs::unpacked<PairCount>(made.at("counts"), m_results.size());
        for (std::size_t i = 0; i < counts.size(); ++i) {
            CoplanarResult& result = m_results[i];
            for (std::size_t eye = 0; eye < 2; ++eye) {
                result.pixels += counts[i].pixels[eye];
                result.wrong += counts[i].wrong[eye];
                result.coverage += counts[i].coverage[eye];
                result.through += counts[i].through[eye];
                result.wrongViews += counts[i].wrong[eye] > 0 ? 1 : 0;
            }
            result.flips += counts[i].flips;
            result.coverageFlips += counts[i].coverageFlips;
        }
        for (const output::Json& picture : made.at("pictures")) {
            const auto i = picture.at("result").get<std::size_t>();
            if (const auto wrong = picture.at("wrong").get<std::uint64_t>(); wrong > m_shownWrong.at(i)) {
                m_shownWrong[i] = wrong;
                m_results[i].picture = runs::unpackedPicture(picture.at("picture"));
            }
        }
    }

    std::vector<CoplanarResult> results() && { return std::move(m_results); }

  private:
    measure::TruthImage truthOf(const scene::Camera& camera) {
        return m_truth.cast(camera, m_options.drawing.width, m_options.drawing.height, m_workers);
    }

    std::unique_ptr<render::Renderer> makeRenderer(const depth::Technique& technique,
                                                   const render::LayerOptions& layers) {
        render::RenderOptions drawing = m_options.drawing;
        drawing.technique = technique;
        drawing.layers = layers;
        return std::make_unique<render::Renderer>(m_device, m_setup.scene, m_gpuScene, drawing);
    }

    std::uint64_t wrongOver(const depth::Technique& technique, const render::LayerOptions& layers) {
        const std::unique_ptr<render::Renderer> renderer = makeRenderer(technique, layers);
        std::uint64_t wrong = 0;
        for (std::uint32_t view = 0; view < m_options.searchViews; ++view) {
            const scene::Camera camera = scenes::coplanarView(m_options.seed, view);
            if (view == m_searchTruths.size()) {
                m_searchTruths.push_back(truthOf(camera));
            }
            wrong += measure::countWrong(renderer->render(camera).ids(), m_searchTruths[view]).wrong;
        }
        return wrong;
    }

    /// Whether an object that the truth does not show at a pixel's centre is so near to it that rounded vertices cover it.
    /// @param ray through the centre. @param footprintSlope of the view's pixels.
    bool isCovering(const scene::Camera& camera, const glm::dvec3& ray, double footprintSlope,
                    std::uint32_t id) {
        scene::Camera narrow = scene::lookAlong(camera, camera.position, ray);
        narrow.fovY = 8.0 * footprintSlope * std::exp2(-static_cast<double>(m_subPixelBits));
        const measure::TruthImage around = m_truth.cast(narrow, 5, 5, m_workers);
        return std::any_of(around.pixels.begin(), around.pixels.end(),
                           [&](const measure::TruthPixel& seen) { return seen.id == id; });
    }

    /// @param steady loses the pixels that are coverage differences.
    void count(const render::Frame& frame, const image::ImageU32& ids, const measure::TruthImage& truth,
               const image::Raster<std::uint8_t>& inner, std::size_t eye, PairCount& counted,
               image::Raster<std::uint8_t>& steady) {
        const measure::WrongPixels wrong = measure::countWrong(ids, truth, inner);
        counted.pixels[eye] = wrong.pixels;
        const scene::Camera& camera = frame.camera;
        const measure::PixelSlopes slopes = measure::pixelSlopes(camera, ids.width, ids.height);
        const double footprintSlope = scene::frustumOf(camera, ids.width, ids.height).footprintSlope;
        for (std::uint32_t y = 0; y < ids.height; ++y) {
            for (std::uint32_t x = 0; x < ids.width; ++x) {
                const measure::TruthPixel& seen = truth.at(x, y);
                const std::uint32_t id = ids.at(x, y);
                if (inner.at(x, y) == 0 || id == seen.id) {
                    continue;
                }
                counted.through[eye] += id == m_hiddenId ? 1 : 0;
                const glm::dvec3 ray = -camera.back + slopes.x[x] * camera.right + slopes.y[y] * camera.up;
                if (id != seen.secondId && isCovering(camera, ray, footprintSlope, id)) {
                    ++counted.coverage[eye];
                    steady.at(x, y) = 0;
                }
            }
        }
        counted.wrong[eye] = wrong.wrong - counted.coverage[eye];
    }

    const gpu::Device& m_device;
    const CoplanarOptions& m_options;
    platform::WorkerPool m_workers;
    scene::SceneSetup m_setup;
    render::GpuScene m_gpuScene;
    measure::TruthCaster m_truth;
    std::uint32_t m_subPixelBits;
    std::uint32_t m_hiddenId = 0;
    std::vector<measure::TruthImage> m_searchTruths;
    std::vector<std::unique_ptr<render::Renderer>> m_renderers; ///< by result
    std::vector<std::uint64_t> m_worst;      ///< wrong pixels of a view of this rank, by result
    std::vector<std::uint64_t> m_shownWrong; ///< of the view that a result's picture is of
    std::uint32_t m_next = 0;                ///< pair that comes after those done or skipped
    std::vector<CoplanarResult> m_results;
};

} // namespace

std::string_view nameOf(CoplanarMethod method) {
    return kCoplanarMethodNames.nameOf(method);
}

std::vector<CoplanarResult> runCoplanar(const gpu::Device& device, const CoplanarOptions& options,
                                        const Progress& progress, ranks::Ranks& ranks) {
    if (options.views < 1 || options.searchViews < 1) {
        throw base::InputError("coplanar needs a view to measure and a view to search settings by");
    }
    if (options.offsets.slopes.empty() || options.offsets.constants.empty()) {
        throw base::InputError("coplanar needs a setting of polygon offset");
    }
    platform::requireHostBytes(
        platform::saturatingProduct({options.drawing.width, options.drawing.height, options.searchViews,
                                     sizeof(measure::TruthPixel)}),
        fmt::format("the truth of {} views to search settings by", options.searchViews));
    const std::vector<depth::NamedTechnique>& techniques = options.techniques;
    const std::size_t all = techniques.size() + options.views;
    CoplanarComparison comparison(device, options);
    std::vector<render::LayerOptions> offsets;
    runs::forEachUnit(
        ranks, techniques.size(),
        [&](std::size_t unit) {
            progress(unit, all);
            return runs::packed(std::vector{comparison.bestOffset(techniques[unit].technique)});
        },
        [&](std::size_t, const output::Json& best) {
            offsets.push_back(runs::unpacked<render::LayerOptions>(best, 1)[0]);
        });
    offsets = runs::sharedOf(ranks, offsets);
    for (std::size_t i = 0; i < techniques.size(); ++i) {
        comparison.add(techniques[i], CoplanarMethod::none, kNoOffset);
        comparison.add(techniques[i], CoplanarMethod::polygonOffset, offsets[i]);
        comparison.add(techniques[i], CoplanarMethod::layers, {});
    }
    runs::forEachUnit(
        ranks, options.views,
        [&](std::size_t unit) {
            progress(techniques.size() + unit, all);
            return comparison.compare(static_cast<std::uint32_t>(unit));
        },
        [&](std::size_t, const output::Json& made) { comparison.take(made); });
    return std::move(comparison).results();
}

} // namespace cdr::experiments
