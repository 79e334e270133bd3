#include <cdr/measure/truth_light.h>

#include <algorithm>
#include <cmath>

namespace cdr::measure {

glm::dvec3 lightAt(const scene::Scene& scene, const scene::Camera& camera, const glm::dvec3& fromCamera,
                   const glm::dvec3& normal) {
    glm::dvec3 light(scene.ambient);
    for (const scene::PointLight& lamp : scene.lights) {
        const glm::dvec3 toLight = (lamp.position - camera.position) - fromCamera;
        const double squared = glm::dot(toLight, toLight);
        const double lambert = std::max(glm::dot(normal, toLight) / std::sqrt(std::max(squared, 1e-30)), 0.0);
        const double half2 = lamp.halfDistance * lamp.halfDistance;
        light += glm::dvec3(lamp.color) * (lambert * half2 / (half2 + squared));
    }
    return light;
}

} // namespace cdr::measure
