#include <cdr/measure/truth/mask_cut.h>
#include <cdr/measure/truth/triangle_hit.h>

#include <algorithm>
#include <array>
#include <cstdint>

namespace cdr::measure {

namespace {

/// Texels, levels and the weights between texels have 8 bits each on a device.
constexpr double kAlphaError = 4.0 / 255.0;

Triangle triangleOf(const scene::Mesh& mesh, std::uint32_t first) {
    return {mesh.vertices[mesh.indices[first]].position, mesh.vertices[mesh.indices[first + 1]].position,
            mesh.vertices[mesh.indices[first + 2]].position};
}

/// For a mesh that has no tree of triangles: a box, which has few.
double nearestOfAll(const scene::Mesh& mesh, const ObjectRay& ray, double shift, Sidedness sides,
                    const ViewRange& range, const TriangleBvh::Keeps& keeps) {
    const ShearedRay sheared({ray.origin + shift * ray.direction, ray.direction});
    double best = kNoHit;
    for (std::uint32_t first = 0; first + 2 < mesh.indices.size(); first += 3) {
        const double hit = shift + sheared.meet(triangleOf(mesh, first), sides);
        if (hit < best && range.holds(hit) && keeps(first, hit)) {
            best = hit;
        }
    }
    return best;
}

} // namespace

MaskCut maskCutAt(const SurfacePoint& point) {
    const auto alphaAt = [&](const glm::dvec3& shares, double width) {
        return point.baseColorAt(shares, width).a;
    };
    const CornerWeights& weights = point.weights;
    const double alpha = alphaAt(weights.here, 1.0);
    if (!(point.material.alphaCutoff > 0.0f)) {
        return {}; // no alpha is less
    }
    constexpr double kHalfLevel = 1.4142135623730951;
    const std::array others{alphaAt(weights.here, kHalfLevel), alphaAt(weights.here, 1.0 / kHalfLevel),
                            alphaAt(weights.right, 1.0),       alphaAt(weights.left, 1.0),
                            alphaAt(weights.down, 1.0),        alphaAt(weights.up, 1.0)};
    const auto [least, most] = std::minmax_element(others.begin(), others.end());
    return {.isCut = isCutAt(point.material, alpha),
            .isDoubtful = isCutAt(point.material, std::min(alpha, *least) - kAlphaError) !=
                          isCutAt(point.material, std::max(alpha, *most) + kAlphaError)};
}

MaskedHit nearestKept(const scene::Scene& scene, const TruthTextures& textures,
                      const VisibleInstance& visible, const PixelRay& pixel, const ViewRange& range) {
    const scene::Mesh& mesh = scene.meshes[scene.instances.mesh[visible.instance]];
    const scene::Material& material = scene.materials[scene.instances.material[visible.instance]];
    const ObjectRay ray = visible.camera.ray(pixel.slopeX, pixel.slopeY);
    // Start where the ray passes the mesh, as TriangleBvh::nearest() does.
    const double shift = -glm::dot(ray.origin, ray.direction) / glm::dot(ray.direction, ray.direction);
    MaskedHit found;
    const auto keeps = [&](std::uint32_t first, double hitView) {
        const MaskCut cut = maskCutAt({scene, textures, material, mesh, first,
                                       weightsOf(triangleOf(mesh, first), visible.camera, pixel, shift)});
        found.doubtView = cut.isDoubtful ? std::min(found.doubtView, hitView) : found.doubtView;
        return !cut.isCut;
    };
    const TriangleBvh* triangles = visible.shape->triangles();
    found.distanceView = triangles != nullptr ? triangles->nearest(ray, visible.sides, range, keeps)
                                              : nearestOfAll(mesh, ray, shift, visible.sides, range, keeps);
    found.doubtView = found.doubtView <= found.distanceView ? found.doubtView : kNoHit;
    return found;
}

} // namespace cdr::measure
