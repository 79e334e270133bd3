#include <cdr/image/srgb.h>
#include <cdr/measure/truth/truth_light.h>
#include <cdr/measure/truth/truth_metallic_roughness.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace cdr::measure {

namespace {

glm::dvec3 skyAlong(const scene::Sky& sky, const glm::dvec3& direction) {
    const double elevation = glm::dot(direction, sky.up);
    return elevation < 0.0 ? glm::dvec3(sky.ground)
                           : glm::mix(glm::dvec3(sky.horizon), glm::dvec3(sky.zenith), elevation);
}

/// A vector given along two axes at right angles to a normal, and along it.
struct Frame {
    glm::dvec3 normal;
    glm::dvec3 across;
    glm::dvec3 along;

    explicit Frame(const glm::dvec3& n)
        : normal(n),
          across(
              glm::normalize(glm::cross(n, std::abs(n.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0)))),
          along(glm::cross(n, across)) {}

    /// Unit, at an angle to the normal of that cosine, turned about it by that angle.
    glm::dvec3 at(double cosine, double angle) const {
        const double sine = std::sqrt(std::max(1.0 - cosine * cosine, 0.0));
        return normal * cosine + (across * std::cos(angle) + along * std::sin(angle)) * sine;
    }
};

constexpr int kSkyDirections = 256; // of each kind
constexpr double kGoldenAngle = 2.399963229728653;

/// Directions that are even under a cosine, for what is diffuse.
template <typename Take>
void forCosineDirections(const Frame& frame, const Take& take) {
    for (int i = 0; i < kSkyDirections; ++i) {
        take(frame.at(std::sqrt((i + 0.5) / kSkyDirections), i * kGoldenAngle));
    }
}

glm::dvec3 skyOnMatt(const scene::Sky& sky, const glm::dvec3& normal) {
    glm::dvec3 sum(0.0);
    forCosineDirections(Frame(normal), [&](const glm::dvec3& direction) { sum += skyAlong(sky, direction); });
    return sum / static_cast<double>(kSkyDirections);
}

/// What a metallic-roughness surface sends of a sky. Directions are even under a cosine, or what microfacets mirror. Each is
/// weighted by how likely either kind is to choose it (Veach and Guibas 1995, the balance heuristic).
glm::dvec3 skyOnGlossy(const scene::Sky& sky, const GlossyPoint& point) {
    const Frame frame(point.normal);
    const double alpha =
        std::pow(std::max(static_cast<double>(point.metallicRoughness.roughness), kMinTruthRoughness), 2.0);
    glm::dvec3 sum(0.0);
    const auto take = [&](const glm::dvec3& direction) {
        const double lambert = glm::dot(point.normal, direction);
        const glm::dvec3 halfway = glm::normalize(point.toCamera + direction);
        const double lean = glm::dot(point.normal, halfway);
        if (lambert <= 0.0) {
            return;
        }
        // Where an interpolated normal faces away from the camera, no microfacet mirrors some directions to it.
        if (lean <= 0.0) {
            sum += skyAlong(sky, direction) * diffuseShare(point, direction) / lambert;
            return;
        }
        const double spread = lean * lean * (alpha * alpha - 1.0) + 1.0;
        const double mirrored = alpha * alpha / (spread * spread) * lean /
                                (4.0 * std::max(glm::dot(point.toCamera, halfway), 1e-6));
        // Both densities, and pointShare(), are times pi.
        sum += skyAlong(sky, direction) * pointShare(point, direction) / (lambert + mirrored);
    };
    forCosineDirections(frame, take);
    for (int i = 0; i < kSkyDirections; ++i) {
        const double u = (i + 0.5) / kSkyDirections;
        const double cosine = std::sqrt((1.0 - u) / (1.0 + (alpha * alpha - 1.0) * u));
        const glm::dvec3 halfway = frame.at(cosine, i * kGoldenAngle);
        if (glm::dot(point.toCamera, halfway) > 0.0) {
            take(2.0 * glm::dot(point.toCamera, halfway) * halfway - point.toCamera);
        }
    }
    return sum / static_cast<double>(kSkyDirections);
}

/// The share of a light that its range and its cone let through (KHR_lights_punctual).
double shapeShare(const scene::PointLight& lamp, const glm::dvec3& toLight, double distance) {
    double share = 1.0;
    if (lamp.range) {
        share *= std::clamp(1.0 - std::pow(distance / *lamp.range, 4.0), 0.0, 1.0);
    }
    if (lamp.cone) {
        const double edge = std::cos(lamp.cone->outer);
        const double fall = std::max(std::cos(lamp.cone->inner) - edge, 0.001);
        const double cosine = -glm::dot(lamp.cone->direction, toLight) / distance;
        share *= std::pow(std::clamp((cosine - edge) / fall, 0.0, 1.0), 2.0);
    }
    return share;
}

/// Point lights, of each the share that `shareOf` gives for the way to it and its length.
template <typename ShareOf>
glm::dvec3 sumLights(const scene::Scene& scene, const scene::Camera& camera, const LitSurface& surface,
                     const ShareOf& shareOf) {
    glm::dvec3 light(0.0);
    int shadows = 0;
    for (const scene::PointLight& lamp : scene.lights) {
        const double reached = lamp.castsShadows && shadows < 4 ? surface.reached[shadows++] : 1.0;
        const glm::dvec3 toLight = (lamp.position - camera.position) - surface.fromCamera;
        const double squared = glm::dot(toLight, toLight);
        const double distance = std::sqrt(std::max(squared, 1e-30));
        const double halves = std::sqrt(squared) / lamp.halfDistance; // their squares may be no numbers
        light += glm::dvec3(lamp.color) * (reached * shapeShare(lamp, toLight, distance) *
                                           shareOf(toLight, distance) / (1.0 + halves * halves));
    }
    return light;
}

glm::dvec3 lightOnMatt(const scene::Scene& scene, const scene::Camera& camera, const LitSurface& surface) {
    const glm::dvec3 around = scene.sky ? skyOnMatt(*scene.sky, surface.normal) : glm::dvec3(scene.ambient);
    const glm::dvec3 lamps =
        sumLights(scene, camera, surface, [&](const glm::dvec3& toLight, double distance) {
            return std::max(glm::dot(surface.normal, toLight) / distance, 0.0);
        });
    return surface.baseColor * (surface.openness * around + lamps);
}

glm::dvec3 lightOnGlossy(const scene::Scene& scene, const scene::Camera& camera, const LitSurface& surface) {
    const GlossyPoint point{.baseColor = surface.baseColor,
                            .metallicRoughness = *surface.metallicRoughness,
                            .normal = surface.normal,
                            .toCamera = -glm::normalize(surface.fromCamera)};
    const glm::dvec3 around =
        scene.sky ? skyOnGlossy(*scene.sky, point) : glm::dvec3(scene.ambient) * ambientShare(point);
    const glm::dvec3 lamps =
        sumLights(scene, camera, surface, [&](const glm::dvec3& toLight, double distance) {
            return pointShare(point, toLight / distance);
        });
    return glm::min(surface.openness * around + lamps, kBrightest);
}

/// What a surface sends: light that it does not emit, and its emission. The sum is cut off before fog, air and blending.
glm::dvec3 withEmission(const glm::dvec3& light, const std::optional<glm::dvec3>& emission) {
    return emission ? glm::min(light + *emission, kBrightest) : light;
}

} // namespace

glm::dvec3 lightFrom(const scene::Scene& scene, const scene::Camera& camera, const LitSurface& surface) {
    return withEmission(surface.metallicRoughness ? lightOnGlossy(scene, camera, surface)
                                                  : lightOnMatt(scene, camera, surface),
                        surface.emission);
}

glm::dvec3 lightFrom(const scene::Scene& scene, const scene::Camera& camera, const SurfaceHit& hit,
                     const glm::dvec3& fromCamera, const glm::dvec4& reached) {
    const glm::dvec3 baseColor(hit.baseColor);
    if (hit.isUnlit) {
        return withEmission(baseColor, hit.emission);
    }
    return lightFrom(scene, camera,
                     {.baseColor = baseColor,
                      .metallicRoughness = hit.metallicRoughness,
                      .fromCamera = fromCamera,
                      .normal = hit.normal,
                      .openness = hit.openness,
                      .emission = hit.emission,
                      .reached = reached});
}

image::Rgba8 encode(const glm::dvec3& linear) {
    return {image::srgbOfLinear(linear.r), image::srgbOfLinear(linear.g), image::srgbOfLinear(linear.b), 255};
}

} // namespace cdr::measure
