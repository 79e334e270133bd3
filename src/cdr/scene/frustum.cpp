#include <cdr/scene/frustum.h>

#include <cmath>

namespace cdr::scene {

Frustum frustumOf(const Camera& camera, double width, double height) {
    const double halfY = 0.5 * camera.fovY;
    const double tanY = std::tan(halfY);
    const double aspect = width / height;
    const double tanX = aspect * tanY;
    const double halfX = std::atan(tanX);
    Frustum frustum{.tanX = tanX,
                    .tanY = tanY,
                    .centre = camera.lensShift,
                    .sinX = std::sin(halfX),
                    .cosX = std::cos(halfX),
                    .sinY = std::sin(halfY),
                    .cosY = std::cos(halfY),
                    .aspect = aspect,
                    .footprintSlope = 2.0 * tanY / height};
    if (camera.lensShift != glm::dvec2(0.0)) {
        frustum.cosX = std::cos(std::atan(tanX + std::abs(camera.lensShift.x)));
        frustum.sinX = tanX * frustum.cosX;
        frustum.cosY = std::cos(std::atan(tanY + std::abs(camera.lensShift.y)));
        frustum.sinY = tanY * frustum.cosY;
    }
    return frustum;
}

} // namespace cdr::scene
