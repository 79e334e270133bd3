#include "lens_zoom.h"

#include "heading.h"

#include <algorithm>
#include <cmath>

namespace cdr::viewer {

namespace {

/// The heading from which a level camera sees the world direction `target` at the slopes `seen`.
Heading headingToSee(const glm::dvec3& target, const glm::dvec2& seen, const Heading& old) {
    const double stretch = std::sqrt(1.0 + glm::dot(seen, seen));
    // target.y = (seen.y cos e + sin e) / stretch, solved for the elevation e.
    const double sine = stretch * target.y / std::sqrt(1.0 + seen.y * seen.y);
    const double elevation = std::asin(std::clamp(sine, -1.0, 1.0)) - std::atan(seen.y);
    const double across = std::hypot(target.x, target.z);
    if (!(across > 0.0)) {
        return {.level = old.level, .elevation = std::clamp(elevation, -kSteepest, kSteepest)};
    }
    // Seen from above, the target lies this far to the right of where the camera looks.
    const double aside = std::atan2(seen.x, std::cos(elevation) - seen.y * std::sin(elevation));
    const Heading atTarget{.level = glm::dvec3(target.x, 0.0, target.z) / across, .elevation = 0.0};
    return turned(atTarget, -aside, elevation);
}

} // namespace

scene::Camera setLens(const scene::Camera& camera, double fovDegrees) {
    scene::Camera set = camera;
    const double now = scene::degreesOf(camera.fovY); // of a file, beyond the limits: no jump to them
    set.fovY = scene::radiansOf(
        std::clamp(fovDegrees, std::min(kNarrowestDegrees, now), std::max(kWidestDegrees, now)));
    set.lensShift *=
        std::tan(0.5 * set.fovY) / std::tan(0.5 * camera.fovY); // in halves of the picture it stays
    return set;
}

scene::Camera zoomLens(const scene::Camera& camera, const CameraInput& input) {
    const double narrowing = kZoomPerNotch * (input.lens + 10.0 * input.axes.zoom * input.seconds);
    const scene::Camera zoomed = setLens(camera, scene::degreesOf(camera.fovY) * std::exp(-narrowing));
    if (narrowing == 0.0 || zoomed.fovY == camera.fovY) {
        return camera;
    }
    // A gamepad zooms to the middle; its cursor lies anywhere.
    if (input.lens == 0.0) {
        return zoomed;
    }
    const glm::dvec2 before = slopeOf(camera, input.cursor, input.extent.width, input.extent.height);
    const glm::dvec2 after = slopeOf(zoomed, input.cursor, input.extent.width, input.extent.height);
    const glm::dvec3 ray = before.x * camera.right + before.y * camera.up - camera.back;
    return lookingAlong(zoomed, headingToSee(glm::normalize(ray), after, headingOf(camera)));
}

} // namespace cdr::viewer
