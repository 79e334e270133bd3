#include <cdr/base/format_error.h>
#include <cdr/scene/world/check.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

namespace cdr::scene {

namespace {

template <typename... Values>
[[noreturn]] void refuseUse(fmt::format_string<Values...> format, Values&&... values) {
    throw base::inputError(format, std::forward<Values>(values)...);
}

// With these an instance's radius is a finite float.
constexpr float kMaxSquare = 1e34f;
constexpr float kMaxRadius = 1e20f;

template <typename Vector>
bool areFinite(const Vector& v) {
    for (glm::length_t i = 0; i < v.length(); ++i) {
        if (!std::isfinite(v[i])) {
            return false;
        }
    }
    return true;
}

bool isSize(float value) {
    return std::isfinite(value) && value >= 0.0f;
}

void requireIndices(const std::vector<std::uint32_t>& indices, std::size_t vertices,
                    const std::string& what) {
    if (indices.size() % 3 != 0) {
        refuseUse("{}: {} indices are no whole number of triangles", what, indices.size());
    }
    const auto largest = std::max_element(indices.begin(), indices.end());
    if (largest != indices.end() && *largest >= vertices) {
        refuseUse("{}: index {} is beyond its {} vertices", what, *largest, vertices);
    }
}

bool isSphere(const ClusterSphere& sphere) {
    return areFinite(sphere.centre) && isSize(sphere.radius);
}

/// A longer axis would hide triangles that face the camera. Without a cone it is 0.
bool isCone(const glm::vec3& axis, float cutoff) {
    return glm::length(axis) < 1.0001f && cutoff >= 0.0f && cutoff <= 1.0f;
}

void requireClusters(const ClusterTree& tree, std::size_t vertices, const std::string& what) {
    requireIndices(tree.indices, vertices, what);
    const auto isRun = [](std::size_t first, std::size_t count, std::size_t all) {
        return first <= all && count <= all - first;
    };
    for (const MeshCluster& cluster : tree.clusters) {
        const bool isInPlace = isRun(cluster.firstIndex, cluster.indexCount, tree.indices.size()) &&
                               cluster.firstIndex % 3 == 0 && cluster.indexCount % 3 == 0;
        const auto isGroup = [&](std::uint32_t group) {
            return group == kNoGroup || group < tree.groups.size();
        };
        if (!isInPlace || !isGroup(cluster.madeBy) || !isGroup(cluster.coarserBy)) {
            refuseUse("{}: a cluster refers to indices or groups that are not there", what);
        }
        if (!isSphere(cluster.bounds)) {
            refuseUse("{}: the sphere of a cluster must be finite and its radius 0 or more", what);
        }
        if (!isCone(cluster.coneAxis, cluster.coneCutoff)) {
            refuseUse("{}: the cone of a cluster must have an axis of length 1 and a cutoff in [0, 1]", what);
        }
    }
    for (const ClusterGroup& group : tree.groups) {
        if (!isRun(group.firstCluster, group.clusterCount, tree.clusters.size())) {
            refuseUse("{}: a group of clusters refers to clusters that are not there", what);
        }
        if (!isSphere(group.bounds)) {
            refuseUse("{}: the sphere of a group of clusters must be finite and its radius 0 or more", what);
        }
        if (!isSize(group.error)) {
            refuseUse("{}: the error of a group of clusters must be finite and 0 or more, not {}", what,
                      group.error);
        }
    }
}

void requireInstance(const Scene& scene, std::size_t i) {
    const Instances& instances = scene.instances;
    const std::string what = "instance " + std::to_string(i);
    if (instances.mesh[i] >= scene.meshes.size()) {
        refuseUse("{}: mesh {} is not there, the scene has {}", what, instances.mesh[i], scene.meshes.size());
    }
    if (instances.material[i] >= scene.materials.size()) {
        refuseUse("{}: material {} is not there, the scene has {}", what, instances.material[i],
                  scene.materials.size());
    }
    if (instances.object[i] > kMaxObjects) {
        refuseUse("{}: object {} is over the limit of {}", what, instances.object[i], kMaxObjects);
    }
    requireUsable({instances.position(i), instances.basis[i]}, what);
    if (instances.radius[i] != kNoRadius && !isSize(instances.radius[i])) {
        refuseUse("{}: its radius must be finite and 0 or more, not {}", what, instances.radius[i]);
    }
}

bool isLight(const glm::vec3& color) {
    return areFinite(color) && glm::all(glm::greaterThanEqual(color, glm::vec3(0.0f)));
}

void requireSky(const Sky& sky) {
    for (const glm::vec3& color : {sky.zenith, sky.horizon, sky.ground}) {
        if (!isLight(color)) {
            refuseUse("the sky's colours must be finite and 0 or more");
        }
    }
    if (!(std::abs(glm::length(sky.up) - 1.0) < 1e-6)) {
        refuseUse("the sky's up must be of length 1");
    }
}

void requireAir(const Air& air) {
    const auto isScattering = [](const AirPart& part) {
        return areFinite(part.scattering) &&
               glm::all(glm::greaterThanEqual(part.scattering, glm::vec3(0.0f))) &&
               std::isfinite(part.height) && part.height > 0.0;
    };
    if (!isScattering(air.molecules) || !isScattering(air.haze)) {
        refuseUse("the air must scatter a finite share of 0 or more, and its heights must be above 0");
    }
    if (!areFinite(air.centre) || !(std::isfinite(air.radius) && air.radius > 0.0)) {
        refuseUse("the air's planet must be at a finite place and have a radius above 0");
    }
    if (!(air.flattening >= 0.0 && air.flattening <= 0.1) ||
        !(air.hazeAhead >= 0.0 && air.hazeAhead <= 0.95)) {
        refuseUse(
            "the air's flattening must lie in 0 to 0.1, and how much its haze scatters ahead in 0 to 0.95");
    }
    for (const glm::dvec3& direction : {air.axis, air.toSun}) {
        if (!(std::abs(glm::length(direction) - 1.0) < 1e-6)) {
            refuseUse("the air's axis and its way to the Sun must be of length 1");
        }
    }
    if (!isLight(air.sunlight)) {
        refuseUse("the air's sunlight must be finite and 0 or more");
    }
}

void requireSurroundings(const std::optional<Sky>& sky, const std::optional<Air>& air) {
    if (sky) {
        requireSky(*sky);
    }
    if (air) {
        requireAir(*air);
    }
}

void requireCone(const LightCone& cone, const std::string& what) {
    if (!(std::abs(glm::length(cone.direction) - 1.0) < 1e-6)) {
        refuseUse("{}: the direction of its cone must be of length 1", what);
    }
    if (!(cone.inner >= 0.0 && cone.inner < cone.outer && cone.outer <= 0.5 * std::numbers::pi)) {
        refuseUse("{}: its cone's angles must be 0 <= inner < outer <= half pi, not {} and {}", what,
                  cone.inner, cone.outer);
    }
}

void requireWhole(const Instances& instances) {
    const std::size_t size = instances.size();
    for (const std::size_t each :
         {instances.y.size(), instances.z.size(), instances.radius.size(), instances.basis.size(),
          instances.mesh.size(), instances.material.size(), instances.object.size()}) {
        if (each != size) {
            refuseUse("the instances' arrays must be equally long, but hold {} and {}", size, each);
        }
    }
}

} // namespace

bool isUsable(const Transform& transform) {
    const glm::mat3& basis = transform.basis;
    const auto isShort = [](const glm::vec3& column) { return glm::dot(column, column) <= kMaxSquare; };
    return areFinite(transform.position) && isShort(basis[0]) && isShort(basis[1]) && isShort(basis[2]);
}

void requireUsable(const Transform& transform, const std::string& what) {
    if (!areFinite(transform.position)) {
        refuseUse("{}: its position must be finite", what);
    }
    if (!isUsable(transform)) {
        refuseUse("{}: its basis must be finite, with columns no longer than 1e17", what);
    }
}

void requireUsable(const PointLight& light, const std::string& what) {
    if (!areFinite(light.position) || !isLight(light.color)) {
        refuseUse("{}: its position and colour must be finite, and its colour 0 or more", what);
    }
    if (!std::isfinite(light.halfDistance) || light.halfDistance <= 0.0) {
        refuseUse("{}: its half distance must be finite and above 0, not {}", what, light.halfDistance);
    }
    if (light.range && !(*light.range > 0.0 && std::isfinite(*light.range))) {
        refuseUse("{}: its range must be finite and above 0, not {}", what, *light.range);
    }
    if (light.cone) {
        requireCone(*light.cone, what);
    }
}

void requireUsable(const Mesh& mesh, const std::string& what) {
    requireIndices(mesh.indices, mesh.vertices.size(), what);
    if (mesh.levels.size() > kMaxLevels) {
        refuseUse("{}: {} levels of detail, {} are the most", what, mesh.levels.size(), kMaxLevels);
    }
    for (const MeshLevel& level : mesh.levels) {
        requireIndices(level.indices, mesh.vertices.size(), what);
        if (!isSize(level.error)) {
            refuseUse("{}: the error of a level of detail must be finite and 0 or more, not {}", what,
                      level.error);
        }
    }
    requireClusters(mesh.clusters, mesh.vertices.size(), what);
    if (mesh.boxHalfSides && !(areFinite(*mesh.boxHalfSides) &&
                               glm::all(glm::greaterThanEqual(*mesh.boxHalfSides, glm::vec3(0.0f))))) {
        refuseUse("{}: the half sides of its box must be finite and 0 or more", what);
    }
    requireUsable(mesh.details, mesh.vertices.size(), what);
    requireUsable(mesh.vertices, mesh.boundingRadius, what);
}

void requireUsable(std::span<const VertexDetail> details, std::size_t vertices, const std::string& what) {
    if (!details.empty() && details.size() != vertices) {
        refuseUse("{}: {} details for {} vertices", what, details.size(), vertices);
    }
    for (const VertexDetail& detail : details) {
        if (!areFinite(detail.tangent) || !areFinite(detail.uv)) {
            refuseUse("{}: its vertices must be finite", what);
        }
    }
}

void requireUsable(std::span<const Vertex> vertices, float boundingRadius, const std::string& what) {
    if (!(boundingRadius >= 0.0f && boundingRadius <= kMaxRadius)) {
        refuseUse("{}: its bounding radius must lie in [0, 1e20], not {}", what, boundingRadius);
    }
    // What is beyond by roundings is culled right as well, since an instance's radius has slack.
    const double most = static_cast<double>(boundingRadius) * 1.00001;
    for (const Vertex& vertex : vertices) {
        if (!areFinite(vertex.position) || !areFinite(vertex.normal) || !areFinite(vertex.uv)) {
            refuseUse("{}: its vertices must be finite", what);
        }
        const double distance =
            glm::length(glm::dvec3(vertex.position)); // squares of floats may be 0 or infinite
        if (!(distance <= most)) {
            refuseUse("{}: a vertex is {} from its origin, beyond its bounding radius of {}", what, distance,
                      boundingRadius);
        }
    }
}

void requireUsable(const Environment& environment) {
    for (const glm::vec3& color : {environment.ambient, environment.background}) {
        if (!isLight(color)) {
            refuseUse("ambient light and background must be finite and 0 or more");
        }
    }
    requireSurroundings(environment.sky, environment.air);
}

void requireUsable(const Texture& texture, const std::string& what) {
    const image::ImageRgba8& pixels = texture.pixels;
    if (pixels.width == 0 || pixels.height == 0 ||
        pixels.pixels.size() != std::size_t{pixels.width} * pixels.height) {
        refuseUse("{}: {} pixels are no picture of {}x{}", what, pixels.pixels.size(), pixels.width,
                  pixels.height);
    }
    if (texture.cutoff && !(*texture.cutoff > 0.0f && *texture.cutoff <= 1.0f)) {
        refuseUse("{}: its cutoff must lie in (0, 1], not {}", what, *texture.cutoff);
    }
}

void requireUsable(const Material& material, std::size_t textures, const std::string& what) {
    forEachTexture(material, [&](std::uint32_t texture) {
        if (texture >= textures) {
            refuseUse("{}: texture {} is not there, the scene has {}", what, texture, textures);
        }
    });
    if (!areFinite(material.baseColorFactor) || !std::isfinite(material.alphaCutoff)) {
        refuseUse("{}: its base colour and alpha cutoff must be finite", what);
    }
    if (!glm::all(glm::greaterThanEqual(material.baseColorFactor, glm::vec4(0.0f)))) {
        refuseUse("{}: its base colour must be 0 or more", what);
    }
    // Colours may be above 1, since textures multiply them, but no surface is more than opaque.
    if (material.baseColorFactor.a > 1.0f) {
        refuseUse("{}: the alpha of its base colour must lie in [0, 1], not {}", what,
                  material.baseColorFactor.a);
    }
    if (!std::isfinite(material.layer)) {
        refuseUse("{}: its layer must be finite", what);
    }
    const auto isShare = [](float value) { return value >= 0.0f && value <= 1.0f; };
    if (material.metallicRoughness &&
        (!isShare(material.metallicRoughness->metallic) || !isShare(material.metallicRoughness->roughness))) {
        refuseUse("{}: its metallic and roughness must lie in [0, 1]", what);
    }
    const MaterialDetail& detail = material.detail;
    for (const auto& use : {detail.metallicRoughness, detail.normal, detail.occlusion, detail.emissive}) {
        if (use &&
            !(areFinite(use->transform[0]) && areFinite(use->transform[1]) && areFinite(use->transform[2]))) {
            refuseUse("{}: the transforms of its textures must be finite", what);
        }
    }
    if (!isShare(detail.occlusionStrength) || !std::isfinite(detail.normalScale) ||
        !areFinite(detail.emission) || !glm::all(glm::greaterThanEqual(detail.emission, glm::vec3(0.0f)))) {
        refuseUse(
            "{}: its normal scale must be finite, its occlusion strength in [0, 1], its emission 0 or more",
            what);
    }
}

void requireUsable(const Scene& scene) {
    requireWhole(scene.instances);
    const auto requireAll = [](const auto& values, const char* kind, auto... more) {
        for (std::size_t i = 0; i < values.size(); ++i) {
            requireUsable(values[i], more..., kind + std::to_string(i));
        }
    };
    requireAll(scene.meshes, "mesh ");
    requireAll(scene.textures, "texture ");
    requireAll(scene.materials, "material ", scene.textures.size());
    requireAll(scene.lights, "light ");
    requireUsable({scene.ambient, scene.background, scene.sky, scene.air});
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        requireInstance(scene, i);
    }
}

} // namespace cdr::scene
