#include <cdr/base/error.h>
#include <cdr/measure/truth/mask_cut.h>
#include <cdr/measure/truth/tile_bins.h>
#include <cdr/measure/truth/truth.h>
#include <cdr/measure/truth/visible_instances.h>
#include <cdr/platform/host_memory.h>

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
    std::uint32_t instance; ///< index in the scene

    double rank() const { return distanceView - layer; }
    /// As drawn: of equal surfaces the last in the scene's order shows.
    bool isBefore(const Seen& other) const {
        return rank() < other.rank() || (rank() == other.rank() && instance > other.instance);
    }
};

/// Whose a pixel's two surfaces are, while its tile is cast.
struct Owners {
    std::uint32_t first = 0; ///< instances, any where the pixel has no such surface
    std::uint32_t second = 0;
    double doubtRank = kNoHit; ///< of the nearest masked surface that may be cut away or stay
};

/// A pixel while its tile is cast.
struct CastPixel {
    TruthPixel& pixel;
    Owners& owners;

    Seen first() const { return {pixel.distanceView, pixel.layer, pixel.id, owners.first}; }
    Seen second() const {
        return {pixel.secondDistanceView, pixel.secondLayer, pixel.secondId, owners.second};
    }
    void setFirst(const Seen& seen) const {
        std::tie(pixel.distanceView, pixel.layer, pixel.id, owners.first) =
            std::tie(seen.distanceView, seen.layer, seen.id, seen.instance);
    }
    void setSecond(const Seen& seen) const {
        std::tie(pixel.secondDistanceView, pixel.secondLayer, pixel.secondId, owners.second) =
            std::tie(seen.distanceView, seen.layer, seen.id, seen.instance);
    }
    /// Enters a visible hit. Whatever the order of hits, the pixel ends up the same.
    void enter(const Seen& hit) const {
        const Seen nearest = first();
        if (hit.isBefore(nearest)) {
            if (hit.id != nearest.id) {
                setSecond(nearest);
            }
            setFirst(hit);
        } else if (hit.id != nearest.id && hit.isBefore(second())) {
            setSecond(hit);
        }
    }
};

double secondRank(const TruthPixel& pixel) {
    return pixel.secondDistanceView - pixel.secondLayer;
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

/// The pixels of a tile that are cast, and whose surfaces they have.
struct Tile {
    PixelRect pixels;
    std::vector<Owners> owners;

    explicit Tile(const PixelRect& rect)
        : pixels(rect),
          owners(std::size_t{rect.right - rect.left} * (rect.bottom - rect.top)) {}
    Owners& at(std::uint32_t x, std::uint32_t y) {
        return owners[std::size_t{y - pixels.top} * (pixels.right - pixels.left) + (x - pixels.left)];
    }
};

/// What all tiles of a picture are cast from.
struct TileView {
    const scene::Scene& scene;
    const TruthTextures& textures;
    const scene::Camera& camera;
    PixelSlopes slopes;
    Wanted wanted;
    std::vector<VisibleInstance> nearestFirst;

    bool isMasked(const VisibleInstance& instance) const {
        const std::uint32_t material = scene.instances.material[instance.instance];
        return scene.materials[material].alphaMode == scene::AlphaMode::mask;
    }
    /// What the ray of a pixel meets of an instance.
    MaskedHit meet(const VisibleInstance& instance, std::uint32_t x, std::uint32_t y,
                   const ViewRange& range) const {
        if (isMasked(instance)) {
            return nearestKept(scene, textures, instance, {slopes.x[x], slopes.y[y], slopes.step}, range);
        }
        const ObjectRay ray = instance.camera.ray(slopes.x[x], slopes.y[y]);
        return {.distanceView = instance.shape->nearest(ray, instance.sides, range)};
    }
};

void castInstance(const TileView& view, const VisibleInstance& instance, Tile& tile, TruthImage& truth) {
    const PixelRect pixels = intersection(tile.pixels, instance.pixels);
    for (std::uint32_t y = pixels.top; y < pixels.bottom; ++y) {
        for (std::uint32_t x = pixels.left; x < pixels.right; ++x) {
            if (!view.wanted.has(x, y)) {
                continue;
            }
            TruthPixel& pixel = truth.at(x, y);
            const double farthestRank = secondRank(pixel);
            if (instance.nearestRank() > farthestRank) {
                continue;
            }
            const ViewRange range{view.camera.nearView,
                                  std::min(view.camera.farView, farthestRank + instance.layer)};
            const MaskedHit hit = view.meet(instance, x, y, range);
            Owners& owners = tile.at(x, y);
            owners.doubtRank = std::min(owners.doubtRank, hit.doubtView - instance.layer);
            if (hit.distanceView < kNoHit) {
                CastPixel{pixel, owners}.enter(
                    {hit.distanceView, static_cast<float>(instance.layer), instance.id, instance.instance});
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
                farthest = std::max(farthest, secondRank(truth.at(x, y)));
            }
        }
    }
    return farthest;
}

/// Marks the pixels where what may be cut away or stay is the nearest surface, or before it.
void markDoubtful(Tile& tile, TruthImage& truth) {
    for (std::uint32_t y = tile.pixels.top; y < tile.pixels.bottom; ++y) {
        for (std::uint32_t x = tile.pixels.left; x < tile.pixels.right; ++x) {
            const TruthPixel& pixel = truth.at(x, y);
            const double doubtRank = tile.at(x, y).doubtRank;
            truth.doubtful.at(x, y) =
                doubtRank < kNoHit && doubtRank <= pixel.distanceView - pixel.layer ? 1 : 0;
        }
    }
}

void castTile(const TileView& view, std::span<const std::uint32_t> members, const PixelRect& rect,
              TruthImage& truth) {
    const PixelRect pixels = view.wanted.within(rect);
    if (pixels.empty()) {
        return;
    }
    Tile tile(pixels);
    // Often enough to end early, seldom enough to cost nothing.
    constexpr std::size_t kCheckEvery = 8;
    for (std::size_t i = 0; i < members.size(); ++i) {
        const VisibleInstance& instance = view.nearestFirst[members[i]];
        if (i % kCheckEvery == kCheckEvery - 1 &&
            instance.nearestRank() > farthestSecondRank(pixels, view.wanted, truth)) {
            break;
        }
        castInstance(view, instance, tile, truth);
    }
    if (!truth.doubtful.pixels.empty()) {
        markDoubtful(tile, truth);
    }
}

TruthImage emptyTruth(std::uint32_t width, std::uint32_t height) {
    platform::requireHostBytes(platform::saturatingProduct({width, height, sizeof(TruthPixel)}),
                               fmt::format("the truth of {}x{} pixels", width, height));
    return {width, height};
}

} // namespace

TruthCaster::TruthCaster(const scene::Scene& scene, platform::WorkerPool& workers)
    : m_scene(&scene),
      m_textures(std::make_unique<const TruthTextures>(scene)) {
    std::vector<std::optional<Shape>> shapes(scene.meshes.size());
    workers.run(shapes.size(),
                [&](std::size_t mesh, std::size_t) { shapes[mesh].emplace(scene.meshes[mesh]); });
    m_shapes.reserve(shapes.size());
    for (std::optional<Shape>& shape : shapes) {
        m_shapes.push_back(std::move(*shape));
    }
}

void TruthCaster::follow(std::span<const std::uint32_t> meshes, platform::WorkerPool& workers) {
    workers.run(meshes.size(), [&](std::size_t i, std::size_t) {
        m_shapes.at(meshes[i]) = Shape(m_scene->meshes[meshes[i]]);
    });
}

TruthImage TruthCaster::cast(const scene::Camera& camera, std::uint32_t width, std::uint32_t height,
                             platform::WorkerPool& workers) const {
    TruthImage truth = emptyTruth(width, height);
    castInto(camera, nullptr, workers, truth);
    return truth;
}

TruthImage TruthCaster::cast(const scene::Camera& camera, const image::Raster<std::uint8_t>& wanted,
                             platform::WorkerPool& workers) const {
    TruthImage truth = emptyTruth(wanted.width, wanted.height);
    castInto(camera, &wanted, workers, truth);
    return truth;
}

void TruthCaster::castInto(const scene::Camera& camera, const image::Raster<std::uint8_t>* wanted,
                           platform::WorkerPool& workers, TruthImage& truth) const {
    scene::requireUsable(camera);
    if (truth.width == 0 || truth.height == 0) {
        throw base::InputError("truth: a picture needs at least one pixel");
    }
    TileView view{.scene = *m_scene,
                  .textures = *m_textures,
                  .camera = camera,
                  .slopes = pixelSlopes(camera, truth.width, truth.height),
                  .wanted = Wanted(wanted),
                  .nearestFirst =
                      visibleInstances(*m_scene, m_shapes, camera, truth.width, truth.height, workers)};
    std::erase_if(view.nearestFirst, [&](const VisibleInstance& visible) {
        const std::uint32_t material = m_scene->instances.material[visible.instance];
        return m_scene->materials[material].alphaMode == scene::AlphaMode::blend;
    });
    if (std::any_of(view.nearestFirst.begin(), view.nearestFirst.end(),
                    [&](const VisibleInstance& visible) { return view.isMasked(visible); })) {
        truth.doubtful = image::Raster<std::uint8_t>(truth.width, truth.height);
    }
    std::vector<PixelRect> rects;
    rects.reserve(view.nearestFirst.size());
    for (const VisibleInstance& instance : view.nearestFirst) {
        rects.push_back(instance.pixels);
    }
    const TileBins bins(truth.width, truth.height, rects);
    workers.run(bins.tiles(), [&](std::size_t tile, std::size_t) {
        castTile(view, bins.members(tile), bins.pixels(tile), truth);
    });
}

TruthImage castTruth(const scene::Scene& scene, const scene::Camera& camera, std::uint32_t width,
                     std::uint32_t height, platform::WorkerPool& workers) {
    return TruthCaster(scene, workers).cast(camera, width, height, workers);
}

} // namespace cdr::measure
