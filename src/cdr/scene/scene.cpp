#include <cdr/base/format_error.h>
#include <cdr/scene/scene.h>
#include <cdr/scene/world/check.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace cdr::scene {

namespace {

/// An upper bound of the factor by which `basis` stretches a vector: exact for orthogonal columns (rotation
/// and scale), else the Frobenius norm. For components of about 1.
float stretchOf(const glm::mat3& basis) {
    // One root: the longest column is the one of the largest square.
    const float longest = std::sqrt(
        std::max({glm::dot(basis[0], basis[0]), glm::dot(basis[1], basis[1]), glm::dot(basis[2], basis[2])}));
    const float skew =
        std::max({std::abs(glm::dot(basis[0], basis[1])), std::abs(glm::dot(basis[1], basis[2])),
                  std::abs(glm::dot(basis[2], basis[0]))});
    if (skew <= 1e-6f * longest * longest) {
        // The slack covers the rounding of columns that are orthogonal only nearly.
        return longest * 1.00001f;
    }
    return std::sqrt(glm::dot(basis[0], basis[0]) + glm::dot(basis[1], basis[1]) +
                     glm::dot(basis[2], basis[2]));
}

/// The same for small ones too.
float largestStretch(const glm::mat3& basis) {
    const float stretch = stretchOf(basis);
    constexpr float kSquared = 1e-15f;
    if (stretch > kSquared) {
        return stretch;
    }
    // Squares may have been 0. A power of two rounds nothing.
    float largest = 0.0f;
    for (glm::length_t column = 0; column < 3; ++column) {
        const glm::vec3 lengths = glm::abs(basis[column]);
        largest = std::max({largest, lengths.x, lengths.y, lengths.z});
    }
    if (!(largest > 0.0f)) {
        return stretch;
    }
    const double scale = std::exp2(std::ilogb(largest));
    return static_cast<float>(static_cast<double>(stretchOf(glm::mat3(glm::dmat3(basis) / scale))) * scale);
}

float placedRadius(const Scene& scene, std::uint32_t mesh, const glm::mat3& basis) {
    if (mesh >= scene.meshes.size()) {
        throw base::inputError(
            "scene: mesh {} of an instance is not there, the scene has {}; add meshes before their instances",
            mesh, scene.meshes.size());
    }
    return scene.meshes[mesh].boundingRadius * largestStretch(basis);
}

/// Radii to a directional light, and how many times farther one would be that is half as strong.
constexpr double kFarAway = 1e6;
constexpr double kFadesAfter = 1e3;

} // namespace

PointLight directionalLight(const glm::dvec3& direction, const glm::vec3& color, const glm::dvec3& centre,
                            double radius) {
    const double distance = kFarAway * radius;
    // A length of squares would be 0 or infinite for directions of extreme lengths.
    const double largest = std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)});
    if (!(largest > 0.0 && std::isfinite(glm::dot(direction / largest, direction / largest)))) {
        throw base::InputError("a directional light needs a direction whose length is above 0 and finite");
    }
    if (!(radius > 0.0 && std::isfinite(kFadesAfter * distance))) {
        throw base::inputError("a directional light needs a radius that is above 0 and finite, not {}",
                               radius);
    }
    const PointLight light{.position = centre - glm::normalize(direction / largest) * distance,
                           .color = color,
                           .halfDistance = kFadesAfter * distance};
    requireUsable(light, "directional light");
    return light;
}

std::vector<std::uint32_t> shadowLights(const std::vector<PointLight>& lights) {
    std::vector<std::uint32_t> casting;
    for (std::uint32_t i = 0; i < lights.size() && casting.size() < kMaxShadowLights; ++i) {
        if (lights[i].castsShadows) {
            casting.push_back(i);
        }
    }
    return casting;
}

std::uint32_t Scene::objectCount() const {
    const auto last = std::max_element(instances.object.begin(), instances.object.end());
    return last == instances.object.end() ? 0 : *last + 1;
}

void addInstance(Scene& scene, std::uint32_t mesh, std::uint32_t material, std::uint32_t object,
                 const glm::dvec3& position, const glm::mat3& basis) {
    const float radius = placedRadius(scene, mesh, basis);
    Instances& instances = scene.instances;
    instances.x.push_back(position.x);
    instances.y.push_back(position.y);
    instances.z.push_back(position.z);
    instances.radius.push_back(radius);
    instances.basis.push_back(basis);
    instances.mesh.push_back(mesh);
    instances.material.push_back(material);
    instances.object.push_back(object);
}

void placeInstance(Scene& scene, std::size_t i, const glm::dvec3& position, const glm::mat3& basis) {
    Instances& instances = scene.instances;
    const float radius = placedRadius(scene, instances.mesh[i], basis);
    instances.x[i] = position.x;
    instances.y[i] = position.y;
    instances.z[i] = position.z;
    instances.radius[i] = radius;
    instances.basis[i] = basis;
}

void swapInstances(Instances& instances, std::size_t a, std::size_t b) {
    std::swap(instances.x[a], instances.x[b]);
    std::swap(instances.y[a], instances.y[b]);
    std::swap(instances.z[a], instances.z[b]);
    std::swap(instances.radius[a], instances.radius[b]);
    std::swap(instances.basis[a], instances.basis[b]);
    std::swap(instances.mesh[a], instances.mesh[b]);
    std::swap(instances.material[a], instances.material[b]);
    std::swap(instances.object[a], instances.object[b]);
}

} // namespace cdr::scene
