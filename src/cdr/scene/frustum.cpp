#include <cdr/scene/frustum.h>

#include <cmath>

namespace cdr::scene {

Frustum frustumOf(const Camera& camera, double width, double height) {
    const double halfY = 0.5 * camera.fovY;
    const double tanY = std::tan(halfY);
    const double aspect = width / height;
    const double tanX = aspect * tanY;
    const double halfX = std::atan(tanX);
    return {.tanX = tanX,
            .tanY = tanY,
            .sinX = std::sin(halfX),
            .cosX = std::cos(halfX),
            .sinY = std::sin(halfY),
            .cosY = std::cos(halfY),
            .aspect = aspect,
            .footprintSlope = 2.0 * tanY / height};
}

} // namespace cdr::scene
