#include "inspect.h"

#include <cdr/depth/advice.h>
#include <cdr/depth/forecast.h>
#include <cdr/measure/truth/object_ray.h>
#include <cdr/measure/truth/truth.h>
#include <cdr/platform/worker_pool.h>
#include <cdr/render/gpu_scene.h>
#include <cdr/render/renderer.h>
#include <cdr/render/renderer_setup.h>

#include <algorithm>
#include <cmath>

namespace cdr::experiments {

namespace {

/// Views whose truth is kept at once.
constexpr std::size_t kViewsAtOnce = 4;

/// The tails of the chances, and single pixels.
constexpr double kNearlyNone = 1e-4;
/// A chance that no picture has enough pixels for.
constexpr double kNearlyNever = 1e-9;

constexpr image::Rgba8 kCoplanar{255, 0, 255, 255};

/// A view with what every technique is compared with.
struct InspectedView {
    scene::Camera camera;
    measure::TruthImage truth;
    image::Raster<std::uint8_t> coplanar;
    image::ImageU32 blended;                  ///< PairCollector::blendedInPlane()
    image::Raster<std::uint8_t> judgedPixels; ///< off edges, and not in plane

    /// Whether two surfaces of a pixel lie in one plane, blended ones too.
    bool isInPlane(std::size_t i) const { return coplanar.pixels[i] != 0 || blended.pixels[i] != 0; }
    std::uint64_t inPlane() const {
        std::uint64_t count = 0;
        for (std::size_t i = 0; i < coplanar.pixels.size(); ++i) {
            count += isInPlane(i) ? 1 : 0;
        }
        return count;
    }
};

/// Simplest first, unless they are given.
std::vector<InspectedTechnique> techniquesOf(const gpu::Device& device, const InspectOptions& options) {
    std::vector<depth::NamedTechnique> named = options.techniques;
    if (named.empty()) {
        for (const char* name : depth::kSimplestFirst) {
            named.push_back(depth::namedTechnique(name));
        }
    }
    std::vector<InspectedTechnique> techniques;
    for (const depth::NamedTechnique& each : named) {
        for (const depth::DepthFormat format : device.info().depthFormats) {
            techniques.push_back({.name = each.name, .technique = each.technique});
            techniques.back().technique.format = format;
        }
    }
    const auto judged = std::ranges::find_if(techniques, [&](const InspectedTechnique& each) {
        return each.technique == options.judged.technique;
    });
    if (judged != techniques.end()) {
        judged->isJudged = true;
    } else {
        techniques.push_back(
            {.name = options.judged.name, .technique = options.judged.technique, .isJudged = true});
    }
    return techniques;
}

InspectedView viewOf(const measure::TruthCaster& caster, const PairCollector& pairs,
                     const scene::Camera& camera, const InspectOptions& options,
                     platform::WorkerPool& workers) {
    InspectedView view{.camera = camera,
                       .truth = caster.cast(camera, options.drawing.width, options.drawing.height, workers),
                       .coplanar = {},
                       .blended = {},
                       .judgedPixels = {}};
    view.coplanar = pairs.coplanarMask(view.camera, view.truth);
    view.blended = pairs.blendedInPlane(view.camera, view.truth, caster.shapes(), workers);
    view.judgedPixels = measure::innerMask(view.truth);
    for (std::size_t i = 0; i < view.judgedPixels.pixels.size(); ++i) {
        view.judgedPixels.pixels[i] = view.isInPlane(i) ? std::uint8_t{0} : view.judgedPixels.pixels[i];
    }
    return view;
}

/// How fast the distance of what a pixel shows changes over the picture, scene units per pixel.
double changeViewAt(const measure::TruthImage& truth, std::size_t i) {
    const auto along = [&](std::size_t place, std::size_t count, std::size_t step) {
        double most = 0.0;
        for (const std::size_t other : {place > 0 ? i - step : i, place + 1 < count ? i + step : i}) {
            const measure::TruthPixel& pixel = truth.pixels[other];
            if (pixel.id == truth.pixels[i].id) {
                most = std::max(most, std::abs(pixel.distanceView - truth.pixels[i].distanceView));
            }
        }
        return most;
    };
    return std::hypot(along(i % truth.width, truth.width, 1),
                      along(i / truth.width, truth.height, truth.width));
}

/// forecastIn(), with what rounding vertices to sub-pixels does to the surface of a pixel.
/// @param bits nothing: vertices are not rounded, or move in the surface's plane
std::optional<depth::Forecast> forecastAt(const InspectedView& view, std::size_t i,
                                          const depth::Technique& technique, const depth::Cascades& cascades,
                                          std::optional<unsigned> bits) {
    auto forecast = depth::forecastIn(technique, cascades, view.truth.pixels[i].distanceView);
    if (forecast && bits) {
        forecast->rounding.snapGapView = depth::snapGapView(*bits, changeViewAt(view.truth, i), 1.0);
    }
    return forecast;
}

/// Predictions count the rounding of vertices where it is asked for. Else the device may not do it.
void predict(const InspectedView& view, const depth::Cascades& cascades, std::optional<unsigned> bits,
             InspectedTechnique& technique) {
    for (std::size_t i = 0; i < view.truth.pixels.size(); ++i) {
        const measure::TruthPixel& pixel = view.truth.pixels[i];
        if (view.judgedPixels.pixels[i] != 0 && pixel.secondId != 0) {
            const OrderChance chance =
                orderChance(forecastAt(view, i, technique.technique, cascades, bits), pixel.gapView(),
                            pixel.secondId > pixel.id ? DrawnLater::farther : DrawnLater::nearer);
            technique.undecided += chance.undecided;
            technique.predictedWrong += chance.wrong;
        }
    }
}

bool isRemedy(const InspectedTechnique& technique) {
    return technique.isJudged || technique.technique == depth::parseTechnique("reversed") ||
           technique.technique == depth::parseTechnique("anchored");
}

void separate(const InspectedView& view, const PairCollector& pairs, const depth::Cascades& cascades,
              std::optional<unsigned> bits, InspectedTechnique& technique) {
    const measure::PixelSlopes slopes =
        measure::pixelSlopes(view.camera, view.truth.width, view.truth.height);
    for (std::size_t i = 0; i < view.truth.pixels.size(); ++i) {
        const measure::TruthPixel& pixel = view.truth.pixels[i];
        const auto forecast =
            view.isInPlane(i) ? forecastAt(view, i, technique.technique, cascades, bits) : std::nullopt;
        if (!forecast) {
            continue;
        }
        const glm::dvec3 ray = view.camera.right * slopes.x[i % view.truth.width] +
                               view.camera.up * slopes.y[i / view.truth.width] - view.camera.back;
        const auto add = [&](std::uint32_t other) {
            const auto [first, second] = std::minmax({pixel.id - 1, other - 1});
            const double rounding = pairs.roundingViewAt(first, second, pixel.distanceView, ray, view.camera);
            double& apart = technique.apart[{first, second}];
            // A face that faces the ray moves along it: less along the view, whose length the ray exceeds.
            apart = std::max(apart, (forecast->guaranteedView() + rounding) * glm::length(ray));
        };
        if (view.coplanar.pixels[i] != 0) {
            add(pixel.secondId);
        }
        if (view.blended.pixels[i] != 0) {
            add(view.blended.pixels[i]);
        }
    }
}

image::ImageRgba8 heatMapOf(const InspectedView& view, const render::Frame& frame) {
    image::ImageRgba8 picture = measure::heatMap(frame.ids(), view.truth, frame.color);
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        picture.pixels[i] = view.isInPlane(i) ? kCoplanar : picture.pixels[i];
    }
    return picture;
}

/// Renders some views with one technique. Keeps the heat map of the worst view so far.
class TechniqueRun {
  public:
    TechniqueRun(const gpu::Device& device, const scene::Scene& scene, const render::GpuScene& onDevice,
                 const render::RenderOptions& options, InspectedTechnique& result)
        : m_renderer(device, scene, onDevice, options),
          m_isSnapped(options.snapBits > 0),
          m_result(result) {
        if (options.snapping == render::Snapping::byDevice) {
            m_subPixelBits = render::subPixelBits(device, options);
        }
    }

    void add(const InspectedView& view, const PairCollector& pairs, std::uint64_t& worst,
             image::ImageRgba8& heatMap) {
        m_renderer.forgetFrames();
        const render::Frame frame = m_renderer.render(view.camera);
        const measure::WrongPixels wrong = measure::countWrong(frame.ids(), view.truth, view.judgedPixels);
        m_result.wrong += wrong;
        predict(view, frame.cascades, m_isSnapped ? m_subPixelBits : std::nullopt, m_result);
        if (isRemedy(m_result)) {
            separate(view, pairs, frame.cascades, m_subPixelBits, m_result);
        }
        m_result.cascades = std::max(m_result.cascades, frame.cascades.size());
        const std::uint64_t bad = wrong.wrong + view.inPlane();
        if (m_result.isJudged && (bad > worst || heatMap.pixels.empty())) {
            worst = bad;
            heatMap = heatMapOf(view, frame);
        }
    }

  private:
    render::Renderer m_renderer;
    std::optional<unsigned> m_subPixelBits; ///< nothing: vertices move in the planes of surfaces
    bool m_isSnapped;                       ///< for sure, whatever the device does
    InspectedTechnique& m_result;
};

} // namespace

OrderChance orderChance(const std::optional<depth::Forecast>& forecast, double gapView,
                        DrawnLater drawnLater) {
    const double later = drawnLater == DrawnLater::farther ? 1.0 : 0.0;
    if (!forecast || !std::isfinite(forecast->bufferStepView)) {
        return {.undecided = 1.0, .wrong = later};
    }
    // Two surfaces, each rounded to the buffer's steps and by float32.
    const double stepVariance = forecast->bufferStepView * forecast->bufferStepView / 6.0;
    const double rounding = forecast->rounding.deviationView();
    const double variance = stepVariance + 2.0 * rounding * rounding;
    if (!(variance > 0.0)) {
        return gapView > 0.0 ? OrderChance{} : OrderChance{.undecided = 1.0, .wrong = later};
    }
    const double undecided = std::erfc(gapView / std::sqrt(2.0 * variance));
    if (undecided < kNearlyNever) {
        return {};
    }
    const double tied = stepVariance / variance; // share of it: the buffer stores one number for both
    return {.undecided = undecided, .wrong = undecided * (tied * later + (1.0 - tied) * 0.5)};
}

Inspection runInspect(const gpu::Device& device, const scene::Scene& scene,
                      const std::vector<scene::Camera>& cameras, const InspectOptions& options,
                      const NamedProgress& progress) {
    Inspection inspection{.pairs = {}, .techniques = techniquesOf(device, options), .heatMap = {}};
    std::vector<InspectedTechnique>& techniques = inspection.techniques;
    const render::GpuScene onDevice(device, scene);
    render::RenderOptions drawing = options.drawing;
    platform::WorkerPool workers(options.drawing.threads);
    const measure::TruthCaster caster(scene, workers);
    PairCollector pairs(scene);
    std::uint64_t worst = 0;
    const std::size_t all = cameras.size() * (techniques.size() + 1);
    for (std::size_t first = 0, done = 0; first < cameras.size(); first += kViewsAtOnce) {
        std::vector<InspectedView> views;
        for (std::size_t i = first; i < std::min(first + kViewsAtOnce, cameras.size()); ++i) {
            progress(done++, all, "truth");
            views.push_back(viewOf(caster, pairs, cameras[i], options, workers));
            pairs.add(views.back().camera, views.back().truth, views.back().blended);
            inspection.objectPixels += static_cast<std::uint64_t>(std::ranges::count_if(
                views.back().truth.pixels, [](const measure::TruthPixel& pixel) { return pixel.id != 0; }));
            inspection.coplanarPixels += views.back().inPlane();
        }
        for (InspectedTechnique& technique : techniques) {
            drawing.technique = technique.technique;
            TechniqueRun run(device, scene, onDevice, drawing, technique);
            for (const InspectedView& view : views) {
                progress(done++, all, technique.name);
                run.add(view, pairs, worst, inspection.heatMap);
            }
        }
    }
    inspection.allowedShare = options.allowedShare;
    inspection.pairs = pairs.pairs();
    const auto isJudged = [](const InspectedTechnique& each) { return each.isJudged; };
    inspection.judged = static_cast<std::size_t>(
        std::find_if(techniques.begin(), techniques.end(), isJudged) - techniques.begin());
    const auto suffices = std::ranges::find_if(techniques, [&](const InspectedTechnique& each) {
        return each.wrong.pixels > 0 && inspection.wrongFraction(each) <= options.allowedShare &&
               inspection.undecidedFraction(each) <= std::max(options.allowedShare, kNearlyNone);
    });
    if (suffices != techniques.end()) {
        inspection.simplest = static_cast<std::size_t>(suffices - techniques.begin());
    }
    return inspection;
}

} // namespace cdr::experiments
