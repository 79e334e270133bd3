#include "heading.h"

#include <cdr/scene/frustum.h>

#include <algorithm>
#include <cmath>

namespace cdr::viewer {

namespace {

/// Turned to the right about the vertical, seen from above clockwise.
glm::dvec3 turnedLevel(const glm::dvec3& level, double angle) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {c * level.x - s * level.z, 0.0, s * level.x + c * level.z};
}

} // namespace

glm::dvec3 Heading::forward() const {
    return std::cos(elevation) * level + glm::dvec3(0.0, std::sin(elevation), 0.0);
}

Heading headingOf(const scene::Camera& camera) {
    const glm::dvec3 forward = -camera.back;
    const double across = std::hypot(forward.x, forward.z);
    // Steeper than a heading may be, the picture's upper edge says which way is ahead.
    glm::dvec3 ahead = forward;
    if (across < 0.5 * std::cos(kSteepest)) {
        ahead = forward.y > 0.0 ? -camera.up : camera.up;
    }
    const double length = std::hypot(ahead.x, ahead.z);
    return {.level = length > 0.0 ? glm::dvec3(ahead.x, 0.0, ahead.z) / length : glm::dvec3(0.0, 0.0, -1.0),
            .elevation = std::clamp(std::atan2(forward.y, across), -kSteepest, kSteepest)};
}

Heading turned(const Heading& heading, double right, double up) {
    return {.level = glm::normalize(turnedLevel(heading.level, right)),
            .elevation = std::clamp(heading.elevation + up, -kSteepest, kSteepest)};
}

scene::Camera lookingAlong(const scene::Camera& camera, const Heading& heading) {
    return scene::lookAlong(camera, camera.position, heading.forward());
}

glm::dvec2 slopeOf(const scene::Camera& camera, const glm::dvec2& pixel, std::uint32_t width,
                   std::uint32_t height) {
    const double slope = footprintSlope(camera, height);
    return camera.lensShift + slope * glm::dvec2(pixel.x - 0.5 * width, 0.5 * height - pixel.y);
}

double footprintSlope(const scene::Camera& camera, std::uint32_t height) {
    return scene::frustumOf(camera, 1.0, height).footprintSlope;
}

} // namespace cdr::viewer
