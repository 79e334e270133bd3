#include <cdr/base/error.h>
#include <cdr/measure/truth/tile_bins.h>
#include <cdr/measure/truth/truth.h>
#include <cdr/measure/truth/visible_instances.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

namespace cdr::measure {

namespace {

/// A surface of a pixel.
struct Seen {
    double distanceView;
    float layer;
    std::uint32_t id;

    double rank() const { return distanceView - layer; }
    bool isBefore(const Seen& other) const {
        return rank() < other.rank() || (rank() == other.rank() && id < other.id);
    }
};

Seen firstOf(const TruthPixel& pixel) {
    return {pixel.distanceView, pixel.layer, pixel.id};
}

Seen secondOf(const TruthPixel& pixel) {
    return {pixel.secondDistanceView, pixel.secondLayer, pixel.secondId};
}

void setFirst(TruthPixel& pixel, const Seen& seen) {
    std::tie(pixel.distanceView, pixel.layer, pixel.id) = std::tie(seen.distanceView, seen.layer, seen.id);
}

void setSecond(TruthPixel& pixel, const Seen& seen) {
    std::tie(pixel.secondDistanceView, pixel.secondLayer, pixel.secondId) =
        std::tie(seen.distanceView, seen.layer, seen.id);
}

/// Enters a visible hit. Whatever the order of hits, the pixel ends up the same.
void enterHit(TruthPixel& pixel, const Seen& hit) {
    const Seen first = firstOf(pixel);
    if (hit.isBefore(first)) {
        if (hit.id != first.id) {
            setSecond(pixel, first);
        }
        setFirst(pixel, hit);
    } else if (hit.id != first.id && hit.isBefore(secondOf(pixel))) {
        setSecond(pixel, hit);
    }
}

void castInstance(const VisibleInstance& instance, const PixelRect& pixels, const PixelSlopes& slopes,
                  const scene::Camera& camera, TruthImage& truth) {
    for (std::uint32_t y = pixels.top; y < pixels.bottom; ++y) {
        for (std::uint32_t x = pixels.left; x < pixels.right; ++x) {
            TruthPixel& pixel = truth.at(x, y);
            const double secondRank = secondOf(pixel).rank();
            if (instance.nearestRank() > secondRank) {
                continue;
            }
            const ViewRange range{camera.nearView, std::min(camera.farView, secondRank + instance.layer)};
            const double hit = instance.shape->nearest(instance.camera.ray(slopes.x[x], slopes.y[y]),
                                                       instance.doubleSided, range);
            if (hit < kNoHit) {
                enterHit(pixel, {hit, static_cast<float>(instance.layer), instance.id});
            }
        }
    }
}

/// Beyond this distance less its layer nothing changes the tile any more.
double farthestSecondRank(const PixelRect& pixels, const TruthImage& truth) {
    double farthest = -kNoHit;
    for (std::uint32_t y = pixels.top; y < pixels.bottom; ++y) {
        for (std::uint32_t x = pixels.left; x < pixels.right; ++x) {
            farthest = std::max(farthest, secondOf(truth.at(x, y)).rank());
        }
    }
    return farthest;
}

void castTile(std::span<const VisibleInstance> nearestFirst, std::span<const std::uint32_t> members,
              const PixelRect& tile, const PixelSlopes& slopes, const scene::Camera& camera,
              TruthImage& truth) {
    // Often enough to end early, seldom enough to cost nothing.
    constexpr std::size_t kCheckEvery = 8;
    for (std::size_t i = 0; i < members.size(); ++i) {
        const VisibleInstance& instance = nearestFirst[members[i]];
        if (i % kCheckEvery == kCheckEvery - 1 && instance.nearestRank() > farthestSecondRank(tile, truth)) {
            return;
        }
        castInstance(instance, intersection(tile, instance.pixels), slopes, camera, truth);
    }
}

} // namespace

TruthCaster::TruthCaster(const scene::Scene& scene, host::WorkerPool& workers) : m_scene(&scene) {
    std::vector<std::optional<Shape>> shapes(scene.meshes.size());
    workers.run(shapes.size(),
                [&](std::size_t mesh, std::size_t) { shapes[mesh].emplace(scene.meshes[mesh]); });
    m_shapes.reserve(shapes.size());
    for (std::optional<Shape>& shape : shapes) {
        m_shapes.push_back(std::move(*shape));
    }
}

TruthImage TruthCaster::cast(const scene::Camera& camera, std::uint32_t width, std::uint32_t height,
                             host::WorkerPool& workers) const {
    scene::requireUsable(camera);
    if (width == 0 || height == 0) {
        throw base::InputError("truth: a picture needs at least one pixel");
    }
    std::vector<VisibleInstance> nearestFirst =
        visibleInstances(*m_scene, m_shapes, camera, width, height, workers);
    std::erase_if(nearestFirst, [&](const VisibleInstance& visible) {
        const std::uint32_t material = m_scene->instances.material[visible.instance];
        return m_scene->materials[material].alphaMode == scene::AlphaMode::blend;
    });
    std::vector<PixelRect> rects;
    rects.reserve(nearestFirst.size());
    for (const VisibleInstance& instance : nearestFirst) {
        rects.push_back(instance.pixels);
    }
    const TileBins bins(width, height, rects);
    const PixelSlopes slopes = pixelSlopes(camera, width, height);
    TruthImage truth(width, height);
    workers.run(bins.tiles(), [&](std::size_t tile, std::size_t) {
        castTile(nearestFirst, bins.members(tile), bins.pixels(tile), slopes, camera, truth);
    });
    return truth;
}

TruthImage castTruth(const scene::Scene& scene, const scene::Camera& camera, std::uint32_t width,
                     std::uint32_t height, host::WorkerPool& workers) {
    return TruthCaster(scene, workers).cast(camera, width, height, workers);
}

} // namespace cdr::measure
