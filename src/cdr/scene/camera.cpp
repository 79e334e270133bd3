#include <cdr/base/format_error.h>
#include <cdr/depth/cascade.h>
#include <cdr/scene/camera.h>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <string>

namespace cdr::scene {

namespace {

bool isFinite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// More than roundings can move the length of a normalised vector away from 1.
constexpr double kUnitTolerance = 1e-15;

const glm::dvec3& requireFinite(const glm::dvec3& v, const char* what) {
    if (!isFinite(v)) {
        throw base::inputError("camera: {} must be finite", what);
    }
    return v;
}

/// `v` at length 1. Unchanged if only roundings separate its length from 1, so that normalising again changes
/// nothing.
glm::dvec3 unit(const glm::dvec3& v, const char* what) {
    requireFinite(v, what);
    if (std::abs(glm::dot(v, v) - 1.0) <= kUnitTolerance) {
        return v;
    }
    const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (largest <= 0.0) {
        throw base::inputError("camera: {} must not be zero", what);
    }
    const glm::dvec3 scaled = v / largest; // else squares of tiny and huge numbers leave the range
    return scaled / glm::length(scaled);
}

/// Axes that were computed in float32 are unit ones too.
void requireUnit(const glm::dvec3& axis, const char* name) {
    constexpr double kMaxOff = 1e-5;
    const double length = glm::length(axis);
    if (!(std::abs(length - 1.0) <= kMaxOff)) {
        throw base::inputError("camera: its axis '{}' must have the length 1, not {}", name, length);
    }
}

/// @param camera with a field of view that is usable
void requireShift(const Camera& camera) {
    const double most = kMaxLensShift * std::tan(0.5 * camera.fovY);
    const glm::dvec2& shift = camera.lensShift;
    if (!(std::abs(shift.x) <= most && std::abs(shift.y) <= most)) {
        throw base::inputError("the shift of this lens must lie between {} and {}, not {} and {}", -most,
                               most, shift.x, shift.y);
    }
}

/// Right and up without roll for a camera whose back is set.
Camera level(Camera camera) {
    // Along the y axis, world z takes the place of y as up.
    const bool alongY = std::abs(camera.back.y) > 1.0 - 1e-12;
    const glm::dvec3 worldUp = alongY ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(0.0, 1.0, 0.0);
    camera.right = glm::normalize(glm::cross(worldUp, camera.back));
    camera.up = glm::cross(camera.back, camera.right);
    return camera;
}

} // namespace

Camera lookAt(Camera camera, const glm::dvec3& eye, const glm::dvec3& target) {
    const glm::dvec3 toEye = eye - target;
    if (!isFinite(eye) || !isFinite(target)) {
        throw base::InputError("camera: eye and target must be finite");
    }
    if (toEye == glm::dvec3(0.0)) {
        throw base::InputError("camera: eye and target are the same point");
    }
    camera.position = eye;
    const double distance = glm::length(toEye);
    camera.back = std::isnormal(distance) ? toEye / distance : unit(toEye, "way from target to eye");
    return level(camera);
}

Camera lookAlong(Camera camera, const glm::dvec3& eye, const glm::dvec3& forward) {
    camera.position = requireFinite(eye, "eye");
    camera.back = -unit(forward, "view direction");
    return level(camera);
}

Camera lookAlong(Camera camera, const glm::dvec3& eye, const glm::dvec3& forward, const glm::dvec3& up) {
    camera.position = requireFinite(eye, "eye");
    camera.back = -unit(forward, "view direction");
    camera.up = unit(up, "up");
    if (std::abs(glm::dot(camera.up, camera.back)) > kUnitTolerance) {
        glm::dvec3 right = glm::cross(camera.up, camera.back);
        // Below this, roundings would decide the direction.
        constexpr double kMinSine = 1e-9;
        if (glm::length(right) < kMinSine) {
            throw base::InputError("camera: up lies along the view");
        }
        // Roundings are a large share of a short vector, so make it orthogonal once more.
        right = glm::normalize(right);
        right -= glm::dot(right, camera.back) * camera.back;
        camera.up = unit(glm::cross(camera.back, right), "up");
    }
    camera.right = glm::cross(camera.up, camera.back);
    return camera;
}

Camera canonical(const Camera& camera) {
    Camera said = lookAlong(camera, camera.position, -camera.back);
    if (said.right != camera.right || said.up != camera.up) {
        said = lookAlong(camera, camera.position, -camera.back, camera.up);
    }
    said.fovY = radiansOf(degreesOf(camera.fovY));
    return said;
}

bool isLevel(const Camera& camera) {
    const Camera said = lookAlong(camera, camera.position, -camera.back);
    return said.right == camera.right && said.up == camera.up && said.back == camera.back;
}

double radiansOf(double degrees) {
    return degrees * std::numbers::pi / 180.0;
}

double degreesOf(double radians) {
    const double degrees = radians * 180.0 / std::numbers::pi;
    // Of the values that give these radians, the one with the fewest digits.
    for (int digits = 3; digits <= 17; ++digits) {
        const std::string text = fmt::format("{:.{}g}", degrees, digits);
        double shorter = 0.0;
        std::from_chars(text.data(), text.data() + text.size(), shorter);
        if (radiansOf(shorter) == radians) {
            return shorter;
        }
    }
    // Each direction rounds twice, so the value that gives these radians, if there is one, is a neighbour.
    double nearest = degrees;
    double below = degrees;
    double above = degrees;
    for (int step = 0; step < 4 && radiansOf(nearest) != radians; ++step) {
        below = std::nextafter(below, 0.0);
        above = std::nextafter(above, HUGE_VAL);
        for (const double candidate : {below, above}) {
            if (std::abs(radiansOf(candidate) - radians) < std::abs(radiansOf(nearest) - radians)) {
                nearest = candidate;
            }
        }
    }
    return nearest;
}

Camera withLens(Camera camera, const LensEdges& edges) {
    const glm::dvec2 size(edges.right - edges.left, edges.up - edges.down);
    if (!(size.x > 0.0 && size.y > 0.0 && std::isfinite(size.x) && std::isfinite(size.y))) {
        throw base::inputError("the edges of a lens must be finite and in order, not {} to {} and {} to {}",
                               edges.left, edges.right, edges.down, edges.up);
    }
    camera.fovY = 2.0 * std::atan(0.5 * size.y);
    camera.lensShift = 0.5 * glm::dvec2(edges.left + edges.right, edges.down + edges.up);
    requireShift(camera);
    return camera;
}

void requireUsable(const Camera& camera) {
    if (!std::isfinite(camera.nearView) || camera.nearView <= 0.0) {
        throw base::inputError("near must be finite and above 0, not {}", camera.nearView);
    }
    if (!std::isfinite(camera.farView) || camera.farView <= camera.nearView) {
        throw base::inputError("far must be finite and beyond near ({}), not {}", camera.nearView,
                               camera.farView);
    }
    depth::requireRange(camera.nearView, camera.farView);
    if (!std::isfinite(camera.fovY) || camera.fovY <= 0.0 || camera.fovY >= std::numbers::pi) {
        throw base::inputError("field of view must lie between 0 and 180 degrees, not {}",
                               camera.fovY * 180.0 / std::numbers::pi);
    }
    if (camera.fovY < kMinFovY) {
        throw base::inputError(
            "field of view must be at least 1e-28 degrees, for which float32 has a projection, not {}",
            camera.fovY * 180.0 / std::numbers::pi);
    }
    requireShift(camera);
    if (!isFinite(camera.position)) {
        throw base::InputError("camera: position must be finite");
    }
    if (!isFinite(camera.right) || !isFinite(camera.up) || !isFinite(camera.back)) {
        throw base::InputError("camera: its axes must be finite");
    }
    requireUnit(camera.right, "right");
    requireUnit(camera.up, "up");
    requireUnit(camera.back, "back");
}

} // namespace cdr::scene
