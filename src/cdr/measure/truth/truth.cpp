#include <cdr/base/error.h>
#include <cdr/host/host_memory.h>
#include <cdr/measure/truth/tile_bins.h>
#include <cdr/measure/truth/truth.h>
#include <cdr/measure/truth/visible_instances.h>

#include <fmt/format.h>

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

/// The pixels to cast, all or some.
class Wanted {
  public:
    /// @param wanted null for all.
    explicit Wanted(const image::Raster<std::uint8_t>* wanted) : m_wanted(wanted) {}

    bool has(std::uint32_t x, std::uint32_t y) const {
        return m_wanted == nullptr || m_wanted->at(x, y) != 0;
    }

    /// The least rectangle that holds all of them that `pixels` holds.
    PixelRect within(const PixelRect& pixels) const {
        if (m_wanted == nullptr) {
            return pixels;
        }
        PixelRect held{pixels.right, pixels.bottom, pixels.left, pixels.top};
        for (std::uint32_t y = pixels.top; y < pixels.bottom; ++y) {
            for (std::uint32_t x = pixels.left; x < pixels.right; ++x) {
                if (m_wanted->at(x, y) != 0) {
                    held = {std::min(held.left, x), std::min(held.top, y), std::max(held.right, x + 1),
                            std::max(held.bottom, y + 1)};
                }
            }
        }
        return held;
    }

  private:
    const image::Raster<std::uint8_t>* m_wanted;
};

void castInstance(const VisibleInstance& instance, const PixelRect& pixels, const Wanted& wanted,
                  const PixelSlopes& slopes, const scene::Camera& camera, TruthImage& truth) {
    for (std::uint32_t y = pixels.top; y < pixels.bottom; ++y) {
        for (std::uint32_t x = pixels.left; x < pixels.right; ++x) {
            if (!wanted.has(x, y)) {
                continue;
            }
            TruthPixel& pixel = truth.at(x, y);
            const double secondRank = secondOf(pixel).rank();
            if (instance.nearestRank() > secondRank) {
                continue;
            }
            const ViewRange range{camera.nearView, std::min(camera.farView, secondRank + instance.layer)};
            const double hit =
                instance.shape->nearest(instance.camera.ray(slopes.x[x], slopes.y[y]), instance.sides, range);
            if (hit < kNoHit) {
                enterHit(pixel, {hit, static_cast<float>(instance.layer), instance.id});
            }
        }
    }
}

/// Beyond this distance less its layer nothing changes the tile any more.
double farthestSecondRank(const PixelRect& pixels, const Wanted& wanted, const TruthImage& truth) {
    double farthest = -kNoHit;
    for (std::uint32_t y = pixels.top; y < pixels.bottom; ++y) {
        for (std::uint32_t x = pixels.left; x < pixels.right; ++x) {
            if (wanted.has(x, y)) {
                farthest = std::max(farthest, secondOf(truth.at(x, y)).rank());
            }
        }
    }
    return farthest;
}

void castTile(std::span<const VisibleInstance> nearestFirst, std::span<const std::uint32_t> members,
              const PixelRect& tile, const Wanted& wanted, const PixelSlopes& slopes,
              const scene::Camera& camera, TruthImage& truth) {
    const PixelRect pixels = wanted.within(tile);
    if (pixels.empty()) {
        return;
    }
    // Often enough to end early, seldom enough to cost nothing.
    constexpr std::size_t kCheckEvery = 8;
    for (std::size_t i = 0; i < members.size(); ++i) {
        const VisibleInstance& instance = nearestFirst[members[i]];
        if (i % kCheckEvery == kCheckEvery - 1 &&
            instance.nearestRank() > farthestSecondRank(pixels, wanted, truth)) {
            return;
        }
        castInstance(instance, intersection(pixels, instance.pixels), wanted, slopes, camera, truth);
    }
}

TruthImage emptyTruth(std::uint32_t width, std::uint32_t height) {
    host::requireHostBytes(std::uint64_t{width} * height * sizeof(TruthPixel),
                           fmt::format("the truth of {}x{} pixels", width, height));
    return {width, height};
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

void TruthCaster::follow(std::span<const std::uint32_t> meshes, host::WorkerPool& workers) {
    workers.run(meshes.size(), [&](std::size_t i, std::size_t) {
        m_shapes.at(meshes[i]) = Shape(m_scene->meshes[meshes[i]]);
    });
}

TruthImage TruthCaster::cast(const scene::Camera& camera, std::uint32_t width, std::uint32_t height,
                             host::WorkerPool& workers) const {
    TruthImage truth = emptyTruth(width, height);
    castInto(camera, nullptr, workers, truth);
    return truth;
}

TruthImage TruthCaster::cast(const scene::Camera& camera, const image::Raster<std::uint8_t>& wanted,
                             host::WorkerPool& workers) const {
    TruthImage truth = emptyTruth(wanted.width, wanted.height);
    castInto(camera, &wanted, workers, truth);
    return truth;
}

void TruthCaster::castInto(const scene::Camera& camera, const image::Raster<std::uint8_t>* wanted,
                           host::WorkerPool& workers, TruthImage& truth) const {
    scene::requireUsable(camera);
    if (truth.width == 0 || truth.height == 0) {
        throw base::InputError("truth: a picture needs at least one pixel");
    }
    std::vector<VisibleInstance> nearestFirst =
        visibleInstances(*m_scene, m_shapes, camera, truth.width, truth.height, workers);
    std::erase_if(nearestFirst, [&](const VisibleInstance& visible) {
        const std::uint32_t material = m_scene->instances.material[visible.instance];
        return m_scene->materials[material].alphaMode == scene::AlphaMode::blend;
    });
    std::vector<PixelRect> rects;
    rects.reserve(nearestFirst.size());
    for (const VisibleInstance& instance : nearestFirst) {
        rects.push_back(instance.pixels);
    }
    const TileBins bins(truth.width, truth.height, rects);
    const PixelSlopes slopes = pixelSlopes(camera, truth.width, truth.height);
    workers.run(bins.tiles(), [&](std::size_t tile, std::size_t) {
        castTile(nearestFirst, bins.members(tile), bins.pixels(tile), Wanted(wanted), slopes, camera, truth);
    });
}

TruthImage castTruth(const scene::Scene& scene, const scene::Camera& camera, std::uint32_t width,
                     std::uint32_t height, host::WorkerPool& workers) {
    return TruthCaster(scene, workers).cast(camera, width, height, workers);
}

} // namespace cdr::measure
