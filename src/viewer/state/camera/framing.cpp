#include "framing.h"

#include <cdr/scene/box_tree.h>
#include <cdr/scene/frustum.h>

#include <algorithm>

namespace cdr::viewer {

Ball ballOf(const scene::Instances& instances, std::uint32_t object) {
    scene::Box box;
    for (std::size_t i = 0; i < instances.size(); ++i) {
        if (instances.object[i] == object) {
            box.add(instances.position(i), static_cast<double>(instances.radius[i]));
        }
    }
    if (box.isEmpty()) {
        return {};
    }
    Ball ball{.centre = box.centre()};
    for (std::size_t i = 0; i < instances.size(); ++i) {
        if (instances.object[i] == object) {
            ball.radius = std::max(ball.radius,
                                   glm::distance(ball.centre, instances.position(i)) + instances.radius[i]);
        }
    }
    return ball;
}

scene::Camera framed(const scene::Camera& camera, const Ball& ball, double aspect) {
    const scene::Frustum frustum = scene::frustumOf(camera, aspect, 1.0);
    const double away = ball.radius / std::min(frustum.sinX, frustum.sinY);
    // Near enough to be drawn, far enough not to be cut open.
    const double distance =
        std::clamp(away, ball.radius + 2.0 * camera.nearView,
                   std::max(camera.farView - ball.radius, ball.radius + 2.0 * camera.nearView));
    scene::Camera moved = camera;
    const glm::dvec3 throughMiddle =
        camera.lensShift.x * camera.right + camera.lensShift.y * camera.up - camera.back;
    moved.position = ball.centre - distance * throughMiddle;
    return moved;
}

} // namespace cdr::viewer
