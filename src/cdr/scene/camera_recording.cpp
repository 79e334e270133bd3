#include <cdr/base/error.h>
#include <cdr/scene/camera_recording.h>

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>

namespace cdr::scene {

namespace {

/// The camera's rotation from view to world space.
glm::dquat turnOf(const Camera& camera) {
    return glm::normalize(glm::quat_cast(glm::dmat3(camera.right, camera.up, camera.back)));
}

double betweenLogs(double a, double b, double share) {
    return a == b ? a : std::exp(std::lerp(std::log(a), std::log(b), share));
}

/// Linear from the nearer end, so that the difference is rounded and not the position.
glm::dvec3 between(const glm::dvec3& a, const glm::dvec3& b, double share) {
    return share < 0.5 ? a + share * (b - a) : b - (1.0 - share) * (b - a);
}

/// Linear in halves of the picture's height, so that it stays within its limit while the lens zooms.
glm::dvec2 shiftBetween(const Camera& a, const Camera& b, double share, double fovY) {
    if (a.lensShift == b.lensShift && a.fovY == b.fovY) {
        return a.lensShift;
    }
    const auto inHalves = [](const Camera& camera) { return camera.lensShift / std::tan(0.5 * camera.fovY); };
    return glm::mix(inHalves(a), inHalves(b), share) * std::tan(0.5 * fovY);
}

Camera between(const Camera& a, const Camera& b, double share) {
    const glm::dmat3 axes = glm::mat3_cast(glm::slerp(turnOf(a), turnOf(b), share));
    Camera camera{.position = between(a.position, b.position, share),
                  .right = axes[0],
                  .up = axes[1],
                  .back = axes[2],
                  .fovY = betweenLogs(a.fovY, b.fovY, share),
                  .nearView = betweenLogs(a.nearView, b.nearView, share),
                  .farView = betweenLogs(a.farView, b.farView, share)};
    camera.lensShift = shiftBetween(a, b, share, camera.fovY);
    if (a.right == b.right && a.up == b.up && a.back == b.back) {
        camera.right = a.right;
        camera.up = a.up;
        camera.back = a.back;
    }
    return canonical(camera);
}

void requireCameras(const CameraRecording& recording) {
    if (recording.cameras.empty()) {
        throw base::InputError("the camera path holds no camera");
    }
}

} // namespace

bool record(CameraRecording& recording, double seconds, const Camera& camera) {
    requireUsable(camera);
    const bool isLater = recording.cameras.empty() ? seconds >= 0.0 : seconds > recording.seconds();
    if (!isLater || !std::isfinite(seconds) || recording.cameras.size() >= kMaxRecordedCameras) {
        return false;
    }
    recording.cameras.push_back({.seconds = seconds, .camera = canonical(camera)});
    return true;
}

Camera cameraAt(const CameraRecording& recording, double seconds) {
    requireCameras(recording);
    const auto& cameras = recording.cameras;
    const auto after = std::ranges::upper_bound(cameras, seconds, {}, &RecordedCamera::seconds);
    if (after == cameras.begin()) {
        return cameras.front().camera;
    }
    const RecordedCamera& before = *std::prev(after);
    if (after == cameras.end() || seconds == before.seconds) {
        return before.camera;
    }
    return between(before.camera, after->camera,
                   (seconds - before.seconds) / (after->seconds - before.seconds));
}

CameraPath pathOf(const CameraRecording& recording, std::uint32_t frames) {
    requireCameras(recording);
    if (frames == 0) {
        throw base::InputError("a camera path needs at least one frame");
    }
    return {.frames = frames, .at = [recording, frames](std::uint32_t frame) {
                const auto& cameras = recording.cameras;
                const std::uint32_t number = frame % frames;
                if (frames == cameras.size()) { // as recorded, to the bit
                    return cameras[number].camera;
                }
                const double share = frames > 1 ? static_cast<double>(number) / (frames - 1) : 0.0;
                const double begin = cameras.front().seconds;
                return cameraAt(recording, std::lerp(begin, recording.seconds(), share));
            }};
}

} // namespace cdr::scene
