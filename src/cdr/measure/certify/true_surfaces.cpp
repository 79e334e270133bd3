#include <cdr/measure/certify/true_surfaces.h>
#include <cdr/measure/shadows/shadow_truth.h>
#include <cdr/measure/truth/layered_truth.h>
#include <cdr/measure/truth/object_ray.h>
#include <cdr/measure/truth/surface_hit.h>
#include <cdr/measure/truth/truth_air.h>
#include <cdr/measure/truth/truth_finish.h>
#include <cdr/measure/truth/truth_light.h>
#include <cdr/measure/truth/visible_instances.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <tuple>
#include <unordered_map>

namespace cdr::measure {

namespace {

/// The instances of the objects that repairs show.
using ByObject = std::unordered_map<std::uint32_t, std::vector<VisibleInstance>>;

ByObject instancesOf(const std::vector<PixelRepair>& repairs, const std::vector<VisibleInstance>& visible) {
    ByObject byObject;
    for (const PixelRepair& repair : repairs) {
        byObject[repair.id];
    }
    for (const VisibleInstance& instance : visible) {
        if (const auto object = byObject.find(instance.id); object != byObject.end()) {
            object->second.push_back(instance);
        }
    }
    return byObject;
}

/// The surface of an object at a distance, as one cast and another one round it.
const SurfaceHit* hitAt(const std::vector<SurfaceHit>& hits, double distanceView) {
    const auto nearest = std::ranges::min_element(hits, [&](const SurfaceHit& a, const SurfaceHit& b) {
        const double offA = std::abs(a.distanceView - distanceView);
        const double offB = std::abs(b.distanceView - distanceView);
        // Where both are there, the higher layer shows, or the last one drawn.
        return std::make_tuple(offA, -a.layer, b.instance) < std::make_tuple(offB, -b.layer, a.instance);
    });
    return nearest == hits.end() ? nullptr : &*nearest;
}

bool isBlended(const scene::Material& material) {
    return material.alphaMode == scene::AlphaMode::blend;
}

/// Lays what is blended over repairs.
void blendRepairs(const scene::Scene& scene, std::span<const Shape> shapes, const DrawnFrame& frame,
                  const TruthFinish& finish, platform::WorkerPool& workers,
                  std::vector<PixelRepair>& repairs) {
    std::vector<glm::uvec2> pixels(repairs.size());
    std::transform(repairs.begin(), repairs.end(), pixels.begin(),
                   [](const PixelRepair& repair) { return glm::uvec2(repair.x, repair.y); });
    const std::vector<LayeredPixel> shown = castLayersAt(
        scene, shapes, frame.camera, {frame.ids.width, frame.ids.height}, pixels, frame.hasShadows, workers);
    for (std::size_t i = 0; i < repairs.size(); ++i) {
        if (shown[i].fragments > 0) {
            repairs[i].color = encode(finished(shown[i].color, finish));
        }
    }
}

} // namespace

void lightRepairs(const scene::Scene& scene, std::span<const Shape> shapes, const DrawnFrame& frame,
                  platform::WorkerPool& workers, std::vector<PixelRepair>& repairs) {
    if (repairs.empty()) {
        return;
    }
    const scene::Camera& camera = frame.camera;
    const ByObject byObject = instancesOf(
        repairs, visibleInstances(scene, shapes, camera, frame.ids.width, frame.ids.height, workers));
    const PixelSlopes slopes = pixelSlopes(camera, frame.ids.width, frame.ids.height);
    const TruthTextures textures(scene);
    // Frames with effects are not certified, so the scene alone decides on tone mapping.
    const TruthFinish finish{.neutral = scene.sky.has_value() || scene.air.has_value()};
    std::optional<ShadowTruthCaster> shadows;
    if (frame.hasShadows) {
        shadows.emplace(scene, shapes);
    }
    workers.run(repairs.size(), [&](std::size_t i, std::size_t) {
        PixelRepair& repair = repairs[i];
        const double x = slopes.x[repair.x];
        const double y = slopes.y[repair.y];
        const glm::dvec3 ray = -camera.back + x * camera.right + y * camera.up;
        repair.color = encode(finished(backgroundAlong(scene, camera.position, ray), finish));
        std::vector<SurfaceHit> hits;
        for (const VisibleInstance& instance : byObject.at(repair.id)) {
            if (instance.pixels.contains(repair.x, repair.y)) {
                appendHits(scene, textures, instance, {x, y, slopes.step}, {camera.nearView, camera.farView},
                           hits);
            }
        }
        std::erase_if(hits, [](const SurfaceHit& hit) { return hit.isBlended; });
        if (const SurfaceHit* hit = hitAt(hits, repair.distanceView)) {
            repair.normal = hit->normal;
            repair.baseColor = glm::dvec3(hit->baseColor);
            const glm::dvec3 fromCamera = hit->distanceView * ray;
            const glm::dvec4 reached = shadows && !hit->isUnlit
                                           ? shadows->sharesAt(camera.position, fromCamera, hit->normal)
                                           : glm::dvec4(1.0);
            const glm::dvec3 light = lightFrom(scene, camera, *hit, fromCamera, reached);
            repair.color = encode(finished(throughAir(scene, camera.position, fromCamera, light), finish));
        }
    });
    if (std::any_of(scene.materials.begin(), scene.materials.end(), isBlended)) {
        blendRepairs(scene, shapes, frame, finish, workers, repairs);
    }
}

} // namespace cdr::measure
