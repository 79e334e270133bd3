#include "among_alike.h"
#include "pairs.h"

#include <cdr/measure/truth/object_ray.h>
#include <cdr/measure/truth/visible_instances.h>

#include <algorithm>
#include <cmath>

namespace cdr::experiments {

image::ImageU32 PairCollector::blendedInPlane(const scene::Camera& camera, const measure::TruthImage& truth,
                                              std::span<const measure::Shape> shapes,
                                              platform::WorkerPool& workers) const {
    image::ImageU32 ids(truth.width, truth.height);
    const measure::PixelSlopes slopes = measure::pixelSlopes(camera, truth.width, truth.height);
    for (const measure::VisibleInstance& visible :
         measure::visibleInstances(m_scene, shapes, camera, truth.width, truth.height, workers)) {
        const std::uint32_t material = m_scene.instances.material[visible.instance];
        if (m_scene.materials[material].alphaMode != scene::AlphaMode::blend) {
            continue;
        }
        const measure::PixelRect& pixels = visible.pixels;
        for (std::uint32_t y = pixels.top; y < pixels.bottom; ++y) {
            for (std::uint32_t x = pixels.left; x < pixels.right; ++x) {
                const measure::TruthPixel& pixel = truth.at(x, y);
                if (pixel.id == 0 || pixel.id == visible.id) {
                    continue;
                }
                // Where the blended surface has to be, so that both are equally near, layers included.
                const double atView = pixel.distanceView - static_cast<double>(pixel.layer) + visible.layer;
                const double off =
                    roundingView(m_extents[pixel.id - 1] + m_extents[visible.id - 1], pixel.distanceView);
                const double hit = visible.shape->nearest(visible.camera.ray(slopes.x[x], slopes.y[y]),
                                                          visible.sides, {atView - off, atView + off});
                const glm::dvec3 ray = camera.right * slopes.x[x] + camera.up * slopes.y[y] - camera.back;
                if (hit < measure::kNoHit && areInPlane(pixel.id - 1, visible.id - 1, std::abs(hit - atView),
                                                        pixel.distanceView, ray, camera)) {
                    ids.at(x, y) = visible.id;
                }
            }
        }
    }
    return ids;
}

void PairCollector::addBlended(const measure::TruthImage& truth, const image::ImageU32& blended) {
    for (std::uint32_t y = 0; y < truth.height; ++y) {
        for (std::uint32_t x = 0; x < truth.width; ++x) {
            const std::uint32_t id = truth.at(x, y).id;
            const std::uint32_t blendedId = blended.at(x, y);
            if (blendedId == 0) {
                continue;
            }
            const bool isInner =
                isInside(x, y, truth) && isAmongAlike(x, y, [&](std::uint32_t i, std::uint32_t j) {
                    return truth.at(i, j).id == id && blended.at(i, j) == blendedId;
                });
            const auto ids = std::minmax(id, blendedId);
            ObjectPair& pair = (isInner ? m_pairs : m_narrow)[{ids.first, ids.second}].pair;
            pair.front = ids.first - 1;
            pair.back = ids.second - 1;
            pair.atView = pair.coplanar == 0 ? truth.at(x, y).distanceView : pair.atView;
            pair.gapView = 0.0;
            ++pair.pixels;
            ++pair.coplanar;
        }
    }
}

} // namespace cdr::experiments
