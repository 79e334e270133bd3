#include "moving_lights.h"

#include "lights.h"

namespace cdr::scene::gltf {

MovingLights::MovingLights(const GltfImport& import, std::size_t chosen, const FrameClock& clock)
    : m_animation(import.animation),
      m_chosen(chosen),
      m_clock(clock) {
    const std::vector<bool> moved = movedBy(m_animation->rig, m_animation->animations[chosen]);
    for (std::size_t i = 0; i < import.lights.size(); ++i) {
        const auto node = import.rigNodeOf[static_cast<std::size_t>(import.lights[i].node)];
        if (node && moved[*node]) {
            m_atRest.push_back(import.lights[i]);
            m_nodes.push_back(*node);
            m_moving.push_back(static_cast<std::uint32_t>(i));
        }
    }
}

std::vector<GltfLight> MovingLights::lightsAt(std::uint32_t frame) const {
    const Pose pose = poseAt(m_animation->rig, &m_animation->animations[m_chosen], m_clock.secondsAt(frame));
    std::vector<GltfLight> lights = m_atRest;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        if (const auto carried = carriedBy(pose.toWorld[m_nodes[i]], lights[i])) {
            lights[i] = *carried;
        }
    }
    return lights;
}

void MovingLights::place(std::span<GltfLight> lights, std::uint32_t frame) const {
    const std::vector<GltfLight> placed = lightsAt(frame);
    for (std::size_t i = 0; i < placed.size(); ++i) {
        lights[m_moving[i]] = placed[i];
    }
}

void MovingLights::addTo(SceneMotion& motion, const glm::dvec3& centre, double radius) const {
    motion.lights = m_moving;
    motion.lightsAt = [lights = *this, centre, radius](std::uint32_t frame) {
        std::vector<PointLight> made;
        for (const GltfLight& light : lights.lightsAt(frame)) {
            made.push_back(pointLightOf(light, centre, radius));
        }
        return made;
    };
}

} // namespace cdr::scene::gltf
