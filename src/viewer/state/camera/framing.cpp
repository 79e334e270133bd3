#include "framing.h"

#include <cdr/scene/frustum.h>

#include <algorithm>
#include <cstddef>

namespace cdr::viewer {

Ball ballOf(const scene::Instances& instances, std::uint32_t object) {
    return scene::sphereAround(instances, [&](std::size_t i) { return instances.object[i] == object; });
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
