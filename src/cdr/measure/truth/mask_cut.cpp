#include <cdr/measure/truth/mask_cut.h>
#include <cdr/measure/truth/triangle_hit.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace cdr::measure {

namespace {

/// Texels, levels and the weights between texels have 8 bits each on a device.
constexpr double kAlphaError = 4.0 / 255.0;

/// A ray that is cast at a masked instance.
struct MaskedRay {
    const scene::Scene& scene;
    const TruthTextures& textures;
    MaskedInstance masked;
    ObjectRay ray;
    ViewRange range;

    const scene::Mesh& mesh() const { return scene.meshes[scene.instances.mesh[masked.instance]]; }
    const scene::Material& material() const {
        return scene.materials[scene.instances.material[masked.instance]];
    }
    /// Where the ray passes the mesh. Weights are taken from there, as TriangleBvh::nearest() does.
    double shift() const { return ray.shiftTo(glm::dvec3(0.0)); }
};

/// For a mesh that has no tree of triangles: a box, which has few.
double nearestOfAll(const MaskedRay& cast, const TriangleBvh::Keeps& keeps) {
    const scene::Mesh& mesh = cast.mesh();
    const ShearedRay sheared(cast.ray.from(cast.shift()));
    double best = kNoHit;
    for (std::uint32_t first = 0; first + 2 < mesh.indices.size(); first += 3) {
        const double hit = cast.shift() + sheared.meet(triangleOf(mesh, first), cast.masked.sides);
        if (hit < best && cast.range.holds(hit) && keeps(first, hit)) {
            best = hit;
        }
    }
    return best;
}

/// @param weightsAt CornerWeights of a triangle.
template <typename WeightsAt>
MaskedHit nearestKept(const MaskedRay& cast, const WeightsAt& weightsAt) {
    const scene::Mesh& mesh = cast.mesh();
    MaskedHit found;
    const auto keeps = [&](std::uint32_t first, double hitView) {
        const MaskCut cut = maskCutAt(
            {cast.scene, cast.textures, cast.material(), mesh, first, weightsAt(triangleOf(mesh, first))});
        found.doubtView = cut.isDoubtful ? std::min(found.doubtView, hitView) : found.doubtView;
        return !cut.isCut;
    };
    const TriangleBvh* triangles = cast.masked.shape.triangles();
    found.distanceView = triangles != nullptr
                             ? triangles->nearest(cast.ray, cast.masked.sides, cast.range, keeps)
                             : nearestOfAll(cast, keeps);
    found.doubtView = found.doubtView <= found.distanceView ? found.doubtView : kNoHit;
    return found;
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
    const auto isFinite = [](double each) { return std::isfinite(each); };
    if (!std::isfinite(alpha) || !std::ranges::all_of(others, isFinite)) {
        return {.isCut = isCutAt(point.material, alpha), .isDoubtful = true};
    }
    const auto [least, most] = std::minmax_element(others.begin(), others.end());
    return {.isCut = isCutAt(point.material, alpha),
            .isDoubtful = isCutAt(point.material, std::min(alpha, *least) - kAlphaError) !=
                          isCutAt(point.material, std::max(alpha, *most) + kAlphaError)};
}

MaskedHit nearestKept(const scene::Scene& scene, const TruthTextures& textures, const MaskedInstance& masked,
                      const WideRay& wide, const ViewRange& range) {
    const MaskedRay cast{scene, textures, masked, wide.ray, range};
    const double shift = cast.shift();
    const auto weights = [&](const Triangle& triangle, const glm::dvec3& aside) {
        const ObjectRay ray{wide.ray.origin + aside, wide.ray.direction};
        return ShearedRay(ray.from(shift)).weights(triangle);
    };
    return nearestKept(cast, [&](const Triangle& triangle) {
        return CornerWeights{weights(triangle, glm::dvec3(0.0)), weights(triangle, wide.right),
                             weights(triangle, -wide.right), weights(triangle, -wide.up),
                             weights(triangle, wide.up)};
    });
}

MaskedHit nearestKept(const scene::Scene& scene, const TruthTextures& textures,
                      const VisibleInstance& visible, const PixelRay& pixel, const ViewRange& range) {
    const MaskedRay cast{scene,
                         textures,
                         {visible.instance, *visible.shape, visible.sides},
                         visible.camera.ray(pixel.slopeX, pixel.slopeY),
                         range};
    const double shift = cast.shift();
    return nearestKept(
        cast, [&](const Triangle& triangle) { return weightsOf(triangle, visible.camera, pixel, shift); });
}

bool MaskedPixels::cutsAt(std::uint32_t first, std::uint32_t x, std::uint32_t y) const {
    const scene::Mesh& mesh = scene.meshes[scene.instances.mesh[visible.instance]];
    const scene::Material& material = scene.materials[scene.instances.material[visible.instance]];
    const PixelRay pixel{slopes.x[x], slopes.y[y], slopes.step};
    const double shift = visible.camera.ray(pixel.slopeX, pixel.slopeY).shiftTo(glm::dvec3(0.0));
    const SurfacePoint point{scene,    textures,
                             material, mesh,
                             first,    weightsOf(triangleOf(mesh, first), visible.camera, pixel, shift)};
    return material.alphaCutoff > 0.0f && isCutAt(material, point.baseColor().a);
}

} // namespace cdr::measure
