#include <cdr/image/same_size.h>
#include <cdr/measure/shadows/shadow_truth.h>
#include <cdr/measure/truth/truth_air.h>
#include <cdr/measure/truth/truth_light.h>
#include <cdr/measure/truth/truth_shading.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace cdr::measure {

namespace {

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

} // namespace

TruthShader::TruthShader(const scene::Scene& scene, const TruthTextures& textures,
                         const scene::Camera& camera, const glm::uvec2& size,
                         std::vector<VisibleInstance> visible, const ShadowTruthCaster* shadows,
                         const TruthFinish& finish)
    : m_scene(scene),
      m_camera(camera),
      m_slopes(pixelSlopes(camera, size.x, size.y)),
      m_textures(textures),
      m_visible(std::move(visible)),
      m_shadows(shadows),
      m_finish(finish) {
    std::ranges::sort(m_visible, {}, &VisibleInstance::id);
}

std::vector<SurfaceHit> TruthShader::hitsOn(std::uint32_t x, std::uint32_t y, std::uint32_t id) const {
    std::vector<SurfaceHit> hits;
    auto instance = std::ranges::lower_bound(m_visible, id, {}, &VisibleInstance::id);
    for (; instance != m_visible.end() && instance->id == id; ++instance) {
        if (instance->pixels.contains(x, y)) {
            appendHits(m_scene, m_textures, *instance, {m_slopes.x[x], m_slopes.y[y], m_slopes.step},
                       {m_camera.nearView, m_camera.farView}, hits);
        }
    }
    std::erase_if(hits, [](const SurfaceHit& hit) { return hit.isBlended; });
    return hits;
}

ShadedPixel TruthShader::at(std::uint32_t x, std::uint32_t y, std::uint32_t id, double distanceView) const {
    const glm::dvec3 ray = -m_camera.back + m_slopes.x[x] * m_camera.right + m_slopes.y[y] * m_camera.up;
    const std::vector<SurfaceHit> hits = hitsOn(x, y, id);
    const SurfaceHit* hit = hitAt(hits, distanceView);
    if (hit == nullptr) {
        return {.color = encode(finished(backgroundAlong(m_scene, m_camera.position, ray), m_finish))};
    }
    const glm::dvec3 fromCamera = hit->distanceView * ray;
    const glm::dvec4 reached = m_shadows != nullptr && !hit->isUnlit
                                   ? m_shadows->sharesAt(m_camera.position, fromCamera, hit->normal)
                                   : glm::dvec4(1.0);
    const glm::dvec3 light = lightFrom(m_scene, m_camera, *hit, fromCamera, reached);
    return {.color = encode(finished(throughAir(m_scene, m_camera.position, fromCamera, light), m_finish)),
            .normal = hit->normal,
            .baseColor = glm::dvec3(hit->baseColor)};
}

image::ImageRgba8 shadeTruth(const scene::Scene& scene, const TruthCaster& caster,
                             const scene::Camera& camera, const TruthImage& truth,
                             platform::WorkerPool& workers) {
    const TruthShader shader(
        scene, caster.textures(), camera, {truth.width, truth.height},
        visibleInstances(scene, caster.shapes(), camera, truth.width, truth.height, workers), nullptr, {});
    image::ImageRgba8 picture(truth.width, truth.height);
    workers.run(truth.height, [&](std::size_t row, std::size_t) {
        const auto y = static_cast<std::uint32_t>(row);
        for (std::uint32_t x = 0; x < truth.width; ++x) {
            const TruthPixel& pixel = truth.at(x, y);
            picture.at(x, y) = shader.at(x, y, pixel.id, pixel.distanceView).color;
        }
    });
    return picture;
}

image::ImageRgba8 orderByTruth(const image::ImageRgba8& picture, const image::ImageU32& ids,
                               const TruthImage& truth, const image::ImageRgba8& shaded) {
    image::requireSameSize(picture, ids, "truth picture");
    image::requireSameSize(picture, truth, "truth picture");
    image::requireSameSize(picture, shaded, "truth picture");
    image::ImageRgba8 ordered = picture;
    for (std::size_t i = 0; i < ordered.pixels.size(); ++i) {
        if (ids.pixels[i] != truth.pixels[i].id) {
            ordered.pixels[i] = shaded.pixels[i];
        }
    }
    return ordered;
}

} // namespace cdr::measure
