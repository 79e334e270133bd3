#include <cdr/scene/animation/node_camera.h>

namespace cdr::scene {

std::optional<Camera> carriedBy(const glm::dmat4& toWorld, Camera camera) {
    const glm::dvec3 up(toWorld[1]);
    const glm::dvec3 back(toWorld[2]);
    const glm::dvec3 right = glm::cross(up, back);
    if (!(glm::length(right) > 1e-9 * glm::length(up) * glm::length(back))) {
        return std::nullopt;
    }
    camera.position = glm::dvec3(toWorld[3]);
    camera.right = glm::normalize(right);
    camera.back = glm::normalize(back);
    camera.up = glm::cross(camera.back, camera.right);
    return camera;
}

} // namespace cdr::scene
