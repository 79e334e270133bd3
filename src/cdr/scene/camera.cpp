#include <cdr/base/error.h>
#include <cdr/scene/camera.h>

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace cdr::scene {

namespace {

bool isFinite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

} // namespace

Camera lookAt(Camera camera, const glm::dvec3& eye, const glm::dvec3& target) {
    const glm::dvec3 toEye = eye - target;
    const double distance = glm::length(toEye);
    if (!isFinite(eye) || !isFinite(target) || !std::isfinite(distance)) {
        throw base::InputError("camera: eye and target must be finite");
    }
    if (distance <= 0.0) {
        throw base::InputError("camera: eye and target are the same point");
    }
    camera.position = eye;
    camera.back = toEye / distance;
    // World z stands in for up where the view runs along y and y would give no right.
    const bool alongY = std::abs(camera.back.y) > 1.0 - 1e-12;
    const glm::dvec3 worldUp = alongY ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(0.0, 1.0, 0.0);
    camera.right = glm::normalize(glm::cross(worldUp, camera.back));
    camera.up = glm::cross(camera.back, camera.right);
    return camera;
}

void requireUsable(const Camera& camera) {
    if (!std::isfinite(camera.nearView) || camera.nearView <= 0.0) {
        throw base::InputError(fmt::format("near must be finite and above 0, not {}", camera.nearView));
    }
    if (!std::isfinite(camera.farView) || camera.farView <= camera.nearView) {
        throw base::InputError(
            fmt::format("far must be finite and beyond near ({}), not {}", camera.nearView, camera.farView));
    }
    if (!std::isfinite(camera.fovY) || camera.fovY <= 0.0 || camera.fovY >= std::numbers::pi) {
        throw base::InputError(fmt::format("field of view must lie between 0 and 180 degrees, not {}",
                                           camera.fovY * 180.0 / std::numbers::pi));
    }
    if (!isFinite(camera.position)) {
        throw base::InputError("camera: position must be finite");
    }
}

} // namespace cdr::scene
