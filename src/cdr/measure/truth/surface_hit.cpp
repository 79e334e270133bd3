#include <cdr/image/srgb.h>
#include <cdr/measure/truth/surface_hit.h>
#include <cdr/measure/truth/triangle_hit.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace cdr::measure {

namespace {

glm::dvec4 texelAt(const scene::Texture& texture, std::int64_t x, std::int64_t y) {
    const auto wrap = [](std::int64_t i, std::int64_t size, bool repeats) {
        return repeats ? ((i % size) + size) % size : std::clamp<std::int64_t>(i, 0, size - 1);
    };
    const image::Rgba8& texel =
        texture.pixels.at(static_cast<std::uint32_t>(wrap(x, texture.pixels.width, texture.repeatU)),
                          static_cast<std::uint32_t>(wrap(y, texture.pixels.height, texture.repeatV)));
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

/// Whether the ray met the same edge through the triangle on its other side already.
bool isMetAgain(const SurfaceHit& hit, std::span<const SurfaceHit> before) {
    return hit.isOnEdge && std::any_of(before.begin(), before.end(), [&](const SurfaceHit& other) {
               return other.isOnEdge &&
                      std::abs(other.distanceView - hit.distanceView) <= 1e-12 * hit.distanceView;
           });
}

} // namespace

glm::dvec4 sampleTexture(const scene::Texture& texture, const glm::dvec2& uv) {
    const glm::dvec2 place = uv * glm::dvec2(texture.pixels.width, texture.pixels.height) - 0.5;
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
        const SurfaceHit found{.distanceView = hit,
                               .layer = visible.layer,
                               .id = visible.id,
                               .isBlended = material.alphaMode == scene::AlphaMode::blend,
                               .isUnlit = material.unlit,
                               .isOnEdge = weights.x == 0.0 || weights.y == 0.0 || weights.z == 0.0,
                               .facet = side * glm::normalize(toWorldNormal * facet),
                               .normal = side * glm::normalize(toWorldNormal * normal),
                               .baseColor = baseColor,
                               .shine = material.shine};
        if (!isMetAgain(found, std::span(hits).subspan(first))) {
            hits.push_back(found);
        }
    }
}

} // namespace cdr::measure
