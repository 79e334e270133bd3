#include "framing.h"

#include <cdr/scene/frustum.h>

#include <algorithm>
#include <limits>

namespace cdr::viewer {

Ball ballOf(const scene::Instances& instances, std::uint32_t object) {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    glm::dvec3 low(kFar);
    glm::dvec3 high(-kFar);
    for (std::size_t i = 0; i < instances.size(); ++i) {
        if (instances.object[i] == object) {
            low = glm::min(low, instances.position(i) - static_cast<double>(instances.radius[i]));
            high = glm::max(high, instances.position(i) + static_cast<double>(instances.radius[i]));
        }
    }
    if (low.x > high.x) {
        return {};
    }
    Ball ball{.centre = 0.5 * (low + high)};
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
