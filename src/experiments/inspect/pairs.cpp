#include "pairs.h"

#include "among_alike.h"
#include "thickness.h"

#include <cdr/measure/truth/object_ray.h>

#include <algorithm>
#include <cstddef>
#include <tuple>

namespace cdr::experiments {

namespace {

/// What the truth's own arithmetic leaves of a distance.
constexpr double kTruthRounding = 0x1p-48;
/// Float32 roundings of a vertex and of its basis, on a slanted face.
constexpr double kVertexRounding = 0x1p-22;

/// A gap that is small beside an object's own size.
constexpr double kClose = 0.01;
/// A thickness that is small beside an object's own size: that of decals, signs and plates.
constexpr double kThin = 0.1;

using Ids = std::pair<std::uint32_t, std::uint32_t>;

/// Both ids of a pixel in ascending order, as pairs of coplanar objects are stored.
Ids sorted(const measure::TruthPixel& pixel) {
    return std::minmax(pixel.id, pixel.secondId);
}

} // namespace

PairCollector::PairCollector(const scene::Scene& scene)
    : m_scene(scene),
      m_instances(scene.objectCount()),
      m_extents(scene.objectCount(), 0.0),
      m_isSeen(scene.objectCount(), false) {
    const scene::Instances& instances = scene.instances;
    for (std::size_t i = 0; i < instances.size(); ++i) {
        double& extent = m_extents[instances.object[i]];
        extent = std::max(extent, static_cast<double>(instances.radius[i]));
        m_instances[instances.object[i]].push_back(static_cast<std::uint32_t>(i));
    }
}

/// How far the vertices of the part of an object that is at a place reach. Of several it is the smallest, so that a small
/// part of a large object is not taken for as coarse as the whole.
double PairCollector::extentAt(std::uint32_t object, const glm::dvec3& place) const {
    double extent = m_extents[object];
    for (const std::uint32_t i : m_instances[object]) {
        const double radius = m_scene.instances.radius[i];
        if (radius < extent && glm::distance(place, m_scene.instances.position(i)) <= radius) {
            extent = radius;
        }
    }
    return extent;
}

/// Solid objects close behind others are hidden as anything else is: a step forward would not bring them into view.
bool PairCollector::isThin(std::uint32_t object) const {
    return std::ranges::all_of(m_instances[object], [&](std::uint32_t i) {
        return thicknessOf(m_scene, i) <= kThin * m_scene.instances.radius[i];
    });
}

double PairCollector::roundingView(double extents, double distanceView) {
    return kVertexRounding * extents + kTruthRounding * distanceView;
}

double PairCollector::roundingViewAt(std::uint32_t first, std::uint32_t second, double distanceView,
                                     const glm::dvec3& ray, const scene::Camera& camera) const {
    const glm::dvec3 place = camera.position + distanceView * ray;
    return roundingView(extentAt(first, place) + extentAt(second, place), distanceView);
}

bool PairCollector::areInPlane(std::uint32_t first, std::uint32_t second, double gapView, double distanceView,
                               const glm::dvec3& ray, const scene::Camera& camera) const {
    if (!(gapView <= roundingView(m_extents[first] + m_extents[second], distanceView))) {
        return false; // nearly all
    }
    return gapView <= roundingViewAt(first, second, distanceView, ray, camera);
}

image::Raster<std::uint8_t> PairCollector::coplanarMask(const scene::Camera& camera,
                                                        const measure::TruthImage& truth) const {
    image::Raster<std::uint8_t> mask(truth.width, truth.height);
    const measure::PixelSlopes slopes = measure::pixelSlopes(camera, truth.width, truth.height);
    for (std::uint32_t y = 0; y < truth.height; ++y) {
        for (std::uint32_t x = 0; x < truth.width; ++x) {
            const measure::TruthPixel& pixel = truth.at(x, y);
            if (pixel.id == 0 || pixel.secondId == 0) {
                continue;
            }
            const glm::dvec3 ray = camera.right * slopes.x[x] + camera.up * slopes.y[y] - camera.back;
            mask.at(x, y) =
                areInPlane(pixel.id - 1, pixel.secondId - 1, pixel.gapView(), pixel.distanceView, ray, camera)
                    ? 1
                    : 0;
        }
    }
    return mask;
}

void PairCollector::add(const scene::Camera& camera, const measure::TruthImage& truth,
                        const image::ImageU32& blended) {
    addBlended(truth, blended);
    const image::Raster<std::uint8_t> coplanar = coplanarMask(camera, truth);
    for (const measure::TruthPixel& pixel : truth.pixels) {
        if (pixel.id != 0) {
            m_isSeen[pixel.id - 1] = true;
        }
    }
    for (std::uint32_t y = 0; y < truth.height; ++y) {
        for (std::uint32_t x = 0; x < truth.width; ++x) {
            const measure::TruthPixel& pixel = truth.at(x, y);
            if (pixel.secondId == 0) {
                continue;
            }
            const bool isCoplanar = coplanar.at(x, y) != 0;
            const Ids ids = isCoplanar ? sorted(pixel) : Ids{pixel.id, pixel.secondId};
            const bool isInner =
                isInside(x, y, truth) && isAmongAlike(x, y, [&](std::uint32_t i, std::uint32_t j) {
                    const measure::TruthPixel& other = truth.at(i, j);
                    return other.secondId != 0 && (coplanar.at(i, j) != 0) == isCoplanar &&
                           (isCoplanar ? sorted(other) : Ids{other.id, other.secondId}) == ids;
                });
            if (!isInner && !isCoplanar) {
                continue;
            }
            Found& found = (isInner ? m_pairs : m_narrow)[ids];
            ObjectPair& pair = found.pair;
            pair.front = ids.first - 1;
            pair.back = ids.second - 1;
            ++pair.pixels;
            pair.coplanar += isCoplanar ? 1 : 0;
            const double gapView = pixel.gapView();
            pair.widestGapView = std::max(pair.widestGapView, gapView);
            found.close += gapView <= kClose * m_extents[pair.back] ? 1 : 0;
            if (gapView * pair.atView < pair.gapView * pixel.distanceView || pair.pixels == 1) {
                pair.gapView = gapView;
                pair.atView = pixel.distanceView;
            }
        }
    }
}

std::vector<ObjectPair> PairCollector::pairs() const {
    std::vector<ObjectPair> all;
    Pairs entered = m_pairs;
    for (const auto& [ids, found] : m_narrow) {
        Found& inner = entered[ids];
        inner = inner.pair.isCoplanar() ? inner : found;
    }
    for (const auto& [ids, found] : entered) {
        all.push_back(found.pair);
        all.back().isSunk = !found.pair.isCoplanar() && !m_isSeen[found.pair.back] &&
                            2 * found.close >= found.pair.pixels && isThin(found.pair.back);
    }
    const auto order = [](const ObjectPair& pair) {
        return std::make_tuple(!pair.isCoplanar(), -static_cast<double>(pair.coplanar),
                               pair.gapView / pair.atView, pair.front, pair.back);
    };
    std::ranges::sort(all, [&](const ObjectPair& a, const ObjectPair& b) { return order(a) < order(b); });
    return all;
}

} // namespace cdr::experiments
