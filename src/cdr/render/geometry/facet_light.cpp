#include <cdr/render/geometry/facet_light.h>
#include <cdr/render/view_transform.h>

#include <algorithm>
#include <iterator>

namespace cdr::render {

FacetLight::FacetLight(const scene::Scene& scene, const scene::Camera& camera)
    : m_ambientLight(scene.ambient) {
    std::transform(scene.lights.begin(), scene.lights.end(), std::back_inserter(m_lights),
                   [&](const scene::PointLight& light) { return broughtNear(light, camera); });
}

void FacetLight::turn(std::size_t facet, const glm::vec3& baseColor, Reflection reflection) {
    const bool isUnlit = reflection == Reflection::unlit;
    const glm::vec3 albedo = glm::min(baseColor, 1.0f); // as a G-buffer holds it
    m_ambient[facet] = isUnlit ? albedo : albedo * m_ambientLight;
    m_albedo[facet] = isUnlit ? glm::vec3(0.0f) : albedo;
}

void FacetLight::write(std::size_t facet, const glm::dvec3& normal, double height, const glm::dvec3& origin,
                       glm::vec3* into) const {
    *into++ = m_ambient[facet];
    for (const scene::PointLight& light : m_lights) {
        const double above = glm::dot(normal, light.position - origin) - height;
        *into++ = m_albedo[facet] * light.color * static_cast<float>(std::max(above, 0.0));
    }
    if (m_lights.empty()) {
        *into = glm::vec3(0.0f);
    }
}

std::array<glm::vec4, shaders::kPushedLights> pushedLights(const scene::Scene& scene,
                                                           const scene::Camera& camera, double anchorView) {
    std::array<glm::vec4, shaders::kPushedLights> pushed{};
    std::ranges::transform(scene.lights, pushed.begin(), [&](const scene::PointLight& light) {
        const glm::dvec3 view = camera.toView(broughtNear(light, camera).position);
        return glm::vec4(view.x, view.y, -view.z - anchorView, makeLightRecord(light, camera).position.w);
    });
    return pushed;
}

} // namespace cdr::render
