#include <cdr/measure/truth/mask_cut.h>
#include <cdr/measure/truth/surface_hit.h>
#include <cdr/measure/truth/surface_point.h>
#include <cdr/measure/truth/triangle_hit.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace cdr::measure {

namespace {

/// World axes, unit, of the triangle's front.
/// @param normal of the vertices, world axes, unit. @param basis of the instance.
glm::dvec3 bumpedAt(const SurfacePoint& point, const glm::dvec3& normal, const glm::dmat3& basis) {
    glm::dvec4 tangent(0.0);
    for (int c = 0; c < 3; ++c) {
        tangent += point.weights.here[c] * glm::dvec4(point.mesh.details.empty()
                                                          ? scene::VertexDetail{}.tangent
                                                          : point.mesh.details[point.index(c)].tangent);
    }
    const glm::dvec3 along = glm::normalize(basis * glm::dvec3(tangent));
    const double sense = std::copysign(1.0, tangent.w * glm::determinant(basis));
    const scene::MaterialDetail& detail = point.material.detail;
    const glm::dvec3 texel = glm::dvec3(point.sample(*detail.normal)) * 2.0 - 1.0;
    const double scale = std::clamp(detail.normalScale, -scene::kMaxNormalScale, scene::kMaxNormalScale);
    return glm::normalize(texel.x * scale * along + texel.y * scale * sense * glm::cross(normal, along) +
                          texel.z * normal);
}

/// Whether shading adds emission, and cuts off the sum. Of what is blended it does so with any texture of detail too.
bool addsEmission(const scene::Material& material) {
    if (material.alphaMode != scene::AlphaMode::blend) {
        return scene::hasEmission(material);
    }
    const scene::MaterialDetail& detail = material.detail;
    const bool isGlossy = detail.metallicRoughness && material.metallicRoughness;
    const bool hasTexture = isGlossy || detail.normal || detail.occlusion || detail.emissive;
    return detail.emission != glm::vec3(0.0f) || (!material.unlit && hasTexture);
}

glm::dvec3 emissionAt(const SurfacePoint& point) {
    const scene::MaterialDetail& detail = point.material.detail;
    const glm::dvec3 emission(detail.emission);
    return detail.emissive ? emission * glm::dvec3(point.sample(*detail.emissive)) : emission;
}

/// Adds to a hit on a lit surface what the material's detail says of its light.
/// @param side 1 for the front, -1 for the back.
void addLitDetail(const SurfacePoint& point, const glm::dmat3& basis, double side, SurfaceHit& hit) {
    const scene::MaterialDetail& detail = point.material.detail;
    if (detail.normal) {
        hit.normal = side * bumpedAt(point, side * hit.normal, basis);
    }
    if (detail.metallicRoughness && hit.metallicRoughness) {
        const glm::dvec4 texel = point.sample(*detail.metallicRoughness);
        hit.metallicRoughness->metallic *= static_cast<float>(texel.b);
        hit.metallicRoughness->roughness *= static_cast<float>(texel.g);
    }
    if (detail.occlusion) {
        hit.openness = 1.0 + detail.occlusionStrength * (point.sample(*detail.occlusion).r - 1.0);
    }
}

/// Whether the ray met the same edge through the triangle on its other side already.
bool isMetAgain(const SurfaceHit& hit, std::span<const SurfaceHit> before) {
    return hit.isOnEdge && std::any_of(before.begin(), before.end(), [&](const SurfaceHit& other) {
               return other.isOnEdge &&
                      std::abs(other.distanceView - hit.distanceView) <= 1e-12 * hit.distanceView;
           });
}

} // namespace

void appendHits(const scene::Scene& scene, const TruthTextures& textures, const VisibleInstance& visible,
                const PixelRay& pixel, const ViewRange& range, std::vector<SurfaceHit>& hits) {
    const scene::Instances& instances = scene.instances;
    const scene::Mesh& mesh = scene.meshes[instances.mesh[visible.instance]];
    const scene::Material& material = scene.materials[instances.material[visible.instance]];
    const glm::dmat3 toWorldNormal =
        glm::transpose(invertBasis(instances.basis[visible.instance])->worldToObject);
    // Start where the ray passes the mesh, as TriangleBvh::nearest() does.
    const ObjectRay ray = visible.camera.ray(pixel.slopeX, pixel.slopeY);
    const double shift = ray.shiftTo(glm::dvec3(0.0));
    const ShearedRay sheared(ray.from(shift));
    const std::size_t first = hits.size();
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const Triangle triangle = triangleOf(mesh, i);
        const double hit = shift + sheared.meet(triangle, visible.sides);
        if (!(hit < kNoHit) || !range.holds(hit)) {
            continue;
        }
        const SurfacePoint point{scene, textures, material,
                                 mesh,  i,        weightsOf(triangle, visible.camera, pixel, shift)};
        const glm::dvec3& weights = point.weights.here;
        glm::dvec4 baseColor = point.baseColor();
        if (material.alphaMode != scene::AlphaMode::blend) {
            baseColor = glm::min(baseColor, 1.0); // as scene::kMaxBaseColor says
        }
        if (material.alphaMode == scene::AlphaMode::mask && isCutAt(material, baseColor.a)) {
            continue;
        }
        const double side = sheared.meetsFront(triangle) ? 1.0 : -1.0;
        const glm::dvec3 facet = glm::cross(glm::dvec3(triangle[1]) - glm::dvec3(triangle[0]),
                                            glm::dvec3(triangle[2]) - glm::dvec3(triangle[0]));
        const glm::dvec3 normal =
            point.interpolate([](const scene::Vertex& vertex) { return glm::dvec3(vertex.normal); });
        SurfaceHit found{.distanceView = hit,
                         .layer = visible.layer,
                         .id = visible.id,
                         .instance = visible.instance,
                         .isBlended = material.alphaMode == scene::AlphaMode::blend,
                         .isUnlit = material.unlit,
                         .isOnEdge = weights.x == 0.0 || weights.y == 0.0 || weights.z == 0.0,
                         .facet = side * glm::normalize(toWorldNormal * facet),
                         .normal = side * glm::normalize(toWorldNormal * normal),
                         .baseColor = baseColor,
                         .metallicRoughness = material.metallicRoughness};
        if (addsEmission(material)) {
            found.emission = emissionAt(point);
        }
        if (scene::hasDetail(material) && !material.unlit) {
            addLitDetail(point, glm::dmat3(instances.basis[visible.instance]), side, found);
        }
        if (!isMetAgain(found, std::span(hits).subspan(first))) {
            hits.push_back(found);
        }
    }
}

} // namespace cdr::measure
