#include "views.h"

#include <cdr/scene/sphere_around.h>

#include <cmath>
#include <numbers>

namespace cdr::experiments {

std::vector<scene::Camera> viewsAround(const scene::Scene& scene, const scene::Camera& own,
                                       std::uint32_t count, const std::optional<glm::dvec3>& up) {
    std::vector<scene::Camera> views{own};
    const scene::Sphere all = scene::sphereAround(scene.instances);
    const glm::dvec3 middle = all.centre;
    const double distance = glm::length(own.position - middle);
    if (all.radius == 0.0 || !std::isfinite(distance) || distance == 0.0) {
        return views;
    }
    // A spiral on the sphere: every view takes the same share of it.
    const double turn = std::numbers::pi * (3.0 - std::sqrt(5.0));
    for (std::uint32_t i = 1; i < count; ++i) {
        const double height = 1.0 - (2.0 * i - 1.0) / (count - 1.0);
        const double across = std::sqrt(1.0 - height * height);
        const glm::dvec3 side(across * std::sin(turn * i), height, across * std::cos(turn * i));
        const glm::dvec3 eye = middle + distance * side;
        views.push_back(up ? scene::lookAlong(own, eye, middle - eye, *up) : scene::lookAt(own, eye, middle));
    }
    return views;
}

} // namespace cdr::experiments
