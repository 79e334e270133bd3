#include <cdr/base/error.h>
#include <cdr/image/same_size.h>
#include <cdr/measure/shadows/shadow_truth.h>
#include <cdr/measure/truth/layered_truth.h>
#include <cdr/measure/truth/surface_hit.h>
#include <cdr/measure/truth/truth_air.h>
#include <cdr/measure/truth/truth_light.h>
#include <cdr/platform/host_memory.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>
#include <tuple>
#include <vector>

namespace cdr::measure {

namespace {

/// A surface as neighbouring pixels compare it.
struct Face {
    std::uint32_t id;
    glm::dvec3 facet;
    glm::dvec4 reached; ///< LitSurface::reached

    bool isSameAs(const Face& other) const {
        return id == other.id && reached == other.reached && glm::dot(facet, other.facet) > 1.0 - 1e-9;
    }
};

/// The faces that a pixel shows, nearest first.
using Sequence = std::vector<Face>;

/// Where rays start and what they may meet.
struct View {
    const scene::Scene& scene;
    const scene::Camera& camera;
    std::vector<VisibleInstance> instances;
    PixelSlopes slopes;
    const TruthTextures& textures;
    const ShadowTruthCaster* shadows; ///< null: lights reach everything
};

View viewOf(const scene::Scene& scene, std::span<const Shape> shapes, const scene::Camera& camera,
            const glm::uvec2& size, const TruthTextures& textures,
            const std::optional<ShadowTruthCaster>& shadows, platform::WorkerPool& workers) {
    return {.scene = scene,
            .camera = camera,
            .instances = visibleInstances(scene, shapes, camera, size.x, size.y, workers),
            .slopes = pixelSlopes(camera, size.x, size.y),
            .textures = textures,
            .shadows = shadows ? &*shadows : nullptr};
}

/// All that a pixel's ray meets up to the first opaque surface, nearest first.
std::vector<SurfaceHit> hitsAt(const View& view, std::uint32_t x, std::uint32_t y) {
    std::vector<SurfaceHit> hits;
    for (const VisibleInstance& instance : view.instances) {
        if (instance.pixels.contains(x, y)) {
            appendHits(view.scene, view.textures, instance,
                       {view.slopes.x[x], view.slopes.y[y], view.slopes.step},
                       {view.camera.nearView, view.camera.farView}, hits);
        }
    }
    // At one distance a translucent surface lies on the opaque one, not below it.
    std::sort(hits.begin(), hits.end(), [](const SurfaceHit& a, const SurfaceHit& b) {
        const auto order = [](const SurfaceHit& hit) {
            // Of opaque ones the last in the scene's order shows.
            return std::make_tuple(hit.distanceView - hit.layer, !hit.isBlended,
                                   hit.isBlended ? hit.instance : ~hit.instance);
        };
        return order(a) < order(b);
    });
    const auto end = std::ranges::find_if(hits, [](const SurfaceHit& hit) { return !hit.isBlended; });
    if (end != hits.end()) {
        hits.erase(end + 1, hits.end());
    }
    return hits;
}

/// LitSurface::reached.
glm::dvec4 reachedAt(const View& view, const SurfaceHit& hit, const glm::dvec3& fromCamera) {
    return view.shadows == nullptr || hit.isUnlit
               ? glm::dvec4(1.0)
               : view.shadows->sharesAt(view.camera.position, fromCamera, hit.normal);
}

/// Pixel (x, y) as `pixel` and what it shows as `sequence`.
void castPixel(const View& view, std::uint32_t x, std::uint32_t y, LayeredPixel& pixel, Sequence& sequence) {
    pixel = {};
    sequence.clear();
    double transmittance = 1.0;
    const scene::Camera& camera = view.camera;
    const glm::dvec3 ray = -camera.back + view.slopes.x[x] * camera.right + view.slopes.y[y] * camera.up;
    for (const SurfaceHit& hit : hitsAt(view, x, y)) {
        const double alpha = hit.isBlended ? std::clamp(hit.baseColor.a, 0.0, 1.0) : 1.0;
        const glm::dvec3 fromCamera = hit.distanceView * ray;
        const glm::dvec4 reached = reachedAt(view, hit, fromCamera);
        pixel.color += transmittance * alpha *
                       throughAir(view.scene, camera.position, fromCamera,
                                  lightFrom(view.scene, camera, hit, fromCamera, reached));
        transmittance *= 1.0 - alpha;
        pixel.fragments += hit.isBlended ? 1 : 0;
        sequence.push_back({hit.id, hit.facet, reached});
    }
    pixel.color += transmittance * backgroundAlong(view.scene, camera.position, ray);
}

/// What the pixels of three rows show that follow each other, in the order of y modulo 3.
using Window = std::array<std::vector<Sequence>, 3>;

bool isInner(const Window& window, std::uint32_t x, std::uint32_t y) {
    const Sequence& own = window[y % 3][x];
    for (const std::vector<Sequence>& row : window) {
        for (std::uint32_t i = x - 1; i <= x + 1; ++i) {
            if (!std::equal(own.begin(), own.end(), row[i].begin(), row[i].end(),
                            [](const Face& a, const Face& b) { return a.isSameAs(b); })) {
                return false;
            }
        }
    }
    return true;
}

/// Rows that one job casts: few enough to keep workers busy, many beside the two around them that are cast again.
constexpr std::size_t kLayeredBandRows = 32;

/// Fills in a band of rows. Keeps what three rows show, since that of a large picture would take gigabytes.
void castBand(const View& view, const platform::IndexRange& band, LayeredTruth& truth) {
    Window window;
    window.fill(std::vector<Sequence>(truth.width));
    LayeredPixel around;
    const std::size_t first = band.begin > 0 ? band.begin - 1 : 0;
    const std::size_t end = std::min<std::size_t>(band.end + 1, truth.height);
    for (std::size_t row = first; row < end; ++row) {
        const auto y = static_cast<std::uint32_t>(row);
        const bool isOwn = row >= band.begin && row < band.end;
        for (std::uint32_t x = 0; x < truth.width; ++x) {
            castPixel(view, x, y, isOwn ? truth.at(x, y) : around, window[y % 3][x]);
        }
        if (row < first + 2) {
            continue; // the row above has none above it here
        }
        for (std::uint32_t x = 1; x + 1 < truth.width; ++x) {
            truth.at(x, y - 1).isInner = isInner(window, x, y - 1);
        }
    }
}

} // namespace

LayeredTruth castLayers(const scene::Scene& scene, const scene::Camera& camera, std::uint32_t width,
                        std::uint32_t height, platform::WorkerPool& workers, Lights lights) {
    scene::requireUsable(camera);
    if (width == 0 || height == 0) {
        throw base::InputError("truth: a picture needs at least one pixel");
    }
    platform::requireHostBytes(platform::saturatingProduct({width, height, sizeof(LayeredPixel)}),
                               fmt::format("the truth of {}x{} pixels with layers", width, height));
    std::vector<Shape> shapes(scene.meshes.begin(), scene.meshes.end());
    const TruthTextures textures(scene);
    std::optional<ShadowTruthCaster> shadows;
    if (lights == Lights::castShadows) {
        shadows.emplace(scene, shapes);
    }
    const View view = viewOf(scene, shapes, camera, {width, height}, textures, shadows, workers);
    LayeredTruth truth(width, height);
    const std::size_t bands = (std::size_t{height} + kLayeredBandRows - 1) / kLayeredBandRows;
    workers.run(bands, [&](std::size_t band, std::size_t) {
        castBand(view, platform::evenRange(height, band, bands), truth);
    });
    return truth;
}

std::vector<LayeredPixel> castLayersAt(const scene::Scene& scene, std::span<const Shape> shapes,
                                       const scene::Camera& camera, const glm::uvec2& size,
                                       std::span<const glm::uvec2> pixels, bool hasShadows,
                                       platform::WorkerPool& workers) {
    const TruthTextures textures(scene);
    std::optional<ShadowTruthCaster> shadows;
    if (hasShadows) {
        shadows.emplace(scene, shapes);
    }
    const View view = viewOf(scene, shapes, camera, size, textures, shadows, workers);
    std::vector<LayeredPixel> shown(pixels.size());
    workers.run(pixels.size(), [&](std::size_t i, std::size_t) {
        Sequence sequence;
        castPixel(view, pixels[i].x, pixels[i].y, shown[i], sequence);
    });
    return shown;
}

image::ImageRgba8 pictureOf(const LayeredTruth& truth, const TruthFinish& finish) {
    image::ImageRgba8 picture(truth.width, truth.height);
    std::transform(truth.pixels.begin(), truth.pixels.end(), picture.pixels.begin(),
                   [&](const LayeredPixel& pixel) { return encode(finished(pixel.color, finish)); });
    return picture;
}

LayerDifference compareLayers(const image::ImageRgba8& picture, const image::ImageU32& fragmentCounts,
                              const LayeredTruth& truth) {
    image::requireSameSize(picture, truth, "translucent truth: the picture's size");
    image::requireSameSize(fragmentCounts, truth, "translucent truth: the counts' size");
    LayerDifference difference;
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
        const LayeredPixel& pixel = truth.pixels[i];
        if (!pixel.isInner) {
            continue;
        }
        ++difference.pixels;
        difference.miscounted += fragmentCounts.pixels[i] != pixel.fragments ? 1 : 0;
        if (pixel.fragments == 0) {
            continue;
        }
        const image::Rgba8 wanted = encode(pixel.color);
        std::uint32_t error = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            error = std::max<std::uint32_t>(
                error, static_cast<std::uint32_t>(std::abs(int{wanted[c]} - int{picture.pixels[i][c]})));
        }
        ++difference.translucent;
        difference.within += error <= 1 ? 1 : 0;
        difference.largestError = std::max(difference.largestError, error);
        sum += error;
    }
    if (difference.translucent > 0) {
        difference.meanError = static_cast<double>(sum) / static_cast<double>(difference.translucent);
    }
    return difference;
}

} // namespace cdr::measure
