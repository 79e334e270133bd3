#include <scenes/orbit/path.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cdr::scenes {

namespace {

/// The aim's share of its way, to the power that the lens has: beyond 1 it comes closer than the lens.
constexpr double kAimPower = 1.5;

/// The unit vector `share` of the angle on from `a` to `b`, both unit.
glm::dvec3 between(const glm::dvec3& a, const glm::dvec3& b, double share) {
    const double angle = std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
    if (angle < 1e-9) {
        return b;
    }
    return (std::sin((1.0 - share) * angle) * a + std::sin(share * angle) * b) / std::sin(angle);
}

} // namespace

scene::CameraPath zoomPath(const ZoomPath& zoom) {
    return {.frames = zoom.frames, .at = [zoom](std::uint32_t frame) {
                const double steps = std::max(zoom.frames, 2u) - 1.0;
                const double share = (frame % zoom.frames) / steps;
                const double degrees =
                    zoom.widestDegrees * std::pow(zoom.narrowestDegrees / zoom.widestDegrees, share);
                const double away = std::max(0.0, (degrees - zoom.narrowestDegrees) /
                                                      (zoom.widestDegrees - zoom.narrowestDegrees));
                const glm::dvec3 lastAim = glm::normalize(zoom.target - zoom.eye);
                const glm::dvec3 aim = between(lastAim, zoom.firstAim, std::pow(away, kAimPower));
                const scene::Camera lens{.fovY = degrees * std::numbers::pi / 180.0,
                                         .nearView = zoom.nearView,
                                         .farView = zoom.farView};
                return scene::lookAt(lens, zoom.eye, zoom.eye + glm::distance(zoom.eye, zoom.target) * aim);
            }};
}

} // namespace cdr::scenes
