#include <cdr/image/srgb.h>
#include <cdr/measure/truth/surface_hit.h>
#include <cdr/measure/truth/triangle_hit.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace cdr::measure {

namespace {

/// Where a texel beyond an edge is found.
std::uint32_t wrapped(std::int64_t i, std::int64_t size, bool repeats, bool mirrors) {
    if (!repeats) {
        return static_cast<std::uint32_t>(std::clamp<std::int64_t>(i, 0, size - 1));
    }
    const std::int64_t period = mirrors ? 2 * size : size;
    const std::int64_t inPeriod = ((i % period) + period) % period;
    return static_cast<std::uint32_t>(inPeriod < size ? inPeriod : period - 1 - inPeriod);
}

glm::dvec4 texelAt(const scene::Texture& texture, std::int64_t x, std::int64_t y) {
    const image::Rgba8& texel =
        texture.pixels.at(wrapped(x, texture.pixels.width, texture.repeatU, texture.mirrorU),
                          wrapped(y, texture.pixels.height, texture.repeatV, texture.mirrorV));
    if (texture.content == scene::TextureContent::data) {
        return glm::dvec4(texel[0], texel[1], texel[2], texel[3]) / 255.0;
    }
    const auto& linear = image::linearOfSrgb();
    return {linear[texel[0]], linear[texel[1]], linear[texel[2]], texel[3] / 255.0};
}

/// A value of the mesh's vertices at a hit.
template <typename Value>
auto interpolate(const scene::Mesh& mesh, std::size_t triangle, const glm::dvec3& weights, Value valueOf) {
    const std::uint32_t* corner = &mesh.indices[triangle];
    return weights.x * valueOf(mesh.vertices[corner[0]]) + weights.y * valueOf(mesh.vertices[corner[1]]) +
           weights.z * valueOf(mesh.vertices[corner[2]]);
}

glm::dvec4 baseColorAt(const scene::Scene& scene, const scene::Material& material, const scene::Mesh& mesh,
                       std::size_t triangle, const glm::dvec3& weights) {
    glm::dvec4 color(material.baseColorFactor);
    color *= interpolate(mesh, triangle, weights,
                         [](const scene::Vertex& vertex) { return glm::dvec4(vertex.color) / 255.0; });
    if (material.baseColorTexture) {
        color *= sampleTexture(scene.textures.at(*material.baseColorTexture),
                               interpolate(mesh, triangle, weights, [](const scene::Vertex& vertex) {
                                   return glm::dvec2(vertex.uv);
                               }));
    }
    return color;
}

/// A point of a triangle whose material may have detail.
struct DetailedPoint {
    const scene::Scene& scene;
    const scene::Material& material;
    const scene::Mesh& mesh;
    std::size_t triangle;
    glm::dvec3 weights;

    /// What a texture of the material holds there.
    glm::dvec4 sample(const scene::TextureUse& use) const {
        glm::dvec2 uv(0.0);
        for (int c = 0; c < 3; ++c) {
            const std::uint32_t corner = mesh.indices[triangle + static_cast<std::size_t>(c)];
            if (!use.second) {
                uv += weights[c] * glm::dvec2(mesh.vertices[corner].uv);
            } else if (!mesh.details.empty()) {
                uv += weights[c] * glm::dvec2(mesh.details[corner].uv);
            }
        }
        return sampleTexture(scene.textures.at(use.texture), uv);
    }

    /// World axes, unit, of the triangle's front.
    /// @param normal of the vertices, world axes, unit. @param basis of the instance.
    glm::dvec3 bumped(const glm::dvec3& normal, const glm::dmat3& basis) const {
        glm::dvec4 tangent(0.0);
        for (int c = 0; c < 3; ++c) {
            const std::uint32_t corner = mesh.indices[triangle + static_cast<std::size_t>(c)];
            tangent += weights[c] * glm::dvec4(mesh.details.empty() ? scene::VertexDetail{}.tangent
                                                                    : mesh.details[corner].tangent);
        }
        const glm::dvec3 along = glm::normalize(basis * glm::dvec3(tangent));
        const double sense = std::copysign(1.0, tangent.w * glm::determinant(basis));
        const glm::dvec3 texel = glm::dvec3(sample(*material.detail.normal)) * 2.0 - 1.0;
        const double scale = material.detail.normalScale;
        return glm::normalize(texel.x * scale * along + texel.y * scale * sense * glm::cross(normal, along) +
                              texel.z * normal);
    }
};

/// Adds to a hit what the material's detail says of it.
/// @param side 1 for the front, -1 for the back.
void addDetail(const DetailedPoint& point, const glm::dmat3& basis, double side, SurfaceHit& hit) {
    const scene::MaterialDetail& detail = point.material.detail;
    if (detail.normal) {
        hit.normal = side * point.bumped(side * hit.normal, basis);
    }
    if (detail.metallicRoughness && hit.shine) {
        const glm::dvec4 texel = point.sample(*detail.metallicRoughness);
        hit.shine->metallic *= static_cast<float>(texel.b);
        hit.shine->roughness *= static_cast<float>(texel.g);
    }
    if (detail.occlusion) {
        hit.openness = 1.0 + detail.occlusionStrength * (point.sample(*detail.occlusion).r - 1.0);
    }
    hit.emission = glm::dvec3(detail.emission);
    if (detail.emissive) {
        hit.emission *= glm::dvec3(point.sample(*detail.emissive));
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

glm::dvec4 sampleTexture(const scene::Texture& texture, const glm::dvec2& uv) {
    const glm::dvec2 size(texture.pixels.width, texture.pixels.height);
    if (texture.nearest) {
        const glm::dvec2 texel = glm::floor(uv * size);
        return texelAt(texture, static_cast<std::int64_t>(texel.x), static_cast<std::int64_t>(texel.y));
    }
    const glm::dvec2 place = uv * size - 0.5;
    const glm::dvec2 corner = glm::floor(place);
    const glm::dvec2 share = place - corner;
    const auto x = static_cast<std::int64_t>(corner.x);
    const auto y = static_cast<std::int64_t>(corner.y);
    return glm::mix(glm::mix(texelAt(texture, x, y), texelAt(texture, x + 1, y), share.x),
                    glm::mix(texelAt(texture, x, y + 1), texelAt(texture, x + 1, y + 1), share.x), share.y);
}

void appendHits(const scene::Scene& scene, const VisibleInstance& visible, const ObjectRay& ray,
                const ViewRange& range, std::vector<SurfaceHit>& hits) {
    const scene::Instances& instances = scene.instances;
    const scene::Mesh& mesh = scene.meshes[instances.mesh[visible.instance]];
    const scene::Material& material = scene.materials[instances.material[visible.instance]];
    const glm::dmat3 toWorldNormal =
        glm::transpose(invertBasis(instances.basis[visible.instance])->worldToObject);
    // Start where the ray passes the mesh, as TriangleBvh::nearest() does.
    const double shift = -glm::dot(ray.origin, ray.direction) / glm::dot(ray.direction, ray.direction);
    const ObjectRay local{ray.origin + shift * ray.direction, ray.direction};
    const ShearedRay sheared(local);
    const std::size_t first = hits.size();
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const Triangle triangle{mesh.vertices[mesh.indices[i]].position,
                                mesh.vertices[mesh.indices[i + 1]].position,
                                mesh.vertices[mesh.indices[i + 2]].position};
        const double hit = shift + sheared.meet(triangle, visible.doubleSided);
        if (!(hit < kNoHit) || !range.holds(hit)) {
            continue;
        }
        const glm::dvec3 weights = sheared.weights(triangle);
        const glm::dvec4 baseColor = baseColorAt(scene, material, mesh, i, weights);
        if (material.alphaMode == scene::AlphaMode::mask &&
            baseColor.a < static_cast<double>(material.alphaCutoff)) {
            continue;
        }
        const double side = sheared.meetsFront(triangle) ? 1.0 : -1.0;
        const glm::dvec3 facet = glm::cross(glm::dvec3(triangle[1]) - glm::dvec3(triangle[0]),
                                            glm::dvec3(triangle[2]) - glm::dvec3(triangle[0]));
        const glm::dvec3 normal = interpolate(
            mesh, i, weights, [](const scene::Vertex& vertex) { return glm::dvec3(vertex.normal); });
        SurfaceHit found{.distanceView = hit,
                         .layer = visible.layer,
                         .id = visible.id,
                         .isBlended = material.alphaMode == scene::AlphaMode::blend,
                         .isUnlit = material.unlit,
                         .isOnEdge = weights.x == 0.0 || weights.y == 0.0 || weights.z == 0.0,
                         .facet = side * glm::normalize(toWorldNormal * facet),
                         .normal = side * glm::normalize(toWorldNormal * normal),
                         .baseColor = baseColor,
                         .shine = material.shine};
        if (scene::hasDetail(material)) {
            addDetail({scene, material, mesh, i, weights}, glm::dmat3(instances.basis[visible.instance]),
                      side, found);
        }
        if (!isMetAgain(found, std::span(hits).subspan(first))) {
            hits.push_back(found);
        }
    }
}

} // namespace cdr::measure
