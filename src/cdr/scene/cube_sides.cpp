#include <cdr/scene/cube_sides.h>

#include <numbers>

namespace cdr::scene {

namespace {

/// Axes are copied, since a turn by a right angle needs no rounding.
Camera sideOf(const Camera& camera, const glm::dvec3& right, const glm::dvec3& up, const glm::dvec3& back) {
    Camera side = camera;
    side.right = right;
    side.up = up;
    side.back = back;
    side.fovY = std::numbers::pi / 2.0;
    side.lensShift = glm::dvec2(0.0);
    return side;
}

} // namespace

std::array<Camera, 6> cubeSides(const Camera& camera) {
    requireUsable(camera);
    const glm::dvec3& right = camera.right;
    const glm::dvec3& up = camera.up;
    const glm::dvec3& back = camera.back;
    return {sideOf(camera, back, up, -right),  sideOf(camera, -back, up, right),
            sideOf(camera, right, back, -up),  sideOf(camera, right, -back, up),
            sideOf(camera, -right, up, -back), sideOf(camera, right, up, back)};
}

} // namespace cdr::scene
