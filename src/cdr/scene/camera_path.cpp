#include <cdr/base/error.h>
#include <cdr/scene/camera_path.h>

#include <cmath>
#include <numbers>

namespace cdr::scene {

namespace {

double angleAt(std::uint32_t frame, std::uint32_t frames) {
    return 2.0 * std::numbers::pi * static_cast<double>(frame % frames) / frames;
}

void requireFrames(std::uint32_t frames) {
    if (frames == 0) {
        throw base::InputError("a camera path needs at least one frame");
    }
}

} // namespace

CameraPath stillPath(const Camera& camera) {
    return {.frames = 1, .at = [camera](std::uint32_t) { return camera; }};
}

CameraPath orbitPath(const Camera& lens, const glm::dvec3& target, double radius, std::uint32_t frames) {
    requireFrames(frames);
    return {.frames = frames, .at = [=](std::uint32_t frame) {
                const double angle = angleAt(frame, frames);
                const glm::dvec3 eye = target + radius * glm::dvec3(std::sin(angle), 0.0, std::cos(angle));
                return lookAt(lens, eye, target);
            }};
}

CameraPath turnPath(const Camera& lens, const glm::dvec3& eye, std::uint32_t frames) {
    requireFrames(frames);
    return {.frames = frames, .at = [=](std::uint32_t frame) {
                const double angle = angleAt(frame, frames);
                return lookAt(lens, eye, eye - glm::dvec3(std::sin(angle), 0.0, std::cos(angle)));
            }};
}

} // namespace cdr::scene
