#include <cdr/image/srgb.h>
#include <cdr/measure/truth/truth_light.h>
#include <cdr/measure/truth/truth_shine.h>

#include <algorithm>
#include <cmath>

namespace cdr::measure {

namespace {

/// Ambient light, and of each point light the share that `shareOf` gives for the way to it and its length.
template <typename ShareOf>
glm::dvec3 sumLights(const scene::Scene& scene, const scene::Camera& camera, const glm::dvec3& fromCamera,
                     const glm::dvec3& ambientShare, const ShareOf& shareOf) {
    glm::dvec3 light = glm::dvec3(scene.ambient) * ambientShare;
    for (const scene::PointLight& lamp : scene.lights) {
        const glm::dvec3 toLight = (lamp.position - camera.position) - fromCamera;
        const double squared = glm::dot(toLight, toLight);
        const double half2 = lamp.halfDistance * lamp.halfDistance;
        light += glm::dvec3(lamp.color) *
                 (shareOf(toLight, std::sqrt(std::max(squared, 1e-30))) * half2 / (half2 + squared));
    }
    return light;
}

} // namespace

glm::dvec3 lightFrom(const scene::Scene& scene, const scene::Camera& camera, const LitSurface& surface) {
    if (!surface.shine) {
        return surface.baseColor *
               sumLights(scene, camera, surface.fromCamera, glm::dvec3(1.0),
                         [&](const glm::dvec3& toLight, double distance) {
                             return std::max(glm::dot(surface.normal, toLight) / distance, 0.0);
                         });
    }
    const ShinyPoint point{.baseColor = surface.baseColor,
                           .shine = *surface.shine,
                           .normal = surface.normal,
                           .toCamera = -glm::normalize(surface.fromCamera)};
    const glm::dvec3 light = sumLights(
        scene, camera, surface.fromCamera, ambientShare(point),
        [&](const glm::dvec3& toLight, double distance) { return pointShare(point, toLight / distance); });
    return glm::min(light, kBrightest);
}

image::Rgba8 encode(const glm::dvec3& linear) {
    return {image::srgbOfLinear(linear.r), image::srgbOfLinear(linear.g), image::srgbOfLinear(linear.b), 255};
}

} // namespace cdr::measure
